#!/usr/bin/env python3
"""Equations of motion of a model file by SymPy alone: the independent truth of the tests.

    python3 reference.py MODEL.toml [-o FILE.json]

Reads the model file (docs/model.md) and derives kinematics, Kane's equations, Lagrange's equations and,
where the model allows it, the Newton-Euler equations with `sympy.physics.mechanics`. The result is JSON
whose expressions are strings in the grammar of the model file, its quantities named as in docs/report.md.

Nothing is shared with the program under test but these two documents. Expressions are not simplified:
compare values, not forms. Exit status 2: the model is wrong or uses what is not supported here.

Three steps, in this order: `read_model` gives names a meaning, `Mechanism` places frames, points and
bodies and their motion (once in q and q', once in q and u), `derive` applies the formulations to it.
"""

import argparse
import hashlib
import json
import random
import re
import sys
import tomllib
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import sympy
from sympy import Derivative, Matrix, Mul, Rational, Symbol, pi
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    Vector,
    dynamicsymbols,
    inertia,
    inertia_of_point_mass,
    kinetic_energy,
    msubs,
    potential_energy,
)


class Unsupported(Exception):
    """The model is wrong, or uses a feature that this script does not know."""


# ---------------------------------------------------------------------------------------------------
# Expressions: text to SymPy and back
# ---------------------------------------------------------------------------------------------------

FUNCTIONS = {
    "sin": sympy.sin,
    "cos": sympy.cos,
    "tan": sympy.tan,
    "sec": lambda x: 1 / sympy.cos(x),
    "csc": lambda x: 1 / sympy.sin(x),
    "cot": lambda x: sympy.cos(x) / sympy.sin(x),
    "sqrt": sympy.sqrt,
    "exp": sympy.exp,
    "log": sympy.log,
    "asin": sympy.asin,
    "acos": sympy.acos,
    "atan": sympy.atan,
    "sinh": sympy.sinh,
    "cosh": sympy.cosh,
    "tanh": sympy.tanh,
    "abs": sympy.Abs,
    "sign": sympy.sign,
}
WORDS = {f: word for word, f in FUNCTIONS.items() if word not in ("sec", "csc", "cot", "sqrt")}
TOKEN = re.compile(r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[A-Za-z]\w*'*|[-+*/^()])")
DEEPEST = 200


class Parser:
    """Recursive descent; `names` maps what may be named, primes included, to SymPy expressions."""

    def __init__(self, text, names):
        self.text, self.names, self.at = text, names, 0
        self.tokens = []
        place, end = 0, len(text.rstrip())
        while place < end:
            found = TOKEN.match(text, place)
            if not found:
                raise Unsupported(f"cannot read `{text[place:].strip()}` in `{text}`")
            self.tokens.append(found[1])
            place = found.end()

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, expected=""):
        token = self.peek()
        if not token or (expected and token != expected):
            raise Unsupported(f"`{expected or 'a value'}` is missing in `{self.text}`")
        self.at += 1
        return token

    def whole(self):
        value = self.sum()
        if self.peek():
            raise Unsupported(f"`{self.peek()}` is not expected in `{self.text}`")
        return value

    def sum(self):
        terms = [self.product()]
        while self.peek() in ("+", "-"):
            sign = 1 if self.take() == "+" else -1
            terms.append(sign * self.product())
        return sympy.Add(*terms)

    def product(self):
        value = self.signed()
        while self.peek() in ("*", "/"):
            divides = self.take() == "/"
            factor = self.signed()
            if divides and factor == 0:
                raise Unsupported(f"division by 0 in `{self.text}`")
            value = value / factor if divides else value * factor
        return value

    def signed(self):
        """Signs bind weaker than powers: -x^2 is -(x^2), while 2^-x is 2^(-x)."""
        if self.peek() in ("+", "-"):
            return self.signed() if self.take() == "+" else -self.signed()
        base = self.atom()
        if self.peek() == "^":
            self.take()
            return base ** self.signed()
        return base

    def atom(self):
        token = self.take()
        if token == "(" or token in FUNCTIONS:
            if token != "(":
                self.take("(")
            value = self.sum()
            self.take(")")
            return FUNCTIONS[token](value) if token in FUNCTIONS else value
        if token[0].isdigit() or token[0] == ".":
            return Rational(Fraction(token))
        if token == "pi":
            return pi
        try:
            return self.names[token]
        except KeyError:
            raise Unsupported(f"`{token}` may not stand in `{self.text}`") from None


