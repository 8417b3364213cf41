"""Scenes, their runs, and what becomes of these."""

from __future__ import annotations

import contextlib
import os
import pathlib
import tempfile
import types
import warnings
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _tripos
from ._arguments import Array, Path, checked, distinct_names, instants_of, real_array
from ._commands import Option, UntrustedRunWarning, answer
from ._display import Page, Picture
from ._files import Folder, file_name
from ._model import Model
from ._progress import RunBar

#: Function of the time, s, and of the shown quantities by name that returns values of inputs: numbers, or one number.
Controller = Callable[[float, dict[str, float]], Union[float, Sequence[float]]]
#: Advice for runs with few digits whose controller was given as `controller`.
FEW_DIGITS = (
    "fewer than three digits are known at the end; if the controller has a memory, such as an observer, a filter or an "
    "integrator, give `make` in its place"
)


class Samples:
    """Samples of a finished run: instants, and values of quantities with names.

    A run is a mapping of the names to the values: `run["x"]`, `"x" in run`, `list(run)` and `dict(run)`. Runs can be
    copied and pickled.
    """

    _run: Any
    #: Values of the inner run that a pickled run keeps.
    _kept: tuple[str, ...] = ("names", "end", "errors", "digits", "events", "warnings", "is_trusted", "ending")

    def __init__(self, inner: Union[_tripos.Run, _tripos.SampledRun]) -> None:
        self._run = inner
        #: Instants of the samples, s.
        self.t: Array = inner.t
        #: Values of the quantities: a row for each sample.
        self.values: Array = inner.values

    def __getstate__(self) -> dict[str, Any]:
        """State for `pickle`: arrays and values, without the extension module."""
        kept = {name: getattr(self._run, name) for name in self._kept}
        return {**self.__dict__, "_run": types.SimpleNamespace(**kept)}

    @property
    def names(self) -> list[str]:
        """Names of the quantities."""
        names: list[str] = self._run.names
        return names

    def keys(self) -> list[str]:
        """Names of the quantities, as `dict(run)` needs them."""
        return self.names

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        """Number of the quantities; `len(run.t)` is the number of samples."""
        return len(self.names)

    def __getitem__(self, name: str) -> Array:
        """Values of a quantity at the samples."""
        names = self.names
        if name not in names:
            raise KeyError(f"the run has no quantity {name!r}; it has {', '.join(names)}")
        column: Array = self.values[:, names.index(name)]
        return column

    @property
    def end(self) -> dict[str, float]:
        """Values of the quantities at the end."""
        end: dict[str, float] = self._run.end
        return end

    @property
    def errors(self) -> dict[str, float] | None:
        """Estimated error of each quantity at the end, in its unit.

        None if they are not known, or not needed: a scene whose reduced system has no states needs no integration.
        """
        errors: dict[str, float] | None = self._run.errors
        return errors

    @property
    def digits(self) -> dict[str, float] | None:
        """Correct digits of each quantity at the end; None where `errors` is None."""
        digits: dict[str, float] | None = self._run.digits
        return digits

    @property
    def events(self) -> list[tuple[str, float]]:
        """Names of the events and their instants, s."""
        events: list[tuple[str, float]] = self._run.events
        return events

    @property
    def warnings(self) -> list[str]:
        """Reasons not to trust the run."""
        reasons: list[str] = self._run.warnings
        return reasons

    @property
    def is_trusted(self) -> bool:
        """True if nothing speaks against the run, and its errors at the end are known or not needed.

        The errors are not needed if the reduced system has no states. `errors` is None then.
        """
        return bool(self._run.is_trusted)

    @property
    def ending(self) -> str:
        """Sentence that says when and why the run ended."""
        return str(self._run.ending)

    def __repr__(self) -> str:
        return f"<tripos.{type(self).__name__}: {self.ending}>"

    def to_pandas(self) -> Any:
        """Samples as a `pandas.DataFrame` with the time as its index."""
        import pandas

        return pandas.DataFrame(self.values, index=pandas.Index(self.t, name="t"), columns=self.names)

    def to_xarray(self) -> Any:
        """Samples as an `xarray.Dataset` with the coordinate `t`."""
        import xarray

        return xarray.Dataset({name: ("t", self[name]) for name in self.names}, coords={"t": self.t})

    def plot(self, *names: str) -> Any:
        """Axes of Matplotlib, one for each name; without names all quantities."""
        from matplotlib import pyplot

        shown = list(names) or self.names
        figure, axes = pyplot.subplots(len(shown), 1, sharex=True, squeeze=False, layout="constrained")
        for name, axis in zip(shown, axes[:, 0]):
            axis.plot(self.t, self[name])
            axis.set_ylabel(name)
        axes[-1, 0].set_xlabel("t [s]")
        return axes[:, 0]


