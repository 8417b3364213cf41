"""The model file (docs/model.md): what its names mean.

`read_tables` reads the file, `read_model` gives names a meaning in q and q', `Model.with_rates` in q and u.
"""

import hashlib
import itertools
import random
import re
import tomllib
from dataclasses import dataclass, replace
from fractions import Fraction

import sympy
from sympy import Matrix, Rational, Symbol
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols, msubs

from grammar import WAVES, Beyond, Unsupported, expression
from low_level import low_level

# Keys of an entry of each section; "" is the file itself. What is not listed is not supported.
KEYS = {
    "": "schema name source parameters coordinates speeds inertial frames points bodies particles gravity"
    " forces torques springs potentials reactions constraints rolling domain shapes notation",
    "parameters": "unit value positive about",
    "coordinates": "unit about",
    "inertial": "frame origin",
    "frames": "from axis angle euler_parameters towards back about",
    "points": "from frame position about",
    "bodies": "frame centre mass inertia about",
    "inertia": "diagonal products frame about_point",
    "particles": "point mass about",
    "gravity": "frame acceleration zero_at about",
    "forces": "on at frame vector against against_at about",
    "torques": "on frame vector against about",
    "springs": "on at against against_at stiffness free_length damping about",
    "potentials": "value about",
    "reactions": "kind on at frame direction against against_at about",
    "constraints": "equation enforced_by about",
    "rolling": "body at against frame about",
}
SINGLE = ("inertial", "gravity")
TIME = "t"
# Operations.
MOST_TO_SIMPLIFY = 200
MOST_IN_RATES = 1000
TIMED = "speeds frames points forces torques springs potentials constraints reactions domain".split()


def check_keys(entry, section, where):
    for key in entry:
        if key not in KEYS[section].split():
            raise Unsupported(f"`{key}` in {where} is not supported")


def names_time(entry):
    """Whether a formula somewhere below names time."""
    if isinstance(entry, dict):
        return any(names_time(value) for key, value in entry.items() if key != "about")
    if isinstance(entry, list):
        return any(map(names_time, entry))
    return isinstance(entry, str) and TIME in re.findall(r"\w+", entry)


def equations_text(content):
    """The bytes of a model without the sections [shapes] and [notation] at their end, which no equation depends on."""
    headers = [match.start() for match in re.finditer(rb"^[ \t]*\[", content, re.M)]
    shapes = [at for at in headers if re.match(rb"\[(shapes[].]|notation])", content[at:])]
    if not shapes or headers[-len(shapes):] != shapes:
        return content
    rest = re.sub(rb"\n\n+$", b"\n", content[:shapes[0]])
    try:
        tomllib.loads(rest.decode("utf-8-sig"))
    except tomllib.TOMLDecodeError:
        return content
    return rest


def read_tables(path):
    """The file's tables, decimals exact, and the hash of their bytes."""
    content = equations_text(path.read_bytes())
    exact = lambda number: Fraction(number.replace("_", ""))
    tables = low_level(tomllib.loads(content.decode("utf-8-sig"), parse_float=exact))
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
    to its value in q and u, in the order of `coordinates`, which are those that no constraint fixes. `loops`
    are the equations between coordinates that fix none, `motion` the sides of those between velocities;
    `constrained` has all of the latter that are independent, with those of loops first, by name.
    """

    tables: dict
    coordinates: list
    speeds: list
    definitions: dict
    names_q: dict
    names_u: dict
    rates: dict
    zero_at: dict
    loops: dict
    motion: dict
    constrained: dict

    def section(self, name):
        return self.tables.get(name, {})

    def with_rates(self, stated):
        """With q' from the speeds and the motion constraints that are stated."""
        t = dynamicsymbols._t
        candidates = [(name, equation.diff(t)) for name, equation in self.loops.items()] + stated
        candidates += [(TIME, q.diff(t) - 1) for q in self.coordinates if q.func.__name__ == TIME]
        constrained = independent(self.coordinates, candidates)
        rates = solve_rates(self.coordinates, self.speeds, list(self.definitions.values()), list(constrained.values()))
        names_u = {name: msubs(value, rates) for name, value in self.names_q.items()}
        names_u |= {name: u for name, u in zip(self.definitions, self.speeds)}
        return replace(self, rates=rates, constrained=constrained, names_u=names_u)


