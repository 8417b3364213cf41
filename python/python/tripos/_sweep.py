"""Sweeps: runs of a scene from many starts or with many parameters, on one machine or on a cluster of Dask."""

from __future__ import annotations

import contextlib
import csv
import dataclasses
import hashlib
import io
import json
import operator
import os
import pathlib
import re
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np

from . import _tripos
from ._arguments import Path, plain
from ._commands import Option, UntrustedRunWarning, failure, run_command, warn_of
from ._progress import bar
from ._scene import Scene

#: Values that vary: texts as `tripos sweep --over` takes them, or the values of each number by its name.
Over = Union[str, Sequence[str], Mapping[str, Union[float, Iterable[float]]]]
#: Columns that hold texts.
TEXTS = ("stop", "warning", "reason")
#: Options of the command that a sweep in Python does not take, and what to use in their place.
REFUSED = {
    **dict.fromkeys(("out", "json", "resume", "overwrite"), "save the returned table by table.save(path)"),
    "shard": "give the number of blocks as `blocks`, or call tripos.run_block",
    "threads": "give it to tripos.sweep, tripos.sweep_frame or tripos.run_block",
}
#: So many blocks that the first one has no point: it checks the request alone.
CHECK_BLOCKS = 1 << 40
#: Number of blocks of a sweep here with a bar.
BLOCKS_OF_BAR = 20


class SweepTable:
    """Table of a sweep: a row for each point, in the order of the points."""

    def __init__(self, text: str) -> None:
        #: The table as CSV: the same bytes as the file of `tripos sweep`.
        self.csv = text
        header = next(csv.reader([text[: text.index("\n")]]))
        #: Names of the columns.
        self.names: list[str] = header

    @classmethod
    def joined(cls, tables: Sequence[str]) -> SweepTable:
        """Table of all blocks of a sweep, from the text of each block in their order."""
        header = tables[0][: tables[0].index("\n") + 1]
        return cls(header + "".join(table[len(header) :] for table in tables))

    def __len__(self) -> int:
        return sum(1 for _ in csv.reader(io.StringIO(self.csv))) - 1

    def __getitem__(self, name: str) -> Any:
        """Values of a column: numbers as an array, with NaN in empty cells; texts of `stop`, `warning` and `reason` as a list."""
        if name not in self.names:
            raise KeyError(f"the sweep has no column {name!r}; it has {', '.join(self.names)}")
        at = self.names.index(name)
        rows = csv.reader(io.StringIO(self.csv))
        next(rows)
        return values_of(name, (row[at] for row in rows))

    def __repr__(self) -> str:
        return f"<tripos.SweepTable: {len(self)} rows, {len(self.names)} columns>"

    def _repr_html_(self) -> str:
        html: str = self.to_pandas()._repr_html_()
        return html

    def to_pandas(self) -> Any:
        """The table as a `pandas.DataFrame`."""
        return frame_of(self.csv)

    def save(self, path: Path) -> None:
        """Writes the table to a file: Parquet if its name ends in `.parquet`, else CSV."""
        if os.fspath(path).endswith(".parquet"):
            self.to_pandas().to_parquet(path, index=False)
        else:
            pathlib.Path(path).write_text(self.csv, encoding="utf-8", newline="")