class Run(Samples):
    """A finished run of a scene, with the quantities that the scene shows."""

    _kept = (*Samples._kept, "notes", "drift")

    @property
    def notes(self) -> list[str]:
        """Notes on the way in which the run was made."""
        notes: list[str] = self._run.notes
        return notes

    @property
    def drift(self) -> dict[str, float]:
        """Largest change of each conserved quantity."""
        drift: dict[str, float] = self._run.drift
        return drift


class SampledRun(Samples):
    """A finished run with a controller. Its quantities are the coordinates, the generalized speeds, and the further
    outputs of the scene."""

    def __init__(self, inner: _tripos.SampledRun) -> None:
        super().__init__(inner)
        #: Instants at which the controller set the inputs, s.
        self.decision_times: Array = inner.decision_times
        #: Values of the inputs: a row for each of these instants.
        self.decisions: Array = inner.decisions


class Scene:
    """A scene file: a model, a start, parameters, a span of time and outputs.

    Scenes can be copied and pickled. A pickled scene is the path of its file, which is read again, or the texts of the
    scene and its model; and the numbers that were set.
    """

    def __init__(self, path: Path) -> None:
        self._scene = _tripos.Scene.read(os.fspath(path))
        self._path: Optional[pathlib.Path] = pathlib.Path(path)
        self._text = ""
        self._set: dict[str, float] = {}
        self._folder: Optional[Folder] = None

    @classmethod
    def from_text(cls, model: Model, text: str) -> Scene:
        """Makes a scene of a model from the text of a scene file.

        >>> import tripos
        >>> model = tripos.Model.from_text(tripos.EXAMPLE)
        >>> scene = Scene.from_text(model, "span = [0, 1]\\n[start]\\ntheta = 0.5\\nomega = 0\\n")
        >>> run = scene.simulate(rtol=1e-10)
        >>> run.is_trusted, round(run.end["theta"], 9)
        (True, -0.499157187)
        """
        scene = cls.__new__(cls)
        scene._scene = _tripos.Scene.parse(model._model, text)
        scene._path, scene._text, scene._set, scene._folder = None, text, {}, None
        return scene

    def copy(self) -> Scene:
        """A scene with the same numbers. `set` on one of the two does not change the other."""
        scene = type(self).__new__(type(self))
        scene._scene, scene._set = self._scene.copy(), dict(self._set)
        scene._path, scene._text, scene._folder = self._path, self._text, self._folder
        return scene

    def __copy__(self) -> Scene:
        return self.copy()

    def __deepcopy__(self, memo: Any) -> Scene:
        return self.copy()

    def __getstate__(self) -> dict[str, Any]:
        """State for `pickle`: the file of the scene, or the texts of scene and model; and the numbers that were set."""
        if self._path is not None:
            return {"path": os.fspath(self._path.absolute()), "set": dict(self._set)}
        return {"path": None, "text": self._text, "model": self.model.text, "set": dict(self._set)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        path = state["path"]
        if path is None:
            self._scene = _tripos.Scene.parse(_tripos.Model.parse(state["model"]), state["text"])
        else:
            self._scene = _tripos.Scene.read(path)
        self._path, self._text = None if path is None else pathlib.Path(path), state.get("text", "")
        self._set, self._folder = {}, None
        self.set(**state["set"])

    @property
    def path(self) -> pathlib.Path:
        """File of the scene. A scene that was made from a text gets a folder with its model, which goes with it."""
        if self._path is not None:
            return self._path
        model = self.model
        name = file_name(model.title)
        if self._folder is None or not self._folder.path.is_dir():
            self._folder = Folder({f"{name}/model.toml": model.text, f"{name}/scenes/scene.toml": self._text})
        return self._folder.path / name / "scenes" / "scene.toml"

    def _answer(self, command: str, **options: Option) -> Any:
        values = [f"{name}={value!r}" for name, value in self._set.items()]
        return answer(command, self.path, set=values, warning=UntrustedRunWarning, **options)

    def reduce(self) -> Any:
        """Reduced equations of the scene, what they leave out, and the proof that the motion stays the same."""
        return self._answer("scene")

    def view(self, *against: str, **settings: Option) -> Page:
        """Animated 3-D view of the motion, beside other equations or scenes."""
        with tempfile.TemporaryDirectory(prefix="tripos-") as folder:
            file = pathlib.Path(folder) / "view.html"
            self._answer("view", against=list(against), out=file, **settings)
            return Page(file.read_text(encoding="utf-8"))

    def figure(
        self, *what: str, against: Optional[str] = None, also: Sequence[str] = (), **settings: Option
    ) -> Picture:
        """Figure of quantities over time or against one another, a panel for each of `what`."""
        with tempfile.TemporaryDirectory(prefix="tripos-") as folder:
            file = pathlib.Path(folder) / "figure.svg"
            self._answer("plot", what=list(what), against=against, also=list(also), out=file, **settings)
            return Picture(file.read_text(encoding="utf-8"))

    def stability(self, out: Path, *, quick: bool = False) -> Any:
        """Places where runs lose accuracy or stop, with tables and figures in the folder `out`."""
        return self._answer("stability", out=out, quick=quick)

    def chart(self, out: Path, *, quick: bool = False, printed: bool = False) -> Any:
        """Speed against accuracy of every formulation and method, with tables and the chart in the folder `out`."""
        return self._answer("chart", out=out, quick=quick, printed=printed)

    def fmu(self, out: Path, *, fmi: int = 3, only_sources: bool = False) -> Any:
        """Writes the scene as a Functional Mock-up Unit for model exchange and co-simulation."""
        return self._answer("fmu", out=out, fmi=fmi, only_sources=only_sources)

    @property
    def model(self) -> Model:
        """Model of the scene."""
        model = Model._of(self._scene.mechanism())
        if not self._text:
            model._path = pathlib.Path(model._model.file)
        return model

    def set(self, /, **values: float) -> None:
        """Sets parameters and numbers of the start, in the units of the model file."""
        for name, value in values.items():
            self._scene.set(name, float(value))
            self._set[name] = float(value)

    def simulate(self, *, progress: bool = False, **settings: Any) -> Run:
        """Runs the scene. Settings replace those of the file: by, method, project, solve, step, max_step, rtol, atol,
        step_limit, samples, until. `by` names a formulation, or a printed system as "printed:ID". Each reason not to
        trust the run is a Python warning too. `progress` shows a bar, if tqdm is installed."""
        settings = checked(settings)
        with self._bar(progress, settings) as shown:
            run = Run(self._scene.run(settings, None if shown is None else shown.show))
            finish(shown, run)
        warn(run.warnings)
        return run

    def _bar(self, progress: bool, settings: dict[str, Any]) -> contextlib.AbstractContextManager[Optional[RunBar]]:
        """Bar for a run with these settings; None in its place if no progress shall be shown."""
        begin, end = self._scene.span
        return RunBar(begin, settings.get("until", end)) if progress else contextlib.nullcontext()

    def sensitivity(self, *names: str, **settings: Any) -> dict[str, dict[str, float]]:
        """Derivatives of the shown quantities at the end with respect to parameters and numbers of the start.

        A derivative that does not exist is NaN, with a warning."""
        slopes, reasons = self._scene.slopes(list(names), checked(settings))
        warn(reasons)
        return slopes

    def gradient(self, of: str, **settings: Any) -> dict[str, float]:
        """Derivatives of one number at the end with respect to all parameters and numbers of the start.

        A derivative that does not exist is NaN, with a warning."""
        _, slopes, reasons = self._scene.gradient_of(of, checked(settings))
        warn(reasons)
        return slopes

    def objective(self, of: str, names: Sequence[str], **settings: Any) -> Callable[[ArrayLike], tuple[float, Array]]:
        """Function of the numbers `names` that returns the value of `of` at the end, and its gradient.

        `names` are parameters and numbers of the start. The function is what `scipy.optimize.minimize` takes with
        `jac=True`. It leaves the scene as it is. Unknown names and settings are refused at once.

        >>> import tripos
        >>> model = tripos.Model.from_text(tripos.EXAMPLE)
        >>> scene = tripos.Scene.from_text(model, "span = [0, 1]\\n[start]\\ntheta = 0.5\\nomega = 0\\n")
        >>> value, slopes = scene.objective("theta", ["theta", "l"], rtol=1e-10)([0.5, 1.0])
        >>> round(value, 6), slopes.round(6).tolist()
        (-0.499157, [-0.992714, 0.044502])
        """
        chosen, settings = distinct_names(names), checked(settings)
        inner = self._scene.copy()
        with contextlib.suppress(_tripos.StoppedError):
            # One step finds unknown names. It may stop where the scene cannot start without the numbers.
            columns(inner.gradient_of(of, {**settings, "step_limit": 1})[1], chosen)

        def function(values: ArrayLike) -> tuple[float, Array]:
            given = real_array("the point of the objective", values)
            if given.shape != (len(chosen),):
                raise _tripos.RequestError(f"the objective takes {len(chosen)} numbers, not the shape {given.shape}")
            scene = inner.copy()
            for name, number in zip(chosen, given):
                scene.set(name, float(number))
            value, slopes, reasons = scene.gradient_of(of, settings)
            gradient = columns(slopes, chosen)
            warn(reasons)
            return value, gradient

        return function

    def jax_objective(self, of: str, names: Sequence[str], **settings: Any) -> Callable[[Any], Any]:
        """`objective` as a function of JAX with its own reverse derivative (`jax.custom_vjp`), for `jax.grad` and
        `jax.jit`. Numbers are doubles only if `jax_enable_x64` is set."""
        import jax

        objective = self.objective(of, names, **settings)
        count = len(names)

        def run(values: Any) -> tuple[Any, Any]:
            value, slopes = objective(np.asarray(values, dtype=float))
            kind = np.asarray(values).dtype
            return np.asarray(value, dtype=kind), np.asarray(slopes, dtype=kind)

        def both(values: Any) -> Any:
            values = jax.numpy.asarray(values)
            is_real = jax.numpy.issubdtype(values.dtype, jax.numpy.floating)
            kind = values.dtype if is_real else jax.numpy.result_type(float)
            shapes = (jax.ShapeDtypeStruct((), kind), jax.ShapeDtypeStruct((count,), kind))
            return jax.pure_callback(run, shapes, values.astype(kind), vmap_method="sequential")

        function = jax.custom_vjp(lambda values: both(values)[0])
        function.defvjp(both, lambda slopes, weight: (weight * slopes,))
        result: Callable[[Any], Any] = function
        return result

    def sampled(
        self,
        inputs: Sequence[str],
        instants: Sequence[float],
        controller: Controller | None = None,
        *,
        make: Callable[[], Controller] | None = None,
        progress: bool = False,
        **settings: Any,
    ) -> SampledRun:
        """Runs the scene with inputs that `controller(t, values)` sets at the instants, s, each held until the next.

        `values` has the coordinates, the generalized speeds and the outputs of the scene by name. Accelerations and
        reactions in outputs are those just before the instant. The function returns a number for each input; for one
        input it may return a number alone. `progress` shows a bar, if tqdm is installed.

        The motion is computed twice: the difference of the two runs gives the errors. A controller with a memory, such
        as an observer, a filter or an integrator, must therefore be given as `make`, a function that returns a new
        controller for each run. As `controller`, it would begin the second run with the memory of the first, and the
        errors would be wrong."""
        times, settings, own = instants_of(instants), checked(settings), maker_of(controller, make)
        with self._bar(progress, settings) as shown:
            report = None if shown is None else shown.show
            run = SampledRun(self._scene.run_sampled(list(inputs), times, own, settings, report))
            finish(shown, run)
        warn(run.warnings)
        if controller is not None and min((run.digits or {"": 0.0}).values()) < 3:
            warn([FEW_DIGITS])
        return run


def maker_of(controller: Controller | None, make: Callable[[], Controller] | None) -> Callable[[], Controller]:
    """Function that returns the controller of a run: `make`, or one that returns `controller` each time."""
    if make is not None and controller is None:
        return make
    if controller is None or make is not None:
        raise _tripos.RequestError("give either `controller` or `make`, which returns a new controller")
    given = controller
    return lambda: given


def columns(slopes: Mapping[str, float], names: Sequence[str]) -> Array:
    """Derivatives by these names in their order."""
    missing = [name for name in names if name not in slopes]
    if missing:
        known = ", ".join(slopes)
        raise _tripos.RequestError(f"there is no derivative by `{missing[0]}`; there are those by {known}")
    return np.array([slopes[name] for name in names])


def finish(shown: Optional[RunBar], run: Samples) -> None:
    """Fills the bar of a run that has ended."""
    if shown is not None:
        shown.finish(float(run.t[-1]))


def warn(reasons: Sequence[str]) -> None:
    """Makes each reason not to trust a run a Python warning at the line that called the method."""
    for reason in reasons:
        warnings.warn(reason, UntrustedRunWarning, stacklevel=3)