def read_model(tables):
    """The model without rates, which motion constraints may decide: see `Model.with_rates`."""
    parameters = {
        name: Symbol(name, real=True, **({"positive": True} if entry.get("positive") else {}))
        for name, entry in tables.get("parameters", {}).items()
    }
    declared = {name: dynamicsymbols(name, real=True) for name in tables.get("coordinates", {})}
    if names_time([tables.get(section, {}) for section in TIMED]):
        # A coordinate that goes on by itself; SymPy's own time is what everything is differentiated by.
        declared[TIME] = dynamicsymbols(TIME, real=True)
    stated = {name: sides(name, entry) for name, entry in tables.get("constraints", {}).items()}
    motion = {name: both for name, both in stated.items() if any("'" in side or "@" in side for side in both)}
    configuration = {name: both for name, both in stated.items() if name not in motion}
    solved, loops = solve_constraints(configuration, parameters, declared)
    coordinates = [q for q in declared.values() if q not in solved]
    names = dict(parameters)
    for name, q in declared.items():
        place = solved.get(q, q)
        names |= {name: place, name + "'": place.diff(dynamicsymbols._t)}

    definitions = {name: expression(formula, names) for name, formula in tables.get("speeds", {}).items()}
    speeds = [dynamicsymbols(name, real=True) for name in definitions]
    zero = tables.get("gravity", {}).get("zero_at")
    if zero is not None:
        zero = {q: expression(zero.get(name, 0), parameters) for name, q in declared.items()}
    return Model(
        tables=tables,
        coordinates=coordinates,
        speeds=speeds,
        definitions=definitions,
        names_q=names | definitions,
        names_u={},
        rates={},
        zero_at=zero,
        loops=loops,
        motion=motion,
        constrained={},
    )


def sides(name, entry):
    both = entry["equation"].split("=")
    if len(both) != 2:
        raise Unsupported(f"the equation of constraint `{name}` must have one `=`")
    return both


def solve_constraints(stated, parameters, declared):
    """Constraints between coordinates, each solved for the last coordinate that stands in it with a constant factor, and
    those that cannot be."""
    solved, loops = {}, {}
    names = parameters | declared
    everything = set(declared.values())
    for name, (left, right) in stated.items():
        residual = sympy.expand((expression(left, names) - expression(right, names)).subs(solved))
        for q in (declared[name] for name in reversed(declared) if name != TIME):
            factor = residual.diff(q)
            if q not in solved and factor != 0 and not factor.atoms(AppliedUndef) & everything:
                value = sympy.expand(q - residual / factor)
                solved = {other: place.subs(q, value) for other, place in solved.items()} | {q: value}
                break
        else:
            loops[name] = residual
    return solved, {name: residual.subs(solved) for name, residual in loops.items()}


def independent(coordinates, candidates):
    """The equations between rates that do not follow from those before them."""
    plain = [Symbol(f"rate of {q.func.__name__}", real=True) for q in coordinates]
    to_plain = {q.diff(): rate for q, rate in zip(coordinates, plain)}
    kept, rows = {}, []
    for name, equation in candidates:
        row = Matrix([msubs(equation, to_plain)]).jacobian(plain)
        if row.atoms(Symbol) & set(plain):
            row = row.applyfunc(lambda e: sympy.trigsimp(sympy.expand(e)))
        if row.atoms(Symbol) & set(plain):
            raise Unsupported(f"the constraint `{name}` is not linear in the rates of the coordinates")
        if generic_rank(rows + [row]) > len(rows):
            rows.append(row)
            kept[name] = equation
    return kept


