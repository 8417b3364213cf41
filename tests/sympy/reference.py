#!/usr/bin/env python3
"""Equations of motion of a model file by SymPy alone: the independent truth of the tests.

    python3 reference.py MODEL.toml [-o FILE.json]

Reads the model file (docs/model.md) and derives kinematics, Kane's equations, Lagrange's equations and,
where the model allows it, the Newton-Euler equations with `sympy.physics.mechanics`. The result is JSON
whose expressions are strings in the grammar of the model file, its quantities named as in docs/publication.md.

Nothing is shared with the program under test but these two documents. Expressions are not simplified:
compare values, not forms. Exit status 2: the model is wrong or uses what is not supported here.

Three steps, in this order: `read_model` gives names a meaning, `Mechanism` places frames, points and
bodies and their motion (once in q and q', once in q and u), `derive` applies the formulations to it. The
first two and the grammar of expressions stand in files of their own beside this one.
"""

import argparse
import json
import os
import random
import sys
import tomllib
from pathlib import Path

# SymPy forgets all but a thousand results, which it asks for again where expressions are long: a seventh of its time.
os.environ.setdefault("SYMPY_CACHE_SIZE", "None")

import sympy  # noqa: E402
from sympy import Derivative, Matrix, Rational, Symbol  # noqa: E402
from sympy.core.function import AppliedUndef  # noqa: E402
from sympy.physics.mechanics import (  # noqa: E402
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Vector,
    dynamicsymbols,
    kinetic_energy,
    msubs,
    potential_energy,
)

sys.dont_write_bytecode = True  # The source tree stays as it is.
from grammar import Beyond, Unsupported, text  # noqa: E402
from mechanism import Body, Load, Mechanism  # noqa: E402
from model_file import read_model, read_tables  # noqa: E402

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
    """Lagrange's equations E q'' = A; all but gravity are generalized forces. Constraints have multipliers, of which a
    positive one acts along the slope of the constraint, and rows of their own."""
    lagrangian = Lagrangian(mechanism.inertial, *mechanism.parts)
    loads = mechanism.pairs(mechanism.applied())
    loops, motion = (list(model.loops.values()), [e for name, e in model.constrained.items() if name not in model.loops])
    method = LagrangesMethod(
        lagrangian,
        model.coordinates,
        forcelist=loads,
        frame=mechanism.inertial,
        hol_coneqs=loops or None,
        nonhol_coneqs=motion or None,
    )
    unknowns = [q.diff().diff() for q in model.coordinates]
    if not model.constrained:
        method.form_lagranges_equations()
        return system(unknowns, method.mass_matrix, method.forcing)
    rows = Matrix([*method.form_lagranges_equations(), *method.coneqs.diff(dynamicsymbols._t)])
    # SymPy's own multipliers pull the other way or this way, by version: their sign is read off.
    multipliers = list(method.lam_vec)
    slopes = method.coneqs.jacobian([q.diff() for q in model.coordinates])
    pulls = rows[: len(unknowns), :].jacobian(multipliers)
    sign = 1 if (pulls + slopes.T).applyfunc(sympy.trigsimp).is_zero_matrix else -1
    matrix = rows.jacobian(unknowns).row_join(sign * rows.jacobian(multipliers))
    named = [Symbol(f"lambda_{name}", real=True) for name in model.constrained]
    at_rest = {unknown: 0 for unknown in (*unknowns, *multipliers)}
    return system([*unknowns, *named], matrix, -msubs(rows, at_rest))


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
    """A moment on a frame is one on the body fixed in it; None if there is not exactly one, or no body is acted on."""
    if isinstance(load.target, Body):
        return load if load.target.part is not None else None
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
    head = {
        "model": path.resolve().parent.name if path.name == "model.toml" else path.stem,
        "text_hash": text_hash,
        "sympy": sympy.__version__,
    }
    try:
        return head | derived(tables)
    except Beyond as error:
        return head | {"not_derived": str(error)}


def derived(tables):
    """What is compared."""
    model = read_model(tables)
    placed = Mechanism(model, in_speeds=False)
    model = model.with_rates(placed.motion_constraints())
    moving = Mechanism(model, in_speeds=True)
    by_kane, active, inertial = kane(model, moving)
    quantities = kinematics(model, moving)
    quantities |= {f"F[{r + 1}]": e for r, e in enumerate(active)}
    quantities |= {f"Fstar[{r + 1}]": e for r, e in enumerate(inertial)}
    quantities |= {"T": kinetic_energy(moving.inertial, *moving.parts), "V_gravity": potential_energy(*moving.parts)}
    quantities |= {text(rate): value for rate, value in model.rates.items()}
    reference = {
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
