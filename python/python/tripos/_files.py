"""Temporary files of models, scenes and states that were made from texts and values."""

from __future__ import annotations

import contextlib
import json
import math
import os
import pathlib
import re
import shutil
import tempfile
import weakref
from collections.abc import Iterator, Mapping
from typing import Optional, Union

from . import _tripos
from ._arguments import Path, State, plain


class Folder:
    """A temporary folder with files. It is removed with its last owner, or when Python ends."""

    def __init__(self, files: Mapping[str, str]) -> None:
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="tripos-"))
        weakref.finalize(self, remove_folder, self.path, os.getpid())
        for name, text in files.items():
            file = self.path / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")


def remove_folder(path: pathlib.Path, process: int) -> None:
    """Removes a temporary folder in the process that made it. A forked child leaves the folder to its parent."""
    if os.getpid() == process:
        shutil.rmtree(path, ignore_errors=True)


def file_name(title: str) -> str:
    """A title as the name of a file or folder, of at most 60 characters.

    >>> file_name("Thin disk, sliding")
    'thin_disk_sliding'
    """
    return "_".join(re.findall(r"\w+", title.lower()))[:60] or "model"


@contextlib.contextmanager
def state_file(given: Union[Path, State, None]) -> Iterator[Optional[Path]]:
    """File of a state: the file itself, or one with the tables of a mapping."""
    if not isinstance(given, Mapping):
        yield given
        return
    lines = []
    for table, entries in given.items():
        if not isinstance(entries, Mapping):
            raise _tripos.RequestError(f"`{table}` of a state is a table of numbers by name, not {entries!r}")
        lines.append(f"[{table}]")
        for name, value in entries.items():
            if not isinstance(value, str) and not math.isfinite(value):
                raise _tripos.RequestError(f"`{name}` of [{table}] is {value}, and a state has finite numbers")
            lines.append(f"{json.dumps(name)} = {json.dumps(plain(value))}")
    with tempfile.TemporaryDirectory(prefix="tripos-") as folder:
        file = pathlib.Path(folder) / "state.toml"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        yield file