@dataclasses.dataclass(frozen=True)
class SweepRequest:
    """Everything that a worker needs to run blocks of a sweep: texts, values and settings, but no file."""

    #: Text of each file by its path in the folder of the sweep.
    files: dict[str, str]
    #: Path of the scene in this folder.
    scene: str
    #: Values that vary, as `tripos sweep --over` takes them.
    over: tuple[str, ...]
    #: Other options of `tripos sweep`.
    options: dict[str, Option]

    @classmethod
    def of(cls, scene: Scene, over: Over, **options: Option) -> SweepRequest:
        """Request for a sweep of a scene, with the arguments of `sweep`. The files beside its model go with it."""
        for name in options:
            if name.strip("_") in REFUSED:
                raise _tripos.RequestError(f"`{name}` is no option of a sweep in Python: {REFUSED[name.strip('_')]}")
        model = scene.model
        if scene._text:
            files, path = {"model.toml": model.text, "scenes/scene.toml": scene._text}, "scenes/scene.toml"
        else:
            files, path = files_of(model.path.resolve(), scene.path.resolve())
        if isinstance(over, str):
            values = [over]
        elif isinstance(over, Mapping):
            values = [f"{name}={listed(name, numbers)}" for name, numbers in over.items()]
        else:
            values = list(over)
        # Numbers that `Scene.set` changed are columns with one value, unless they vary.
        varied = {text.partition("=")[0].strip() for text in values}
        values = [f"{name}={value!r}" for name, value in scene._set.items() if name not in varied] + values
        return cls(files, path, tuple(values), options)

    @property
    def key(self) -> str:
        """Text that is the same for the same sweep only."""
        parts = json.dumps(dataclasses.asdict(self), sort_keys=True, default=os.fspath)
        return hashlib.sha256(parts.encode()).hexdigest()[:24]


def listed(name: str, numbers: Union[float, Iterable[float]]) -> str:
    """Values of a number as `tripos sweep --over` takes them; a single value is a list of one."""
    if isinstance(numbers, (str, bytes)):
        advice = f'give numbers, or the text form over="{name}=0:1:11"'
        raise _tripos.RequestError(f"the values of `{name}` are the text {numbers!r}; {advice}")
    given = plain(numbers)
    several = given if isinstance(given, Iterable) else [given]
    try:
        return ",".join(repr(float(number)) for number in several)
    except (TypeError, ValueError) as error:
        raise _tripos.RequestError(f"the values of `{name}` are not all numbers: {error}") from error


def files_of(model: pathlib.Path, scene: pathlib.Path) -> tuple[dict[str, str], str]:
    """Texts of a scene, of its model, of the files beside the model, and of the tables that the scene names, by their
    paths in a folder; and the scene's path there."""
    model = model / "model.toml" if model.is_dir() else model
    quoted = re.findall(r"""["']([^"'\n]+)["']""", scene.read_text(encoding="utf-8"))
    named = [scene.parent / name for name in quoted if re.search(r"\.\w+$", name)]
    files = {model, scene, *model.parent.glob("*.toml"), *named}
    files = {file.resolve() for file in files if file.is_file()}
    folder = pathlib.Path(os.path.commonpath([file.parent for file in files]))
    texts = {file.relative_to(folder).as_posix(): file.read_text(encoding="utf-8") for file in sorted(files)}
    return texts, scene.relative_to(folder).as_posix()


def run_block(
    request: SweepRequest, block: int = 0, blocks: int = 1, threads: Optional[int] = None
) -> tuple[str, str, int]:
    """Runs one of the blocks of a sweep. Returns its table, the messages, and the number of points of the whole sweep.

    The result depends on the arguments alone (not on the number of threads), so that a lost block can be run again.
    Ctrl-C raises a `KeyboardInterrupt` whose `table` has the finished rows.
    """
    with tempfile.TemporaryDirectory(prefix="tripos-") as name:
        folder = pathlib.Path(name)
        for path, text in request.files.items():
            file = folder / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        table = folder / "table.csv"
        threads = threads_of_worker() if threads is None else threads
        try:
            result = run_command(
                "sweep", folder / request.scene, over=list(request.over), shard=f"{block + 1}/{blocks}",
                threads=threads, out=table, json=True, **request.options,
            )  # fmt: skip
        except KeyboardInterrupt:
            raise interruption(unfinished_tables(folder)) from None
        # Exit status 3 says that some points have no result, and their rows give the reason.
        if result.status not in (0, 3) or not table.is_file():
            # The folder is gone when somebody reads the message.
            messages, output = (text.replace(name + os.sep, "") for text in (result.messages, result.output))
            answer = json.loads(output) if output.startswith("{") else {}
            raise failure(messages, answer.get("error", {}), result.status)
        text = table.read_bytes().decode("utf-8")
        return text, result.messages, int(json.loads(result.output)["points"])