def expression(value, names):
    """A string in the model file's grammar, or a number, as a SymPy expression."""
    if isinstance(value, str):
        return Parser(value, names).whole()
    if isinstance(value, (int, Fraction)) and not isinstance(value, bool):
        return Rational(value)
    raise Unsupported(f"`{value}` is not a formula")


def text(e):
    """A SymPy expression in the grammar of the model file."""
    line = term_text(sympy.sympify(e))
    depth = deepest = 0
    for c in line:
        depth += (c == "(") - (c == ")")
        deepest = max(deepest, depth)
    if deepest > DEEPEST:
        raise Unsupported(f"an expression nests {deepest} deep, more than {DEEPEST}")
    return line


def term_text(e):
    """The text of anything, right as an operand of a sum (a sum itself is not in parentheses)."""
    if e.is_Add:
        first, *rest = (term_text(term) for term in e.args)
        return first + "".join(f" - {term[1:]}" if term[0] == "-" else f" + {term}" for term in rest)
    if e.is_Mul or e.is_Rational or e.is_Pow:
        return product_text(e)
    if e.is_Symbol:
        return e.name
    if isinstance(e, AppliedUndef):
        return e.func.__name__
    if isinstance(e, Derivative) and isinstance(e.expr, AppliedUndef):
        return e.expr.func.__name__ + "'" * e.derivative_count
    if e is pi:
        return "pi"
    if e is sympy.E:
        return "exp(1)"
    if e.func in WORDS:
        return f"{WORDS[e.func]}({term_text(e.args[0])})"
    raise Unsupported(f"the grammar has no words for `{e}`")


def product_text(e):
    """A product, quotient, power or number: factors over the line, then those under it."""
    over, under, sign = [], [], ""
    for factor in Mul.make_args(e):
        if factor.is_Rational:
            sign = "-" if factor < 0 else ""
            over += [str(abs(factor.p))] if abs(factor.p) != 1 else []
            under += [str(factor.q)] if factor.q != 1 else []
        elif factor.is_Pow and factor.exp.is_Rational and factor.exp < 0:
            under.append(power_text(factor.base, -factor.exp))
        elif factor.is_Pow:
            over.append(power_text(factor.base, factor.exp))
        else:
            over.append(power_text(factor, sympy.S.One))
    line = sign + ("*".join(over) or "1")
    if len(under) > 1:
        return f"{line}/({'*'.join(under)})"
    return "/".join([line, *under])


def power_text(base, exponent):
    """A power of positive exponent, right as an operand of a product."""
    if exponent == Rational(1, 2):
        return f"sqrt({term_text(base)})"
    if not (exponent.is_Rational and exponent.q in (1, 2)):
        raise Unsupported(f"exponents must be whole or half numbers, not `{exponent}`")
    inner = term_text(base)
    plain = base.is_Symbol or base.is_Function or isinstance(base, Derivative)
    plain = plain or base is pi or (base.is_Integer and base >= 0)
    inner = inner if plain else f"({inner})"
    if exponent == 1:
        return inner
    return f"{inner}^{exponent}" if exponent.q == 1 else f"{inner}^({exponent})"


# ---------------------------------------------------------------------------------------------------
# The model file: what its names mean
# ---------------------------------------------------------------------------------------------------

# Keys of an entry of each section; "" is the file itself. What is not listed is not supported.
KEYS = {
    "": "name source parameters coordinates speeds inertial frames points bodies particles gravity"
    " forces torques reactions constraints domain",
    "parameters": "unit value positive about",
    "coordinates": "unit about",
    "inertial": "frame origin",
    "frames": "from axis angle about",
    "points": "from frame position about",
    "bodies": "frame centre mass inertia about",
    "inertia": "diagonal products frame about_point",
    "particles": "point mass about",
    "gravity": "frame acceleration zero_at about",
    "forces": "on at frame vector against against_at about",
    "torques": "on frame vector against about",
    "reactions": "kind on at frame direction against against_at about",
    "constraints": "equation enforced_by about",
}
SINGLE = ("inertial", "gravity")


def check_keys(entry, section, where):
    for key in entry:
        if key not in KEYS[section].split():
            raise Unsupported(f"`{key}` in {where} is not supported")


