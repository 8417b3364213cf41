"""Mechanisms built in code, which become the text of a model file."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Union

from ._arguments import Path, plain
from ._model import Model

#: Formula or number.
Formula = Union[str, int, float]
#: Value that a key of a model file may have; a key with None is left out.
Value = Union[Formula, bool, None, Sequence["Value"], Mapping[str, "Value"]]


class Mechanism:
    """A mechanism that is built element by element. Each method adds one element; names, units, keys and formulas are
    those of model files. `toml()` is the text, `model()` the model; errors name the line of this text.

    >>> m = Mechanism("Pendulum")
    >>> m.parameter("l", "m", 1, positive=True, about="length of the rod")
    >>> m.parameter("m", "kg", 2, positive=True)
    >>> m.parameter("g", "m/s^2", 9.81)
    >>> m.coordinate("theta", "rad")
    >>> m.speed("omega", "theta'")
    >>> m.inertial("N", "O")
    >>> m.frame("B", from_="N", axis=3, angle="theta")
    >>> m.point("P", from_="O", frame="B", position=[0, "-l", 0])
    >>> m.particle("bob", point="P", mass="m")
    >>> m.gravity("N", [0, "-g", 0])
    >>> m.model().mass_matrix([0.1], [0.0]).tolist()
    [[2.0]]
    """

    def __init__(self, name: str, source: str | None = None) -> None:
        self._head: dict[str, Value] = {"name": name} if source is None else {"name": name, "source": source}
        self._sections: dict[str, dict[str, Value]] = {}

    def parameter(
        self, name: str, unit: str, value: Formula | None = None, *, positive: bool = False, about: str = ""
    ) -> None:
        """Adds a parameter with its unit and, if given, its default value."""
        self._add("parameters", name, {"unit": unit, "value": value, "positive": positive or None, "about": about})

    def input(self, name: str, unit: str, value: Formula = 0.0, *, about: str = "") -> None:
        """Adds an input: a force, torque or other number that a controller sets."""
        self._add("inputs", name, {"unit": unit, "value": value, "about": about})

    def expression(self, name: str, formula: Formula | Mapping[str, Value]) -> None:
        """Adds a name for a formula, or for `{"value": …, "about": …}`."""
        self._add("expressions", name, formula)

    def coordinate(self, name: str, unit: str, about: str = "") -> None:
        """Adds a generalized coordinate."""
        self._add("coordinates", name, {"unit": unit, "about": about})

    def speed(self, name: str, definition: str) -> None:
        """Adds a generalized speed, defined as "theta'" or "omega(B) @ B [1]"."""
        self._add("speeds", name, definition)

    def inertial(self, frame: str, origin: str) -> None:
        """Names the inertial frame and its origin."""
        self._sections["inertial"] = {"frame": frame, "origin": origin}

    def gravity(self, frame: str, acceleration: Sequence[Formula], **keys: Value) -> None:
        """States the acceleration of free fall."""
        self._sections["gravity"] = {"frame": frame, "acceleration": acceleration, **keys}

    def frame(self, name: str, **keys: Value) -> None:
        """Adds a frame: `from_`, and `axis` with `angle`, or `sequence` with `angles`, or `euler_parameters`."""
        self._add("frames", name, keys)

    def point(self, name: str, **keys: Value) -> None:
        """Adds a point at a `position` in a `frame`, measured `from_` another point."""
        self._add("points", name, keys)

    def body(self, name: str, **keys: Value) -> None:
        """Adds a rigid body: `frame`, `centre`, `mass`, `inertia`."""
        self._add("bodies", name, keys)

    def particle(self, name: str, **keys: Value) -> None:
        """Adds a particle: `point`, `mass`."""
        self._add("particles", name, keys)

    def joint(self, name: str, **keys: Value) -> None:
        """Adds a joint between bodies: `kind`, `to`, `body` and the places of the joint on both."""
        self._add("joints", name, keys)

    def force(self, name: str, **keys: Value) -> None:
        """Adds a force: `on`, `at`, `frame`, `vector`."""
        self._add("forces", name, keys)

    def torque(self, name: str, **keys: Value) -> None:
        """Adds a torque: `on`, `frame`, `vector`."""
        self._add("torques", name, keys)

    def spring(self, name: str, **keys: Value) -> None:
        """Adds a spring between points: `stiffness`, `free_length`, `damping`."""
        self._add("springs", name, keys)

    def friction(self, name: str, **keys: Value) -> None:
        """Adds friction at a point or about an axis."""
        self._add("friction", name, keys)

    def potential(self, name: str, formula: Formula) -> None:
        """Adds a potential energy."""
        self._add("potentials", name, formula)

    def reaction(self, name: str, **keys: Value) -> None:
        """Names a reaction: `on`, `at`, `frame`, `direction`."""
        self._add("reactions", name, keys)

    def constraint(self, name: str, equation: str, **keys: Value) -> None:
        """Adds a constraint, as "x' = R*omega" or "z = 0"."""
        self._add("constraints", name, {"equation": equation, **keys})

    def rolling(self, name: str, **keys: Value) -> None:
        """Adds rolling without slip of a body at a point."""
        self._add("rolling", name, keys)

    def domain(self, name: str, condition: str) -> None:
        """Adds a condition that holds wherever the model is meant."""
        self._add("domain", name, condition)

    def shape(self, name: str, **keys: Value) -> None:
        """Adds a shape for pictures."""
        self._add("shapes", name, keys)

    def notation(self, name: str, latex: str) -> None:
        """States how a name is printed in LaTeX."""
        self._add("notation", name, latex)

    def toml(self) -> str:
        """Text of the model file."""
        lines = [f"{key} = {written(value)}" for key, value in self._head.items()]
        for section, elements in self._sections.items():
            lines += ["", f"[{section}]"]
            lines += [f"{word(name)} = {written(value)}" for name, value in elements.items()]
        return "\n".join(lines) + "\n"

    def save(self, path: Path) -> None:
        """Writes the model file. An existing file is overwritten."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.toml())

    def model(self) -> Model:
        """The model of the text."""
        return Model.from_text(self.toml())

    def _add(self, section: str, name: str, value: Value) -> None:
        elements = self._sections.setdefault(section, {})
        if name in elements:
            raise ValueError(f"[{section}] has `{name}` already")
        elements[name] = value


def word(name: str) -> str:
    """A key of TOML: bare if it may be, else quoted."""
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name, ensure_ascii=False)


def written(value: Value) -> str:
    """A value as TOML. Keys without a value are left out; a final underscore of a key is not written."""
    value = plain(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ValueError(f"{value} is no number of a model file")
        return repr(value)
    if isinstance(value, Mapping):
        kept = {key: plain(entry) for key, entry in value.items()}
        kept = {key: entry for key, entry in kept.items() if entry is not None and entry != ""}
        return "{ " + ", ".join(f"{word(key.rstrip('_'))} = {written(entry)}" for key, entry in kept.items()) + " }"
    if not isinstance(value, Iterable):
        raise ValueError(f"{value!r} cannot stand in a model file")
    entries = list(value)
    return "[" + ", ".join(written(entry) for entry in entries) + "]"
