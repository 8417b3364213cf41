"""Models, and the functions of their equations on arrays."""

from __future__ import annotations

import contextlib
import importlib.util
import json
import math
import os
import pathlib
import sys
import tempfile
import types
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Callable, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _tripos
from ._commands import Option, answer, text_of
from ._display import Page, Picture

Array = NDArray[np.float64]
Path = Union[str, "os.PathLike[str]"]

EXAMPLE = """\
name = "Pendulum"

[parameters]
m = { unit = "kg", value = 1, positive = true, about = "mass of the bob" }
l = { unit = "m", value = 1, positive = true, about = "length of the rod" }
g = { unit = "m/s^2", value = 9.81, positive = true, about = "acceleration of free fall" }

[coordinates]
theta = { unit = "rad", about = "rod from hanging" }

[speeds]
omega = "theta'"

[inertial]
frame = "N"
origin = "O"

[frames]
B = { from = "N", axis = 3, angle = "theta" }

[points]
P = { from = "O", frame = "B", position = [0, "-l", 0] }

[particles]
bob = { point = "P", mass = "m" }

[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"""


class Parameter(NamedTuple):
    """A parameter or an input of a model."""

    unit: str
    default: float | None
    about: str
    is_input: bool


class Symbol(NamedTuple):
    """A coordinate or a generalized speed: its unit, and its meaning or definition."""

    unit: str
    about: str