def read_tables(path):
    """The file's tables, decimals exact, and the hash of its bytes."""
    content = path.read_bytes()
    exact = lambda number: Fraction(number.replace("_", ""))
    tables = tomllib.loads(content.decode("utf-8-sig"), parse_float=exact)
    check_keys(tables, "", "the model file")
    for section, entries in tables.items():
        if section not in KEYS or section in ("", "inertia"):
            continue
        for name, entry in {section: entries}.items() if section in SINGLE else entries.items():
            check_keys(entry, section, f"[{section}.{name}]")
            check_keys(entry.get("inertia", {}), "inertia", f"inertia of `{name}`")
    return tables, hashlib.sha256(content).hexdigest()[:16]


@dataclass
class Model:
    """What names mean.

    `names_q` gives every name in terms of q and q', `names_u` in terms of q and u. `rates` maps each q'
    to its value in q and u, in the order of `coordinates`, which are those that no constraint fixes.
    """

    tables: dict
    coordinates: list
    speeds: list
    names_q: dict
    names_u: dict
    rates: dict
    zero_at: dict

    def section(self, name):
        return self.tables.get(name, {})


def read_model(tables):
    parameters = {
        name: Symbol(name, real=True, **({"positive": True} if entry.get("positive") else {}))
        for name, entry in tables.get("parameters", {}).items()
    }
    declared = {name: dynamicsymbols(name, real=True) for name in tables.get("coordinates", {})}
    solved = solve_constraints(tables, parameters, declared)
    coordinates = [q for q in declared.values() if q not in solved]
    names = dict(parameters)
    for name, q in declared.items():
        place = solved.get(q, q)
        names |= {name: place, name + "'": place.diff(dynamicsymbols._t)}

    definitions = {name: expression(formula, names) for name, formula in tables.get("speeds", {}).items()}
    speeds = [dynamicsymbols(name, real=True) for name in definitions]
    rates = solve_rates(coordinates, speeds, list(definitions.values()))
    names_u = {name: msubs(value, rates) for name, value in names.items()}
    zero = tables.get("gravity", {}).get("zero_at")
    if zero is not None:
        zero = {q: expression(zero.get(name, 0), parameters) for name, q in declared.items()}
    return Model(
        tables=tables,
        coordinates=coordinates,
        speeds=speeds,
        names_q=names | definitions,
        names_u=names_u | {name: u for name, u in zip(definitions, speeds)},
        rates=rates,
        zero_at=zero,
    )


def solve_constraints(tables, parameters, declared):
    """Holonomic constraints, each solved for the last coordinate that stands in it with a constant factor."""
    solved = {}
    names = parameters | declared
    everything = set(declared.values())
    for name, entry in tables.get("constraints", {}).items():
        sides = entry["equation"].split("=")
        if len(sides) != 2:
            raise Unsupported(f"the equation of constraint `{name}` must have one `=`")
        left, right = (expression(side, names) for side in sides)
        residual = sympy.expand((left - right).subs(solved))
        for q in reversed(declared.values()):
            factor = residual.diff(q)
            if q not in solved and factor != 0 and not factor.atoms(AppliedUndef) & everything:
                value = sympy.expand(q - residual / factor)
                solved = {other: place.subs(q, value) for other, place in solved.items()} | {q: value}
                break
        else:
            raise Unsupported(f"constraint `{name}` is not linear in a coordinate with a constant factor")
    return solved


def solve_rates(coordinates, speeds, definitions):
    """Each q' in terms of q and u, from u = C(q) q' + d(q)."""
    if len(coordinates) != len(speeds):
        raise Unsupported(f"{len(speeds)} speeds for {len(coordinates)} coordinates")
    plain = [Symbol(f"rate of {q.func.__name__}", real=True) for q in coordinates]
    to_plain = {q.diff(): rate for q, rate in zip(coordinates, plain)}
    formulas = Matrix([msubs(formula, to_plain) for formula in definitions])
    matrix = formulas.jacobian(plain).applyfunc(sympy.expand)
    if matrix.atoms(Symbol) & set(plain):
        raise Unsupported("a speed is not linear in the rates of the coordinates")
    right = Matrix(speeds) - formulas.subs({rate: 0 for rate in plain})
    values = {}
    for rows, columns in connected_blocks(matrix):
        block = matrix.extract(rows, columns)
        determinant = sympy.trigsimp(sympy.expand(block.det(method="berkowitz"))) if len(rows) == len(columns) else 0
        if determinant == 0:
            raise Unsupported(f"the speeds do not determine the rate of `{coordinates[columns[0]].func.__name__}`")
        solution = block.adjugate().applyfunc(sympy.trigsimp) * right.extract(rows, [0]) / determinant
        values |= {coordinates[column]: value for column, value in zip(columns, solution)}
    return {q.diff(): values[q] for q in coordinates}


