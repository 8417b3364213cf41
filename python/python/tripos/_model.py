"""Models, and the functions of their equations on arrays."""

from __future__ import annotations

import importlib.util
import math
import os
import pathlib
import sys
import tempfile
import types
from collections.abc import Sequence
from typing import Any, Callable, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _tripos
from ._arguments import (
    Array, Given, Path, State, equations_name, real_array, refuse_masks, values_of,
)  # fmt: skip
from ._commands import answer, text_of
from ._dae import Dae
from ._display import Markdown, Page, Picture
from ._files import Folder, file_name, state_file

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
    shape (n,) for one state, or (N, n) for N states. Parameters and inputs are keywords, or entries of the mapping
    `parameters`; the file's defaults fill the rest. The mapping can also name a parameter `equations` or `parameters`.
    `equations` names the equations that are evaluated: "kane", "lagrange", "newton-euler".

    Models can be copied and pickled. A pickled model is the path of its file, which is read again, or its text.
    """

    def __init__(self, path: Path) -> None:
        self._model = _tripos.Model.read(os.fspath(path))
        self._path: Optional[pathlib.Path] = pathlib.Path(path)
        self._folder: Optional[Folder] = None

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
        model._model, model._path, model._folder = inner, None, None
        return model

    def __copy__(self) -> Model:
        """A model with the same equations. A model never changes, and its copies share its temporary folder."""
        model = type(self)._of(self._model)
        model._path, model._folder = self._path, self._folder
        return model

    def __deepcopy__(self, memo: Any) -> Model:
        return self.__copy__()

    def __getstate__(self) -> dict[str, Optional[str]]:
        """State for `pickle`: the file of the model, or its text if it has no file."""
        if self._path is None:
            return {"path": None, "text": self.text}
        return {"path": os.fspath(self._path.absolute()), "text": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        path, text = state["path"], state["text"]
        self._model = _tripos.Model.parse(text) if path is None else _tripos.Model.read(path)
        self._path, self._folder = None if path is None else pathlib.Path(path), None

    @property
    def path(self) -> pathlib.Path:
        """File of the model. A model that was made from a text gets a file in a folder that goes with it."""
        if self._path is not None:
            return self._path
        name = f"{file_name(self.title)}/model.toml"
        if self._folder is None or not self._folder.path.is_dir():
            self._folder = Folder({name: self.text})
        return self._folder.path / name

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
            options: dict[str, Any] = {"from": at, "starts": starts, "over": list(over), "for": list(solve_for)}
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

        `accelerations` is an ordered list of pairs (symbol, formula). A formula may contain the symbols of earlier
        pairs: put these in, the last pair first, for a formula in the state alone.

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

    def mass_matrix(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Mass matrix M of M x = f, of the shape (n, n) or (N, n, n)."""
        return self._value("mass_matrix", equations, parameters, values, q, u)

    def forcing(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Forcing f of M x = f, of the shape (n,) or (N, n)."""
        return self._value("forcing", equations, parameters, values, q, u)

    def accelerations(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Rates of the generalized speeds, of the shape (n,) or (N, n).

        >>> Model.from_text(EXAMPLE).accelerations([[0.0], [1.0]], [[0.0], [0.0]], g=1.0).round(6).tolist()
        [[0.0], [-0.841471]]
        """
        return self._value("accelerations", equations, parameters, values, q, u)

    def coordinate_rates(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Rates of the coordinates, W u + w."""
        return self._value("coordinate_rates", equations, parameters, values, q, u)

    def derivative(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Rates of the state (q, u)."""
        return self._value("derivative", equations, parameters, values, q, u)

    def jacobian(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Slopes of `derivative` along the state: a row for each rate."""
        return self._value("jacobian", equations, parameters, values, q, u)

    def kinetic_energy(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Kinetic energy, J."""
        return self._value("kinetic_energy", equations, parameters, values, q, u)

    def potential_energy(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Potential energy, J."""
        return self._value("potential_energy", equations, parameters, values, q, u)

    def power(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Power of the loads without a potential, W."""
        return self._value("power", equations, parameters, values, q, u)

    def constraints(
        self, q: ArrayLike, u: ArrayLike, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Array:
        """Residuals of the loops and of the motion constraints."""
        return self._value("constraints", equations, parameters, values, q, u)

    def inverse(
        self,
        q: ArrayLike,
        u: ArrayLike,
        u_dot: ArrayLike,
        /,
        *,
        equations: str = "kane",
        parameters: Given = None,
        **values: float,
    ) -> Array:
        """Generalized forces that give the accelerations `u_dot` beside the forces of the model, M u_dot - f."""
        return self._value("inverse_dynamics", equations, parameters, values, q, u, u_dot)

    def regressor(
        self, q: ArrayLike, u: ArrayLike, u_dot: ArrayLike, /, *, parameters: Given = None, **values: float
    ) -> Array:
        """Regressor Y of the base parameters, of the shape (n, k) or (N, n, k): the generalized forces of a motion are
        Y pi + `regressor_rest`, with the `base_parameters` pi. Inputs that are forces count as 0.

        It holds in all poses, at all parameters. Where loops are closed, columns may depend on one another: `identify`
        tells which act only together there, at the values of the model file.

        >>> model = Model.from_text(EXAMPLE)
        >>> pi = list(model.base_parameters().values())
        >>> state = ([0.5], [0.2], [0.1])
        >>> bool(np.allclose(model.regressor(*state) @ pi + model.regressor_rest(*state), model.inverse(*state)))
        True
        """
        return self._regressor(parameters, values, q, u, u_dot)[..., :-1]

    def regressor_rest(
        self, q: ArrayLike, u: ArrayLike, u_dot: ArrayLike, /, *, parameters: Given = None, **values: float
    ) -> Array:
        """Part of the generalized forces of a motion that no base parameter changes, of the shape (n,) or (N, n)."""
        return self._regressor(parameters, values, q, u, u_dot)[..., -1]

    def base_parameters(self, /, *, parameters: Given = None, **values: float) -> dict[str, float]:
        """Values of the base parameters: the combinations of masses and inertias that motion can identify.

        Each key is the leading parameter of its combination alone; `identify()` has the whole formulas. A value that no
        formula gives is NaN.
        """
        found = self._model.base_parameters(values_of(parameters, values))
        return {name: math.nan if value is None else value for name, value in found}

    def rhs(
        self, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Callable[[float, ArrayLike], Array]:
        """Right-hand side f(t, y) of y' = f for `scipy.integrate.solve_ivp`, with y = (q, u).

        The function ignores t. A model that depends on the time has t as its last coordinate, so that y contains it.
        """
        return self._of_state("derivative", equations, values_of(parameters, values))

    def rhs_jacobian(
        self, /, *, equations: str = "kane", parameters: Given = None, **values: float
    ) -> Callable[[float, ArrayLike], Array]:
        """Jacobian of `rhs`, for implicit methods of `solve_ivp`."""
        return self._of_state("jacobian", equations, values_of(parameters, values))

    def _of_state(self, name: str, equations: str, values: dict[str, float]) -> Callable[[float, ArrayLike], Array]:
        count, value = len(self.coordinates), self._model.value
        # A wrong parameter or formulation fails here, and not in the solver.
        self._variables_of(name, equations, values)

        def function(t: float, y: ArrayLike) -> Array:
            state = real_array("y", y)
            return value(name, equations, values, state[:count], state[count:])

        return function

    def _value(
        self, name: str, equations: str, parameters: Given, values: dict[str, float], *arrays: ArrayLike
    ) -> Array:
        """Values of a function of the equations at the states in `arrays`: q, u and for some functions u_dot."""
        refuse_masks(arrays)
        if parameters is not None:
            values = values_of(parameters, values)
        return self._model.value(name, equations_name(equations), values, *arrays)

    def _regressor(self, parameters: Given, values: dict[str, float], *arrays: ArrayLike) -> Array:
        """Regressor with the rest as its last column."""
        refuse_masks(arrays)
        whole: Array = self._model.regressor(values_of(parameters, values), *arrays)
        return whole

    def _variables_of(self, name: str, equations: str, values: dict[str, float]) -> int:
        """Number of the motion variables that a function of the equations takes: generalized speeds or, for Lagrange's
        equations, rates of the coordinates. Wrong parameters are refused."""
        q, u = np.zeros(len(self.coordinates)), np.zeros(len(self.speeds))
        try:
            self._model.value(name, equations_name(equations), values, q, u)
        except _tripos.RequestError:
            self._model.value(name, equations, values, q, q)
            return len(q)
        return len(u)

    def dae(self, /, *, equations: str = "kane", parameters: Given = None, **values: float) -> Dae:
        """Equations as an implicit system F(t, y, y') = 0, for solvers such as IDA of SUNDIALS.

        The accelerations are not solved for: F is (q' - W u - w, M x - f). The state y is (q, u), followed by the
        reactions among the unknowns x, whose rates do not occur.

        >>> model = Model.from_text(EXAMPLE)
        >>> dae = model.dae()
        >>> y = [0.5, 0.2]
        >>> bool(abs(dae(0.0, y, model.rhs()(0.0, y))).max() < 1e-14)
        True
        """
        given = values_of(parameters, values)
        variables = self._variables_of("forcing", equations, given)

        def value(name: str, q: Array, u: Array) -> Array:
            return self._model.value(name, equations, given, q, u)

        return Dae(value, len(self.coordinates), variables)