class Model:
    """A mechanism, read from a model file or its folder.

    The functions take coordinates `q` and generalized speeds `u` (for Lagrange's equations: the rates of `q`) of the
    shape (n,) for one state, or (N, n) for N states. Parameters and inputs are keywords; the file's defaults fill the
    rest. `equations` names the equations that are evaluated: "kane", "lagrange", "newton-euler".
    """

    def __init__(self, path: Path) -> None:
        self._model = _tripos.Model.read(os.fspath(path))
        self._path: Optional[pathlib.Path] = pathlib.Path(path)
        self._folder: Optional[tempfile.TemporaryDirectory[str]] = None

    @classmethod
    def from_text(cls, text: str) -> Model:
        """Reads a model from the text of a model file.

        >>> Model.from_text(EXAMPLE).title
        'Pendulum'
        """
        return cls._of(_tripos.Model.parse(text))

    @classmethod
    def _of(cls, inner: _tripos.Model) -> Model:
        model = cls.__new__(cls)
        model._model = inner
        model._path = None
        model._folder = None
        return model

    @property
    def path(self) -> pathlib.Path:
        """File of the model. A model that was made from a text gets a file in a folder that goes with it."""
        if self._path is None:
            self._folder = tempfile.TemporaryDirectory(prefix="tripos-")
            self._path = pathlib.Path(self._folder.name) / "model.toml"
            self._path.write_text(self.text, encoding="utf-8")
        return self._path

    def check(self) -> Any:
        """Degrees of freedom, redundant constraints, singular poses and unused declarations, as `tripos check` has."""
        return answer("check", self.path)

    def derive(self, by: Optional[str] = None, *, form: Optional[str] = None) -> Any:
        """Equations of motion by a formulation, or by all, as the JSON of `tripos derive`.

        >>> equations = Model.from_text(EXAMPLE).derive("kane")
        """
        return answer("derive", self.path, by=by, form=form)

    def prove(self, *also: str) -> Any:
        """Proof that the formulations are equivalent, and what the motion conserves."""
        return answer("prove", self.path, also=list(also))

    def diff(self, *others: Path, find_coordinates: bool = False) -> Any:
        """Comparison with publications, or with a newer model."""
        return answer("diff", self.path, *others, find_coordinates=find_coordinates)

    def grade(self, *submissions: Path, rubric: Optional[Path] = None, level: Optional[str] = None) -> Any:
        """Marks for submissions, by their root mistakes."""
        return answer("grade", self.path, *submissions, rubric=rubric, level=level)

    def linearise(
        self,
        about: Union[Path, Mapping[str, Mapping[str, float]]],
        *,
        inputs: Sequence[str] = (),
        outputs: Sequence[str] = (),
        symbolic: Sequence[str] = (),
        whole: bool = False,
        as_is: bool = False,
    ) -> Any:
        """Linear system about rest or a steady motion: A, B, C, D, eigenvalues and modes.

        `about` is a state file, or its tables: `{"state": {…}, "guess": {…}, "parameters": {…}}`.
        """
        with state_file(about) as at:
            return answer(
                "linearise", self.path, about=at, input=list(inputs), output=list(outputs),
                symbolic=list(symbolic), whole=whole, as_is=as_is,
            )  # fmt: skip

    def equilibria(
        self,
        from_: Union[Path, Mapping[str, Mapping[str, float]], None] = None,
        *,
        starts: Optional[int] = None,
        over: Sequence[str] = (),
        solve_for: Sequence[str] = (),
    ) -> Any:
        """Rest positions and steady motions, with the stability of each."""
        with state_file(from_) as at:
            options: dict[str, Option] = {"from": at, "starts": starts, "over": list(over), "for": list(solve_for)}
            return answer("equilibria", self.path, **options)

    def identify(self, *, declared: bool = False, at: Optional[Path] = None) -> Any:
        """Base parameters: combinations of masses, inertias and loads that motion can identify."""
        return answer("identify", self.path, declared=declared, at=at)

    def inverse_inputs(self, motion: Path, *, inputs: Sequence[str] = ()) -> Any:
        """Forces that a motion needs, and the inputs that give them, as `tripos inverse` has them."""
        return answer("inverse", self.path, motion=motion, input=list(inputs))

    def evaluate(self, at: Union[Path, Mapping[str, Mapping[str, float]]], by: str = "kane") -> Any:
        """Values of the equations at one state, as `tripos evaluate` has them."""
        with state_file(at) as file:
            return answer("evaluate", self.path, by=by, at=file)

    def latex(self, by: Optional[str] = None, *, fragment: bool = True, form: Optional[str] = None) -> str:
        """Equations as LaTeX: sections for a document, or a document."""
        return text_of("derive", self.path, by=by, format="latex", fragment=fragment, form=form)

    def markdown(self, by: Optional[str] = None, *, form: Optional[str] = None) -> str:
        """Equations as Markdown with formulas."""
        return text_of("derive", self.path, by=by, format="markdown", form=form)

    def _repr_markdown_(self) -> str:
        """Equations, for a notebook."""
        return self.markdown("kane")

    def sympy(self, by: str = "kane") -> types.SimpleNamespace:
        """Equations as SymPy objects: `mass_matrix`, `forcing`, `unknowns`, `accelerations`, energies and more.

        >>> pytest = __import__("pytest"); _ = pytest.importorskip("sympy")
        >>> Model.from_text(EXAMPLE).sympy().mass_matrix
        Matrix([[l**2*m]])
        """
        names: dict[str, Any] = {}
        exec(compile(text_of("derive", self.path, by=by, format="sympy"), "equations.py", "exec"), names)
        equations: types.SimpleNamespace = names[by.replace("-", "_")]
        return equations

    def emit(self, out: Path, language: str, *, formulations: Sequence[str] = (), functions: Sequence[str] = ()) -> Any:
        """Writes the equations as code in Rust, JavaScript, C, Python or MATLAB, or for CasADi, to a folder."""
        return answer(
            "emit", self.path, out=out, language=language,
            formulation=list(formulations), functions=",".join(functions) or None,
        )  # fmt: skip

    def numpy(self, by: str = "kane") -> types.ModuleType:
        """Equations as a module of Python that needs NumPy alone.

        >>> module = Model.from_text(EXAMPLE).numpy()
        >>> module.mass_matrix(module.DEFAULTS, [0.0], [0.0]).tolist()
        [[1.0]]
        """
        return self._module("python", by, "")

    def casadi(self, by: str = "kane") -> types.ModuleType:
        """Equations as a module with a CasADi `Function` for each quantity."""
        return self._module("casadi", by, "_casadi")

    def _module(self, language: str, by: str, ending: str) -> types.ModuleType:
        with tempfile.TemporaryDirectory(prefix="tripos-") as folder:
            self.emit(folder, language, formulations=[by])
            name = by.replace("-", "_") + ending + ".py"
            (file,) = [file for file in pathlib.Path(folder).glob("*.py") if file.name.endswith(name)]
            sys.path.insert(0, folder)
            try:
                # Its own helper module is loaded anew, since another version may have the same name.
                for helper in ("tripos_arrays", "tripos_casadi"):
                    sys.modules.pop(helper, None)
                spec = importlib.util.spec_from_file_location(file.stem, file)
                assert spec is not None and spec.loader is not None
                module = importlib.util.module_from_spec(spec)
                spec.loader.exec_module(module)
            finally:
                sys.path.remove(folder)
        return module

    def sketch(self, at: Optional[Path] = None) -> Picture:
        """Drawing of the mechanism."""
        with tempfile.TemporaryDirectory(prefix="tripos-") as folder:
            file = pathlib.Path(folder) / "sketch.svg"
            answer("sketch", self.path, at=at, out=file)
            return Picture(file.read_text(encoding="utf-8"))

    def page(self, out: Optional[Path] = None, *, also: Sequence[str] = ()) -> Page:
        """Page about the model: equations, proofs, and runs of every scene."""
        with tempfile.TemporaryDirectory(prefix="tripos-") as folder:
            to = pathlib.Path(folder if out is None else out)
            answer("page", self.path, out=to, also=list(also))
            return Page((to / "index.html").read_text(encoding="utf-8"))

    @property
    def title(self) -> str:
        """Title of the model."""
        return self._model.title

    @property
    def text(self) -> str:
        """Text of the model file."""
        return self._model.text

    @property
    def parameters(self) -> dict[str, Parameter]:
        """Parameters and inputs by name.

        >>> Model.from_text(EXAMPLE).parameters["l"]
        Parameter(unit='m', default=1.0, about='length of the rod', is_input=False)
        """
        return {
            name: Parameter(unit, default, about, is_input)
            for name, unit, default, about, is_input in self._model.parameter_list()
        }

    @property
    def coordinates(self) -> dict[str, Symbol]:
        """Generalized coordinates by name, with unit and meaning."""
        return {name: Symbol(*rest) for name, *rest in self._model.coordinate_list()}

    @property
    def speeds(self) -> dict[str, Symbol]:
        """Generalized speeds by name, with unit and definition."""
        return {name: Symbol(*rest) for name, *rest in self._model.speed_list()}

    def __repr__(self) -> str:
        return f"<tripos.Model {self.title!r}: {len(self.coordinates)} coordinates, {len(self.speeds)} speeds>"

    def mass_matrix(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Mass matrix M of M x = f, of the shape (n, n) or (N, n, n)."""
        return self._value("mass_matrix", equations, parameters, q, u, square)

    def forcing(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Forcing f of M x = f, of the shape (n,) or (N, n)."""
        return self._value("forcing", equations, parameters, q, u)

    def accelerations(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Rates of the generalized speeds, of the shape (n,) or (N, n).

        >>> Model.from_text(EXAMPLE).accelerations([[0.0], [1.0]], [[0.0], [0.0]], g=1.0).round(6).tolist()
        [[0.0], [-0.841471]]
        """
        return self._value("accelerations", equations, parameters, q, u)

    def coordinate_rates(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Rates of the coordinates, W u + w."""
        return self._value("coordinate_rates", equations, parameters, q, u)

    def derivative(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Rates of the state (q, u)."""
        return self._value("derivative", equations, parameters, q, u)

    def jacobian(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Slopes of `derivative` along the state: a row for each rate."""
        return self._value("jacobian", equations, parameters, q, u, square)

    def kinetic_energy(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Kinetic energy, J."""
        return self._value("kinetic_energy", equations, parameters, q, u, scalar)

    def potential_energy(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Potential energy, J."""
        return self._value("potential_energy", equations, parameters, q, u, scalar)

    def power(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Power of the loads without a potential, W."""
        return self._value("power", equations, parameters, q, u, scalar)

    def constraints(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Residuals of the loops and of the motion constraints."""
        return self._value("constraints", equations, parameters, q, u)

    def inverse(
        self, q: ArrayLike, u: ArrayLike, u_dot: ArrayLike, *, equations: str = "kane", **parameters: float
    ) -> Array:
        """Generalized forces that give the accelerations `u_dot` beside the forces of the model, M u_dot - f."""
        return self._value("inverse_dynamics", equations, parameters, q, u, x=u_dot)

    def rhs(self, *, equations: str = "kane", **parameters: float) -> Callable[[float, ArrayLike], Array]:
        """Right-hand side f(t, y) of y' = f for `scipy.integrate.solve_ivp`, with y = (q, u)."""
        count = len(self.coordinates)

        def function(t: float, y: ArrayLike) -> Array:
            state = np.asarray(y, dtype=float)
            return self.derivative(state[:count], state[count:], equations=equations, **parameters)

        return function

    def rhs_jacobian(self, *, equations: str = "kane", **parameters: float) -> Callable[[float, ArrayLike], Array]:
        """Jacobian of `rhs`, for implicit methods of `solve_ivp`."""
        count = len(self.coordinates)

        def function(t: float, y: ArrayLike) -> Array:
            state = np.asarray(y, dtype=float)
            return self.jacobian(state[:count], state[count:], equations=equations, **parameters)

        return function

    def _parameters(self, given: Mapping[str, float]) -> list[float]:
        known = self._model.parameter_list()
        names = [name for name, *_ in known]
        for name in given:
            if name not in names:
                raise _tripos.RequestError(f"the model has no parameter `{name}`; its parameters are {', '.join(names)}")
        values = []
        for name, _, default, *_ in known:
            value = given.get(name, default)
            if value is None:
                raise _tripos.RequestError(f"the parameter `{name}` has no default: give {name}=…")
            values.append(float(value))
        return values

    def _value(
        self,
        name: str,
        equations: str,
        parameters: Mapping[str, float],
        q: ArrayLike,
        u: ArrayLike,
        shaped: Callable[[Array], Array] | None = None,
        x: ArrayLike | None = None,
    ) -> Array:
        p = self._parameters(parameters)
        coordinates, variables, width = self._model.lengths(name, equations)
        one, states_q = rows("q", q, coordinates)
        also, states_u = rows("u", u, variables)
        many = [states_q, states_u]
        if x is not None:
            last, states_x = rows("u_dot", x, variables)
            many.append(states_x)
            also = also and last
        count = max(len(states) for states in many)
        for states in many:
            if len(states) not in (1, count):
                raise _tripos.RequestError(f"the arrays have {', '.join(str(len(s)) for s in many)} states")
        many = [np.ascontiguousarray(np.broadcast_to(s, (count, s.shape[1]))) for s in many]
        accelerations = many[2] if x is not None else np.zeros((count, 0))
        flat = self._model.evaluate(name, equations, p, many[0], many[1], accelerations)
        values: Array = flat.reshape(count, width)
        if shaped is not None:
            values = shaped(values)
        return values[0] if one and also else values


def rows(name: str, values: ArrayLike, width: int) -> tuple[bool, Array]:
    """States as rows, and whether one state was given without a row of its own."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise _tripos.RequestError(f"{name} is no array of real numbers: {error}") from error
    if array.ndim not in (1, 2) or array.shape[-1] != width:
        raise _tripos.RequestError(f"{name} has the shape {array.shape}; give ({width},) or (N, {width})")
    return array.ndim == 1, array if array.ndim == 2 else array.reshape(1, width)


def square(values: Array) -> Array:
    """Rows as square matrices."""
    n = round(values.shape[1] ** 0.5)
    return values.reshape(len(values), n, n)


def scalar(values: Array) -> Array:
    """Rows of one number as numbers."""
    return values[:, 0]




@contextlib.contextmanager
def state_file(given: Union[Path, Mapping[str, Mapping[str, float]], None]) -> Iterator[Optional[Path]]:
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
            if isinstance(value, (int, float)) and not math.isfinite(value):
                raise _tripos.RequestError(f"`{name}` of [{table}] is {value}, and a state has finite numbers")
            lines.append(f"{json.dumps(name)} = {json.dumps(value)}")
    with tempfile.TemporaryDirectory(prefix="tripos-") as folder:
        file = pathlib.Path(folder) / "state.toml"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        yield file