def connected_blocks(matrix):
    """Rows and columns that belong together: the connected parts of the graph whose edges are the entries."""
    rows_left, blocks = set(range(matrix.rows)), []
    while rows_left:
        rows, columns, fresh = set(), set(), {min(rows_left)}
        while fresh:
            rows |= fresh
            columns |= {j for i in fresh for j in range(matrix.cols) if matrix[i, j] != 0}
            fresh = {i for i in rows_left - rows if any(matrix[i, j] != 0 for j in columns)}
        rows_left -= rows
        blocks.append((sorted(rows), sorted(columns)))
    return blocks


# ---------------------------------------------------------------------------------------------------
# The mechanism: frames, points, bodies and what acts on them
# ---------------------------------------------------------------------------------------------------


@dataclass
class Body:
    """A rigid body or particle; `basis` is the frame its components are stated in."""

    name: str
    part: object
    point: Point
    frame: ReferenceFrame | None
    basis: ReferenceFrame


@dataclass
class Load:
    """A force through the mass centre of `target` (a body) and a moment on it, or a moment on a frame."""

    target: object
    force: Vector
    moment: Vector


class Mechanism:
    """Frames, points and bodies with their motion.

    With `in_speeds` all velocities are written in q and u, else in q and q'. Accelerations are then in q, u
    and u'. The positions are the same.
    """

    def __init__(self, model, in_speeds):
        self.model = model
        self.names = model.names_u if in_speeds else model.names_q
        self.rates = model.rates if in_speeds else {}
        inertial = model.section("inertial")
        self.inertial = ReferenceFrame(inertial["frame"])
        self.origin = Point(inertial["origin"])
        self.frames = {inertial["frame"]: self.inertial}
        self.points = {inertial["origin"]: self.origin}
        self.position_names = model.names_q
        self.place_all("frames", self.frames, self.place_frame)
        self.place_all("points", self.points, self.place_point)
        self.set_motion()
        self.bodies = {name: self.rigid_body(name, entry) for name, entry in model.section("bodies").items()}
        self.bodies |= {name: self.particle(name, entry) for name, entry in model.section("particles").items()}
        self.set_potential()

    def place_all(self, section, known, place):
        """Entries may stand in any order: place those whose parent is known until none is left."""
        waiting = dict(self.model.section(section))
        while waiting:
            ready = [name for name, entry in waiting.items() if entry["from"] in known]
            if not ready:
                raise Unsupported(f"[{section}]: no path from the inertial one to {', '.join(waiting)}")
            for name in ready:
                known[name] = place(name, waiting.pop(name))

    def place_frame(self, name, entry):
        parent = self.frames[entry["from"]]
        frame = ReferenceFrame(name)
        if entry["axis"] not in (1, 2, 3):
            raise Unsupported(f"axis {entry['axis']} of frame `{name}`")
        axis = (parent.x, parent.y, parent.z)[entry["axis"] - 1]
        frame.orient_axis(parent, axis, expression(entry["angle"], self.position_names))
        return frame

    def place_point(self, name, entry):
        position = self.vector(entry["frame"], entry["position"], self.position_names)
        return self.points[entry["from"]].locatenew(name, position)

    def vector(self, frame, components, names=None):
        if len(components) != 3:
            raise Unsupported(f"a vector has three components, not {len(components)}")
        values = [expression(c, names or self.names) for c in components]
        basis = self.get(self.frames, frame)
        return sum((value * e for value, e in zip(values, (basis.x, basis.y, basis.z))), Vector(0))

    @staticmethod
    def get(table, name):
        if name not in table:
            raise Unsupported(f"`{name}` is not declared")
        return table[name]

    def set_motion(self):
        """Velocities and accelerations in the inertial frame, in terms of the speeds if those are wanted."""
        inertial = self.inertial
        frames = [frame for frame in self.frames.values() if frame is not inertial]
        spins = [(frame, msubs(frame.ang_vel_in(inertial), self.rates)) for frame in frames]
        velocities = [(p, msubs(p.pos_from(self.origin).dt(inertial), self.rates)) for p in self.points.values()]
        for frame, spin in spins:
            frame.set_ang_vel(inertial, spin)
        for frame, spin in spins:
            frame.set_ang_acc(inertial, msubs(spin.dt(inertial), self.rates))
        for point, velocity in velocities:
            point.set_vel(inertial, velocity)
            point.set_acc(inertial, msubs(velocity.dt(inertial), self.rates))

    def rigid_body(self, name, entry):
        frame, centre = self.get(self.frames, entry["frame"]), self.get(self.points, entry["centre"])
        mass = expression(entry["mass"], self.names)
        stated = entry["inertia"]
        basis = self.get(self.frames, stated.get("frame", entry["frame"]))
        diagonal, products = stated["diagonal"], stated.get("products", [0, 0, 0])
        dyadic = inertia(basis, *(expression(value, self.names) for value in (*diagonal, *products)))
        if "about_point" in stated:
            arm = self.get(self.points, stated["about_point"]).pos_from(centre).express(basis)
            dyadic -= inertia_of_point_mass(mass, arm, basis)
        part = RigidBody(name, centre, frame, mass, (dyadic, centre))
        return Body(name, part, centre, frame, basis)

    def particle(self, name, entry):
        point = self.get(self.points, entry["point"])
        part = Particle(name, point, expression(entry["mass"], self.names))
        return Body(name, part, point, None, self.inertial)

    def gravity(self):
        """The vector of free fall."""
        entry = self.model.section("gravity")
        return self.vector(entry["frame"], entry["acceleration"]) if entry else Vector(0)

    def set_potential(self):
        """V = -sum of m g.r, less its value at `zero_at` if that is given."""
        for body in self.bodies.values():
            v = -body.part.mass * self.gravity().dot(body.point.pos_from(self.origin))
            if self.model.zero_at is not None:
                v -= v.subs(self.model.zero_at)
            body.part.potential_energy = v

    @property
    def parts(self):
        return [body.part for body in self.bodies.values()]

    # What acts on the bodies.

    def weights(self):
        return [Load(body, body.part.mass * self.gravity(), Vector(0)) for body in self.bodies.values()]

    def applied(self):
        """The loads of [forces] and [torques]."""
        kinds = ((self.force, "forces"), (self.torque, "torques"))
        entries = ((act, entry) for act, section in kinds for entry in self.model.section(section).values())
        return sum((act(entry, self.vector(entry["frame"], entry["vector"])) for act, entry in entries), [])

    def reactions(self):
        """The name of each reaction, with the loads it exerts."""
        loads = {}
        for name, entry in self.model.section("reactions").items():
            symbol = Symbol(name, real=True)
            vector = symbol * self.vector(entry["frame"], entry["direction"])
            kind = entry.get("kind", "force")
            if kind not in ("force", "torque"):
                raise Unsupported(f"kind `{kind}` of reaction `{name}`")
            loads[symbol] = self.force(entry, vector) if kind == "force" else self.torque(entry, vector)
        return loads

    def force(self, entry, vector):
        """A force on a body at one of its points, and the opposite one on `against` (at the same point)."""
        on = self.get(self.bodies, entry["on"])
        at = self.get(self.points, entry["at"]) if "at" in entry else on.point
        loads = [self.force_at(on, at, vector)]
        if "against" in entry:
            against = self.get(self.bodies, entry["against"])
            there = against.point if against.frame is None else at
            there = self.get(self.points, entry["against_at"]) if "against_at" in entry else there
            loads.append(self.force_at(against, there, -vector))
        return loads

    @staticmethod
    def force_at(body, at, vector):
        """What a force at a point does to a body: the same through the mass centre, and its moment there."""
        moment = Vector(0) if body.frame is None else at.pos_from(body.point).cross(vector)
        return Load(body, vector, moment)

    def torque(self, entry, vector):
        loads = []
        for key, moment in (("on", vector), ("against", -vector)):
            name = entry.get(key)
            if name is None or self.frames.get(name) is self.inertial:
                continue
            target = self.bodies.get(name) or self.get(self.frames, name)
            loads.append(Load(target, Vector(0), moment))
        return loads

    @staticmethod
    def pairs(loads):
        """Loads as SymPy's methods take them: (point, force) and (frame, torque)."""
        pairs = []
        for load in loads:
            if isinstance(load.target, ReferenceFrame):
                pairs.append((load.target, load.moment))
                continue
            pairs.append((load.target.point, load.force))
            if load.target.frame is not None:
                pairs.append((load.target.frame, load.moment))
        return [(target, vector) for target, vector in pairs if vector != 0]


