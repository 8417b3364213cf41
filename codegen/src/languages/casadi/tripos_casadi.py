"""Functions, ordinary and differential-algebraic equations of CasADi from expressions of equations of motion."""

import casadi


def table(rows, columns, entries):
    """A matrix from its entries, row by row."""
    return casadi.reshape(casadi.vertcat(*entries), columns, rows).T


def function(name, body, arguments, lengths):
    """A casadi.Function of symbols with the names of the arguments; its results are `out` and, of a pair, `out_2`."""
    symbols = [casadi.SX.sym(argument, lengths[argument]) for argument in arguments]
    results = body(*symbols)
    results = list(results) if isinstance(results, tuple) else [results]
    return casadi.Function(name, symbols, results, arguments, ["out", "out_2"][: len(results)])


def ode(derivative, lengths, variables):
    """The equation x' = ode(x, p) of the state x = (q, motion variables)."""
    p, q = casadi.SX.sym("p", lengths["p"]), casadi.SX.sym("q", lengths["q"])
    v = casadi.SX.sym(variables, lengths[variables])
    return {"x": casadi.vertcat(q, v), "p": p, "ode": casadi.vertcat(*derivative(p, q, v))}


def dae(coordinate_rates, residual, lengths, variables):
    """The equations x' = ode(x, z, p), 0 = alg(x, z, p) with the unknowns z of the linear system."""
    p, q = casadi.SX.sym("p", lengths["p"]), casadi.SX.sym("q", lengths["q"])
    v, z = casadi.SX.sym(variables, lengths[variables]), casadi.SX.sym("z", lengths["x"])
    rates = casadi.vertcat(coordinate_rates(p, q, v), z[: lengths[variables]])
    return {"x": casadi.vertcat(q, v), "z": z, "p": p, "ode": rates, "alg": residual(p, q, v, z)}
