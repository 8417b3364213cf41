"""Models, and the functions of their equations on arrays."""

from __future__ import annotations

import contextlib
import importlib.util
import json
import math
import os
import pathlib
import re
import shutil
import sys
import tempfile
import types
import weakref
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Callable, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _tripos
from ._commands import Option, answer, text_of
from ._display import Markdown, Page, Picture

Array = NDArray[np.float64]
Path = Union[str, "os.PathLike[str]"]
#: Tables of a state: `{"state": {…}, "guess": {…}, "parameters": {…}}`, with numbers or formulas in quotes.
State = Mapping[str, Mapping[str, Union[float, str]]]

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
        return model

    @property
    def path(self) -> pathlib.Path:
        """File of the model. A model that was made from a text gets a file in a folder that goes with it."""
        if self._path is None:
            self._path = folder_of(self) / file_name(self.title) / "model.toml"
            self._path.parent.mkdir()
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
        about: Union[Path, State],
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
        from_: Union[Path, State, None] = None,
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

    def evaluate(self, at: Union[Path, State], by: str = "kane") -> Any:
        """Values of the equations at one state, as `tripos evaluate` has them."""
        with state_file(at) as file:
            return answer("evaluate", self.path, by=by, at=file)

    def latex(self, by: Optional[str] = None, *, fragment: bool = True, form: Optional[str] = None) -> str:
        """Equations as LaTeX: sections for a document, or a document."""
        return text_of("derive", self.path, by=by, format="latex", fragment=fragment, form=form)

    def markdown(self, by: Optional[str] = None, *, form: Optional[str] = None) -> Markdown:
        """Equations as Markdown with formulas, which notebooks show."""
        return Markdown(text_of("derive", self.path, by=by, format="markdown", form=form))

    def _repr_markdown_(self) -> str:
        """Equations by Kane's method, for a notebook."""
        return self.markdown("kane")._repr_markdown_()

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
        return self._model.value("mass_matrix", equations, parameters, q, u)

    def forcing(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Forcing f of M x = f, of the shape (n,) or (N, n)."""
        return self._model.value("forcing", equations, parameters, q, u)

    def accelerations(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Rates of the generalized speeds, of the shape (n,) or (N, n).

        >>> Model.from_text(EXAMPLE).accelerations([[0.0], [1.0]], [[0.0], [0.0]], g=1.0).round(6).tolist()
        [[0.0], [-0.841471]]
        """
        return self._model.value("accelerations", equations, parameters, q, u)

    def coordinate_rates(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Rates of the coordinates, W u + w."""
        return self._model.value("coordinate_rates", equations, parameters, q, u)

    def derivative(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Rates of the state (q, u)."""
        return self._model.value("derivative", equations, parameters, q, u)

    def jacobian(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Slopes of `derivative` along the state: a row for each rate."""
        return self._model.value("jacobian", equations, parameters, q, u)

    def kinetic_energy(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Kinetic energy, J."""
        return self._model.value("kinetic_energy", equations, parameters, q, u)

    def potential_energy(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Potential energy, J."""
        return self._model.value("potential_energy", equations, parameters, q, u)

    def power(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Power of the loads without a potential, W."""
        return self._model.value("power", equations, parameters, q, u)

    def constraints(self, q: ArrayLike, u: ArrayLike, *, equations: str = "kane", **parameters: float) -> Array:
        """Residuals of the loops and of the motion constraints."""
        return self._model.value("constraints", equations, parameters, q, u)

    def inverse(
        self, q: ArrayLike, u: ArrayLike, u_dot: ArrayLike, *, equations: str = "kane", **parameters: float
    ) -> Array:
        """Generalized forces that give the accelerations `u_dot` beside the forces of the model, M u_dot - f."""
        return self._model.value("inverse_dynamics", equations, parameters, q, u, u_dot)

    def regressor(self, q: ArrayLike, u: ArrayLike, u_dot: ArrayLike, **parameters: float) -> Array:
        """Regressor Y of the base parameters, of the shape (n, k) or (N, n, k): the generalized forces of a motion are
        Y pi + `regressor_rest`, with the `base_parameters` pi. Inputs that are forces count as 0.

        >>> model = Model.from_text(EXAMPLE)
        >>> pi = list(model.base_parameters().values())
        >>> state = ([0.5], [0.2], [0.1])
        >>> bool(np.allclose(model.regressor(*state) @ pi + model.regressor_rest(*state), model.inverse(*state)))
        True
        """
        whole: Array = self._model.regressor(parameters, q, u, u_dot)[..., :-1]
        return whole

    def regressor_rest(self, q: ArrayLike, u: ArrayLike, u_dot: ArrayLike, **parameters: float) -> Array:
        """Part of the generalized forces of a motion that no base parameter changes, of the shape (n,) or (N, n)."""
        rest: Array = self._model.regressor(parameters, q, u, u_dot)[..., -1]
        return rest

    def base_parameters(self, **parameters: float) -> dict[str, float]:
        """Values of the base parameters: the combinations of masses and inertias that motion can identify, by name.

        A value that no formula gives is NaN.
        """
        values = self._model.base_parameters(parameters)
        return {name: math.nan if value is None else value for name, value in values}

    def rhs(self, *, equations: str = "kane", **parameters: float) -> Callable[[float, ArrayLike], Array]:
        """Right-hand side f(t, y) of y' = f for `scipy.integrate.solve_ivp`, with y = (q, u)."""
        return self._of_state("derivative", equations, parameters)

    def rhs_jacobian(self, *, equations: str = "kane", **parameters: float) -> Callable[[float, ArrayLike], Array]:
        """Jacobian of `rhs`, for implicit methods of `solve_ivp`."""
        return self._of_state("jacobian", equations, parameters)

    def _of_state(self, name: str, equations: str, parameters: dict[str, float]) -> Callable[[float, ArrayLike], Array]:
        count, value = len(self.coordinates), self._model.value

        def function(t: float, y: ArrayLike) -> Array:
            state = np.asarray(y, dtype=float)
            return value(name, equations, parameters, state[:count], state[count:])

        return function

    def dae(self, *, equations: str = "kane", **parameters: float) -> Dae:
        """Equations as an implicit system F(t, y, y') = 0, for solvers such as IDA of SUNDIALS.

        The accelerations are not solved for: F is (q' - W u - w, M x - f). The state y is (q, u), followed by the
        reactions among the unknowns x, whose rates do not occur.

        >>> model = Model.from_text(EXAMPLE)
        >>> dae = model.dae()
        >>> y = [0.5, 0.2]
        >>> bool(abs(dae(0.0, y, model.rhs()(0.0, y))).max() < 1e-14)
        True
        """
        return Dae(self, equations, parameters)


class Dae:
    """Equations of motion as an implicit system F(t, y, y') = 0."""

    def __init__(self, model: Model, equations: str, parameters: dict[str, float]) -> None:
        self._value, self._equations, self._parameters = model._model.value, equations, parameters
        self._coordinates = len(model.coordinates)
        start = np.zeros(self._coordinates)
        self._variables = self._coordinates if equations == "lagrange" else len(model.speeds)
        unknowns = len(self._of("forcing", start, np.zeros(self._variables)))
        #: True for each number of the state whose rate occurs; False for reactions.
        self.is_differential: NDArray[np.bool_] = np.arange(self._coordinates + unknowns) < (
            self._coordinates + self._variables
        )

    def _of(self, name: str, q: Array, u: Array) -> Array:
        return self._value(name, self._equations, self._parameters, q, u)

    def __call__(self, t: float, y: ArrayLike, y_dot: ArrayLike) -> Array:
        """Residual F(t, y, y'), which is zero for a motion."""
        state, rates = np.asarray(y, dtype=float), np.asarray(y_dot, dtype=float)
        if state.shape != self.is_differential.shape or rates.shape != state.shape:
            raise _tripos.RequestError(f"y and y' have the shapes {state.shape} and {rates.shape}; give ({len(self.is_differential)},)")
        n = self._coordinates
        q, u = state[:n], state[n : n + self._variables]
        unknowns = np.concatenate([rates[n : n + self._variables], state[n + self._variables :]])
        kinematic = rates[:n] - self._of("coordinate_rates", q, u)
        return np.concatenate([kinematic, self._of("mass_matrix", q, u) @ unknowns - self._of("forcing", q, u)])


def folder_of(owner: object) -> pathlib.Path:
    """A new folder, which is removed when its owner is, or when Python ends."""
    folder = tempfile.mkdtemp(prefix="tripos-")
    weakref.finalize(owner, shutil.rmtree, folder, ignore_errors=True)
    return pathlib.Path(folder)


def file_name(title: str) -> str:
    """A title as the name of a file or folder.

    >>> file_name("Thin disk, sliding")
    'thin_disk_sliding'
    """
    return "_".join(re.findall(r"\w+", title.lower())) or "model"


def plain(value: Any) -> Any:
    """Numbers and arrays of NumPy as those of Python; other values as they are.

    >>> plain(np.int64(3)), plain(np.array([1.0, 2.0]))
    (3, [1.0, 2.0])
    """
    return value.tolist() if isinstance(value, (np.generic, np.ndarray)) else value


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