# ---------------------------------------------------------------------------------------------------
# Formulations
# ---------------------------------------------------------------------------------------------------


def system(unknowns, matrix, forcing):
    rows = [[text(matrix[i, j]) for j in range(matrix.cols)] for i in range(matrix.rows)]
    return {"unknowns": [text(u) for u in unknowns], "matrix": rows, "forcing": [text(f) for f in forcing]}


def kane(model, mechanism):
    """Kane's equations M u' = f, with F and F*."""
    equations = [rate - value for rate, value in model.rates.items()]
    method = KanesMethod(mechanism.inertial, model.coordinates, model.speeds, kd_eqs=equations)
    loads = mechanism.pairs(mechanism.weights() + mechanism.applied())
    active, inertial = method.kanes_equations(mechanism.parts, loads or None)
    unknowns = [u.diff() for u in model.speeds]
    return system(unknowns, method.mass_matrix, method.forcing), active, inertial


def lagrange(model, mechanism):
    """Lagrange's equations E q'' = A; all but gravity are generalized forces."""
    lagrangian = Lagrangian(mechanism.inertial, *mechanism.parts)
    loads = mechanism.pairs(mechanism.applied())
    method = LagrangesMethod(lagrangian, model.coordinates, forcelist=loads, frame=mechanism.inertial)
    method.form_lagranges_equations()
    unknowns = [q.diff().diff() for q in model.coordinates]
    return system(unknowns, method.mass_matrix, method.forcing)