def generic_rank(rows):
    """The rank at a random rational point, in exact arithmetic but for functions, which have many digits."""
    matrix = Matrix.vstack(*rows)
    atoms = sorted(matrix.atoms(Symbol, AppliedUndef) - {dynamicsymbols._t}, key=str)
    chance = random.Random(1)
    at = {atom: Rational(chance.randint(20, 180), 101) for atom in atoms}
    values = msubs(matrix, at).evalf(50, maxn=200)
    return values.rank(iszerofunc=lambda e: abs(e) < sympy.Float("1e-30"))


def solve_rates(coordinates, speeds, definitions, constrained):
    """Each q' in terms of q and u, from u = C(q) q' + d(q) and A(q) q' + a(q) = 0."""
    if len(coordinates) < len(speeds) + len(constrained):
        raise Beyond(f"{len(constrained)} constraints of {len(coordinates)} rates while loops are open")
    if len(coordinates) != len(speeds) + len(constrained):
        raise Unsupported(f"{len(speeds)} speeds and {len(constrained)} constraints for {len(coordinates)} coordinates")
    plain = [Symbol(f"rate of {q.func.__name__}", real=True) for q in coordinates]
    to_plain = {q.diff(): rate for q, rate in zip(coordinates, plain)}
    formulas = Matrix([msubs(formula, to_plain) for formula in (*definitions, *constrained)])
    matrix = formulas.jacobian(plain).applyfunc(sympy.expand)
    if matrix.atoms(Symbol) & set(plain):
        raise Unsupported("a speed is not linear in the rates of the coordinates")
    right = Matrix([*speeds, *(0 for _ in constrained)]) - formulas.subs({rate: 0 for rate in plain})
    values = {}
    for rows, columns in solvable_blocks(matrix):
        block = matrix.extract(rows, columns)
        known = matrix.extract(rows, list(range(matrix.cols))) * Matrix([values.get(q, 0) for q in coordinates])
        determinant = block.det(method="berkowitz")
        if not determinant.has(*WAVES):
            determinant = tidy(determinant)
        if determinant.count_ops() > MOST_IN_RATES:
            raise Beyond(f"what determines {len(rows)} rates together has {determinant.count_ops()} operations")
        determinant = tidy(sympy.expand(determinant))
        if generic_rank([block]) < len(rows):
            raise Unsupported(f"the speeds do not determine the rate of `{coordinates[columns[0]].func.__name__}`")
        solution = block.adjugate().applyfunc(tidy) * (right.extract(rows, [0]) - known) / determinant
        values |= {coordinates[column]: value for column, value in zip(columns, solution)}
    operations = sum(value.count_ops() for value in values.values())
    if operations > MOST_IN_RATES:
        raise Beyond(f"the rates of the coordinates, without independent speeds of their own, have {operations} operations")
    return {q.diff(): values[q] for q in coordinates}


def tidy(e):
    """Simplified if that takes no time."""
    if not e.has(*WAVES):
        return sympy.cancel(e)
    return sympy.trigsimp(e) if e.count_ops() < MOST_TO_SIMPLIFY else e


def solvable_blocks(matrix):
    """Rows and the columns that they determine, once those of the blocks before are known: few rows at a time."""
    rows_left, known = list(range(matrix.rows)), set()
    while rows_left:
        sizes = range(1, len(rows_left) + 1)
        for rows in itertools.chain.from_iterable(itertools.combinations(rows_left, size) for size in sizes):
            columns = sorted({j for i in rows for j in range(matrix.cols) if matrix[i, j] != 0} - known)
            if len(columns) <= len(rows):
                break
        if len(columns) != len(rows):
            raise Unsupported("the speeds do not determine the rates of the coordinates")
        yield list(rows), columns
        rows_left = [row for row in rows_left if row not in rows]
        known |= set(columns)
