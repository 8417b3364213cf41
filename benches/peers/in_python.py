#!/usr/bin/env python3
"""Runs of the disk as people write them in Python: the package tripos beside numba, heyoka and SymPy's functions.

Needs an installed package tripos, and numba, heyoka, scipy and sympy. Prints medians of interleaved runs, and each
divided by that of numba. Every run has the same start, span and tolerance; errors are those against a run at 1e-14.
"""

import statistics
import sys
import time
from pathlib import Path

import heyoka
import numba
import numpy as np
import sympy
from scipy.integrate import solve_ivp

import tripos

DISK = Path(__file__).resolve().parents[2] / "models/disk"
SPAN, RTOL, ATOL, ROUNDS = (0.0, 10.0), 1e-10, 1e-12, 15


def main() -> None:
    model = tripos.Model(DISK)
    equations = model.sympy()
    scene = tripos.Scene(DISK / "scenes/report-10s.toml")
    n = len(model.coordinates)
    exact = scene.simulate(by="kane", rtol=1e-13, atol=1e-15, method="taylor")
    start = np.array([exact.values[0][exact.names.index(name)] for name in [*model.coordinates, *model.speeds]])
    end = np.array([exact.end[name] for name in [*model.coordinates, *model.speeds]])

    names = [sympy.Symbol(name) for name in [*model.coordinates, *model.speeds]]
    values = {sympy.Symbol(name): parameter.default for name, parameter in model.parameters.items()}
    solved = {}
    for symbol, formula in equations.accelerations:
        solved[symbol] = sympy.sympify(formula).subs(solved)
    rates = [*equations.coordinate_rates, *(solved[symbol] for symbol in equations.unknowns)]
    # Symbols of the equations have assumptions; those of the users' functions have none.
    plain = {symbol: sympy.Symbol(str(symbol)) for symbol in set().union(*(e.free_symbols for e in rates))}
    rates = [e.subs(plain).subs(values) for e in rates]
    by_sympy = sympy.lambdify([names], rates, modules="math", cse=True)
    compiled = numba.njit(by_sympy)
    compiled(start)

    def in_numba(t, y):
        return np.array(compiled(y))

    symbols = heyoka.make_vars(*[str(name) for name in names])
    right = [heyoka.from_sympy(e) for e in rates]
    taylor = heyoka.taylor_adaptive(list(zip(symbols, right)), start.tolist(), tol=RTOL)

    def ivp(function):
        return solve_ivp(function, SPAN, start, method="DOP853", rtol=RTOL, atol=ATOL).y[:, -1]

    def by_heyoka():
        taylor.time, taylor.state[:] = 0.0, start
        taylor.propagate_until(SPAN[1])
        return taylor.state.copy()

    def of(run):
        return np.array([run.end[name] for name in [*model.coordinates, *model.speeds]])

    rhs = model.rhs()
    ways = {
        "solve_ivp, numba": lambda: ivp(in_numba),
        "solve_ivp, SymPy's function": lambda: ivp(lambda t, y: by_sympy(y)),
        "solve_ivp, model.rhs()": lambda: ivp(rhs),
        "heyoka, taylor_adaptive": by_heyoka,
        "scene.simulate, taylor, with digits": lambda: of(
            scene.simulate(by="kane", method="taylor", rtol=RTOL, atol=ATOL)
        ),
    }
    times = {way: [] for way in ways}
    errors = {}
    for _ in range(ROUNDS):
        for way, run in ways.items():
            begin = time.perf_counter()
            state = run()
            times[way].append(time.perf_counter() - begin)
            errors[way] = abs(state - end).max()
    base = statistics.median(times["solve_ivp, numba"])
    print("| way | time, ms | of numba's | error |\n|---|---|---|---|")
    for way, list_ in times.items():
        median = statistics.median(list_)
        print(f"| {way} | {median * 1e3:.2f} | {median / base:.2f} | {errors[way]:.1e} |")


if __name__ == "__main__":
    sys.exit(main())