def newton_euler(model, mechanism):
    """The balances of all bodies, m a = sum of forces and dH/dt = sum of moments.

    None if there are more or fewer balances than unknowns (the model does not name the reactions that its
    bodies feel; a free body feels none) or if a torque acts on a frame without a body.
    """
    reactions = mechanism.reactions()
    loads = sum(reactions.values(), mechanism.weights() + mechanism.applied())
    loads = [on_body(load, mechanism) for load in loads]
    if None in loads:
        return None
    accelerations = {u.diff(): Symbol(f"{u.func.__name__}'", real=True) for u in model.speeds}
    unknowns = [*accelerations.values(), *reactions]
    rows = Matrix([msubs(row, accelerations) for row in balances(mechanism, loads)])
    matrix = rows.jacobian(unknowns)
    forcing = -rows.subs({unknown: 0 for unknown in unknowns})
    kept = [i for i in range(len(rows)) if not all(vanishes(e) for e in (*matrix.row(i), forcing[i]))]
    if len(kept) != len(unknowns):
        return None
    return system(unknowns, matrix.extract(kept, range(len(unknowns))), forcing.extract(kept, [0]))


def on_body(load, mechanism):
    """A moment on a frame is one on the body fixed in it; None if there is not exactly one."""
    if isinstance(load.target, Body):
        return load
    fixed = [body for body in mechanism.bodies.values() if body.frame is load.target]
    return Load(fixed[0], load.force, load.moment) if len(fixed) == 1 else None


def balances(mechanism, loads):
    """For each body the components of m a - F, then those of dH/dt - M about the mass centre."""
    rows = []
    for body in mechanism.bodies.values():
        acting = [load for load in loads if load.target is body]
        momentum, angular = inertia_loads(mechanism, body)
        rows += components(momentum - sum((load.force for load in acting), Vector(0)), body.basis)
        if body.frame is not None:
            rows += components(angular - sum((load.moment for load in acting), Vector(0)), body.basis)
    return rows


def inertia_loads(mechanism, body):
    """m a and dH/dt of a body in the inertial frame."""
    inertial = mechanism.inertial
    momentum = body.part.mass * body.point.acc(inertial)
    if body.frame is None:
        return momentum, Vector(0)
    angular = body.part.central_inertia.dot(body.frame.ang_vel_in(inertial))
    return momentum, msubs(angular.dt(inertial), mechanism.rates)


