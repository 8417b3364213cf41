"""Checks functions that call planned ones against these: composed.py MODULE..., modules over NumPy or of CasADi."""

import importlib
import sys

import numpy

CLOSE = 1e-9


def close(name, found, expected, scale=1.0):
    found, expected = (numpy.asarray(x, dtype=float).reshape(-1) for x in (found, expected))
    assert found.shape == expected.shape, f"{name}: {found.shape} and {expected.shape}"
    size = 1.0 + numpy.abs(expected).max(initial=0.0) + scale
    assert (numpy.abs(found - expected) <= CLOSE * size).all(), f"{name}: {found} and {expected}"


def lengths(module):
    return [len(module.PARAMETERS), len(module.COORDINATES), len(module.VARIABLES), len(module.UNKNOWNS)]


def condition(matrix):
    return numpy.linalg.cond(matrix) if matrix.size else 1.0


def of_arrays(module, p, q, v, x):
    count = len(module.VARIABLES)
    tested = set()
    if hasattr(module, "state_derivative"):
        with numpy.errstate(all="ignore"):
            expected = numpy.concatenate(module.derivative(p, q, v))
            found = module.state_derivative(0.0, numpy.concatenate((q, v)), p)
        close("state_derivative", found, expected)
        tested.add("state_derivative")
    if condition(module.mass_matrix(p, q, v)) < 1e8:
        unknowns = module.unknowns(p, q, v)
        scale = numpy.abs(module.mass_matrix(p, q, v)).max(initial=0.0) * numpy.abs(unknowns).max(initial=0.0)
        close("unknowns", module.residual(p, q, v, unknowns), 0.0 * unknowns, scale)
        tested.add("unknowns")
        if hasattr(module, "reactions"):
            assert len(module.UNKNOWNS) > count
            close("reactions", module.reactions(p, q, v), unknowns[count:])
            tested.add("reactions")
    return tested


def of_expressions(module, p, q, v, x):
    import casadi

    count = len(module.VARIABLES)
    state = numpy.concatenate((q, v))
    call = lambda name, *given: [part.full().reshape(-1) for part in module.function(name).call(given)]
    tested = set()
    if hasattr(module, "ode"):
        problem = module.ode()
        found = casadi.Function("f", [problem["x"], problem["p"]], [problem["ode"]])(state, p)
        close("ode", found.full(), numpy.concatenate(call("derivative", p, q, v)))
        tested.add("ode")
    problem = module.dae()
    found = casadi.Function("f", [problem[n] for n in "xzp"], [problem["ode"], problem["alg"]])(state, x, p)
    close("dae: rates", found[0].full(), numpy.concatenate(call("coordinate_rates", p, q, v) + [x[:count]]))
    close("dae: residual", found[1].full(), call("residual", p, q, v, x)[0])
    tested.add("dae")
    matrix = module.function("mass_matrix")(p, q, v).full()
    if condition(matrix) < 1e8:
        expected = numpy.linalg.solve(matrix, call("forcing", p, q, v)[0])
        close("unknowns", call("unknowns", p, q, v)[0], expected)
        tested.add("unknowns")
        if hasattr(module, "reactions"):
            close("reactions", call("reactions", p, q, v)[0], expected[count:])
            tested.add("reactions")
    return tested


def main():
    random = numpy.random.default_rng(3)
    counts = {}
    for name in sys.argv[1:]:
        module = importlib.import_module(name)
        np, nq, nv, nx = lengths(module)
        given = random.uniform(0.2, 3, np), random.uniform(0.1, 1.4, nq), random.uniform(-2, 2, nv)
        check = of_expressions if hasattr(module, "dae") else of_arrays
        try:
            tested = check(module, *given, random.uniform(-3, 3, nx))
        except AssertionError as error:
            raise AssertionError(f"{name}: {error}") from error
        for function in tested:
            counts[function] = counts.get(function, 0) + 1
    for function, count in sorted(counts.items()):
        print(function, count)


main()
