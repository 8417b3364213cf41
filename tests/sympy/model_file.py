"""The model file (docs/model.md): what its names mean.

`read_tables` reads the file, `read_model` gives names a meaning, once in q and q', once in q and u.
"""

import hashlib
import tomllib
from dataclasses import dataclass
from fractions import Fraction

import sympy
from sympy import Matrix, Symbol
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols, msubs

from grammar import Unsupported, expression

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