def components(vector, basis):
    return [vector.dot(e) for e in (basis.x, basis.y, basis.z)]


def vanishes(e):
    """Whether an expression is zero identically: a value that is not zero disproves it, algebra proves it."""
    if e == 0:
        return True
    chance = random.Random(1)
    for _ in range(3):
        atoms = sorted(e.atoms(Symbol, AppliedUndef, Derivative) - {dynamicsymbols._t}, key=str)
        at = {atom: Rational(chance.randint(20, 180), 101) for atom in atoms}
        value = msubs(e, at).evalf(30, maxn=200)
        if value.is_number and abs(value) > sympy.Float("1e-20"):
            return False
    if sympy.trigsimp(sympy.expand(e)) == 0:
        return True
    raise Unsupported(f"cannot decide whether this is zero: {e}")


# ---------------------------------------------------------------------------------------------------
# The reference file
# ---------------------------------------------------------------------------------------------------


def triple(name, vector, basis):
    return {f"{name} @ {basis.name} [{i + 1}]": e for i, e in enumerate(components(vector, basis))}


def kinematics(model, mechanism):
    """Rotations, velocities, accelerations, partial velocities and inertia loads."""
    inertial, found = mechanism.inertial, {}
    for name, entry in model.section("frames").items():
        rotation = mechanism.frames[name].dcm(mechanism.frames[entry["from"]])
        for i, j in ((i, j) for i in range(3) for j in range(3)):
            found[f"rotation({entry['from']}, {name}) [{i + 1},{j + 1}]"] = rotation[i, j]
    for body in mechanism.bodies.values():
        point, basis = body.point, body.basis
        found |= with_partials(model, f"v({point.name})", point.vel(inertial), basis)
        found |= triple(f"a({point.name})", point.acc(inertial), basis)
        momentum, angular = inertia_loads(mechanism, body)
        found |= triple(f"Rstar({body.name})", -momentum, basis)
        if body.frame is not None:
            found |= with_partials(model, f"omega({body.frame.name})", body.frame.ang_vel_in(inertial), basis)
            found |= triple(f"alpha({body.frame.name})", body.frame.ang_acc_in(inertial), basis)
            found |= triple(f"Tstar({body.name})", -angular, basis)
    return found


def with_partials(model, name, vector, basis):
    """A velocity's components, and the derivative of each by each speed."""
    found = triple(name, vector, basis)
    partials = {f"d {key}/d {u.func.__name__}": e.diff(u) for key, e in found.items() for u in model.speeds}
    return found | partials


def derive(path):
    """The whole reference of a model file, as it is written."""
    tables, text_hash = read_tables(path)
    model = read_model(tables)
    moving, placed = Mechanism(model, in_speeds=True), Mechanism(model, in_speeds=False)
    by_kane, active, inertial = kane(model, moving)
    quantities = kinematics(model, moving)
    quantities |= {f"F[{r + 1}]": e for r, e in enumerate(active)}
    quantities |= {f"Fstar[{r + 1}]": e for r, e in enumerate(inertial)}
    quantities |= {"T": kinetic_energy(moving.inertial, *moving.parts), "V": potential_energy(*moving.parts)}
    quantities |= {text(rate): value for rate, value in model.rates.items()}
    reference = {
        "model": path.resolve().parent.name if path.name == "model.toml" else path.stem,
        "text_hash": text_hash,
        "sympy": sympy.__version__,
        "quantities": {name: text(e) for name, e in quantities.items()},
        "kane": by_kane,
        "lagrange": lagrange(model, placed),
    }
    balance = newton_euler(model, moving)
    return reference | ({"newton_euler": balance} if balance else {})


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("model", type=Path, help="a model file")
    arguments.add_argument("-o", "--output", type=Path, help="where to write; default: standard output")
    options = arguments.parse_args()
    sys.setrecursionlimit(10000)
    try:
        reference = derive(options.model)
    except (Unsupported, OSError, tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        print(f"{options.model}: {error}", file=sys.stderr)
        return 2
    except KeyError as error:
        print(f"{options.model}: {error} is missing", file=sys.stderr)
        return 2
    line = json.dumps(reference, indent=1, ensure_ascii=False) + "\n"
    if options.output:
        options.output.write_text(line, encoding="utf-8")
    else:
        sys.stdout.write(line)
    return 0


if __name__ == "__main__":
    sys.exit(main())