def unfinished_tables(folder: pathlib.Path) -> list[str]:
    """Whole lines of the table that an interrupted command left in a folder; none if it wrote no header."""
    files = [file for file in (folder / "table.csv", folder / "table.csv.part") if file.is_file()]
    texts = [file.read_bytes().decode("utf-8") for file in files]
    return [text[: text.rindex("\n") + 1] for text in texts if "\n" in text]


def interruption(tables: Sequence[str]) -> KeyboardInterrupt:
    """Exception for a sweep that Ctrl-C ended. Its attribute `table` has the finished rows; None if there are none."""
    table = SweepTable.joined(tables) if tables else None
    rows = len(table) if table is not None else 0
    kept = f"the first {rows} rows are the attribute `table` of this exception" if rows else "no row is finished"
    exception = KeyboardInterrupt(f"the sweep was interrupted: {kept}")
    exception.table = table if rows else None  # type: ignore[attr-defined]
    return exception


def threads_of_worker() -> Optional[int]:
    """Number of threads of this worker of Dask; None, which means all cores, outside of a worker."""
    try:
        from distributed import get_worker

        return max(1, int(get_worker().state.nthreads))
    except (ImportError, ValueError, AttributeError):
        return None


def sweep(
    scene: Scene,
    over: Over,
    *,
    client: Any = None,
    blocks: Optional[int] = None,
    retries: int = 3,
    threads: Optional[int] = None,
    progress: bool = False,
    **options: Option,
) -> SweepTable:
    """Runs a scene for every combination of values: `over={"q2": [0.1, 0.2]}`, or `over="q2=0.1:1.5:1000"`.

    Other options are those of the command `tripos sweep`, such as `by`, `method`, `rtol`, `until` and `digits`.
    Without a `client` the sweep runs here, on all cores. With a client of Dask, blocks of points run on its workers;
    the table is the same, byte for byte. A block whose worker is lost, or that fails, runs again up to `retries` times.
    `threads` is the number of threads of a block; the default is all cores here, and those of each worker on Dask.
    `progress` shows a bar, if tqdm is installed; a sweep here then runs in blocks, one after another.

    Ctrl-C here raises a `KeyboardInterrupt` whose attribute `table` is a `SweepTable` of the finished rows, or None.

    >>> import tripos
    >>> model = tripos.Model.from_text(tripos.EXAMPLE)
    >>> scene = tripos.Scene.from_text(model, "span = [0, 1]\\n[start]\\ntheta = 0.5\\nomega = 0\\n")
    >>> table = tripos.sweep(scene, {"theta": [0.1, 0.2]}, rtol=1e-10)
    >>> table["stop"], table["theta"].round(6).tolist()
    (['end', 'end'], [-0.099993, -0.19997])
    """
    request = SweepRequest.of(scene, over, **options)
    count = number_of_blocks(blocks) if blocks is not None else None
    if client is None:
        results = run_here(request, count, threads, progress)
    else:
        # A wrong request fails here, and not on each worker.
        run_block(request, 0, CHECK_BLOCKS, threads)
        results = run_on(client, request, count or blocks_for(client), retries, threads, progress)
    warn_of("".join(messages for _, messages, _ in results), UntrustedRunWarning)
    return SweepTable.joined([table for table, _, _ in results])


def number_of_blocks(given: int) -> int:
    """Number of blocks, if it is a positive whole number."""
    try:
        blocks = operator.index(given)
    except TypeError:
        blocks = 0
    if blocks < 1:
        raise _tripos.RequestError(f"`blocks` is {given!r}; give a whole number from 1")
    return blocks


def run_here(
    request: SweepRequest, blocks: Optional[int], threads: Optional[int], progress: bool
) -> list[tuple[str, str, int]]:
    """Results of the blocks of a sweep that run here one after another. Without a bar, the default is one block."""
    if blocks is None and progress:
        _, _, points = run_block(request, 0, CHECK_BLOCKS, threads)
        blocks = min(points, BLOCKS_OF_BAR)
    count = blocks or 1
    results: list[tuple[str, str, int]] = []
    with bar_of_blocks(count) if progress else contextlib.nullcontext() as shown:
        for block in range(count):
            try:
                results.append(run_block(request, block, count, threads))
            except KeyboardInterrupt as interrupt:
                own = getattr(interrupt, "table", None)
                raise interruption([table for table, _, _ in results] + ([] if own is None else [own.csv])) from None
            if shown is not None:
                shown.update()
    return results


def run_on(
    client: Any, request: SweepRequest, blocks: int, retries: int, threads: Optional[int], progress: bool
) -> list[tuple[str, str, int]]:
    """Results of the blocks of a sweep that run on the workers of a client of Dask."""
    counts = list(range(blocks))
    keys = [f"tripos-sweep-{request.key}-{block}-of-{blocks}" for block in counts]
    futures = client.map(
        run_block, [request] * blocks, counts, [blocks] * blocks, [threads] * blocks,
        key=keys, retries=retries, pure=True,
    )  # fmt: skip
    try:
        if progress:
            show_progress(futures)
        results: list[tuple[str, str, int]] = client.gather(futures)
    except KeyboardInterrupt:
        client.cancel(futures)
        raise
    return results


def sweep_frame(
    scene: Scene, over: Over, *, blocks: int = 64, threads: Optional[int] = None, **options: Option
) -> Any:
    """The table of a sweep as a `dask.dataframe.DataFrame`, a partition for each of the `blocks`.

    A partition is run when it is needed, on the workers of the current client. `sweep_frame(…).to_parquet(folder)`
    writes each partition where it was run, so that no machine holds the whole table.
    """
    import dask.dataframe

    request = SweepRequest.of(scene, over, **options)
    blocks = number_of_blocks(blocks)
    _, _, points = run_block(request, 0, CHECK_BLOCKS)
    first, messages, _ = run_block(request, 0, max(1, points))
    warn_of(messages, UntrustedRunWarning)
    blocks = min(blocks, max(1, points))
    return dask.dataframe.from_map(
        block_frame, range(blocks), request=request, blocks=blocks, threads=threads, meta=frame_of(first).iloc[:0]
    )


def block_frame(block: int, request: SweepRequest, blocks: int, threads: Optional[int] = None) -> Any:
    """Table of one block of a sweep as a `pandas.DataFrame`."""
    return frame_of(run_block(request, block, blocks, threads)[0])


def frame_of(text: str) -> Any:
    """Table of a sweep as a `pandas.DataFrame`, whose columns have the same types in each block."""
    import pandas

    names, *rows = csv.reader(io.StringIO(text))
    columns = zip(*rows) if rows else [()] * len(names)
    return pandas.DataFrame({name: values_of(name, cells) for name, cells in zip(names, columns)})


def values_of(name: str, cells: Iterable[str]) -> Any:
    """Values of a column of a sweep: texts as a list, and numbers as an array with NaN for empty cells."""
    if name in TEXTS:
        return list(cells)
    return np.array([float(cell or "nan") for cell in cells], dtype=np.int64 if name == "index" else np.float64)


def blocks_for(client: Any) -> int:
    """Number of blocks for which all workers of a client have work until the end."""
    threads = int(sum(client.nthreads().values()))
    return 32 * max(1, threads)


def show_progress(futures: Sequence[Any]) -> None:
    """Shows a bar until all blocks have ended, if tqdm is installed."""
    from distributed import as_completed

    with bar_of_blocks(len(futures)) as shown:
        if shown is not None:
            for _ in as_completed(futures):
                shown.update()


def bar_of_blocks(blocks: int) -> contextlib.AbstractContextManager[Any]:
    """Bar of the blocks that have ended; None in its place if tqdm is not installed."""
    shown = bar(total=blocks, unit="block", desc="sweep")
    return contextlib.nullcontext() if shown is None else shown
