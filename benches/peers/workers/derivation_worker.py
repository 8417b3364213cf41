"""Derivation by another tool, `derivation_worker.py casadi|symengine|sympy|kane FOLDER`: a worker of run.py.

`kane` is SymPy's KanesMethod, from frames and points; the others get energies or positions (mechanics.py).
"""

import sys
import time
from pathlib import Path

import numpy as np
from derivation_counts import counted


class Casadi:
    """SX: Hessians and directional derivatives of the energies."""

    def __init__(self):
        import casadi
        import mechanics

        self.ca, self.mechanics = casadi, mechanics

    def derive(self, n, m):
        q, v, p, M, f = self.mechanics.of_casadi(n, m)
        # Shared subexpressions are found here: without, there are a quarter more operations.
        return self.ca.Function("equations", [q, v, p], [M, f], {"cse": True})

    def count(self, function):
        ca = self.ca
        ids = [function.instruction_id(k) for k in range(function.n_instructions())]
        calls = sum(i in (ca.OP_SIN, ca.OP_COS) for i in ids)
        return len(ids) - sum(i in (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST) for i in ids) - calls, calls

    def values(self, function, q, v, p):
        return [x.full() for x in function(q, v, p)]


class Symbolic:
    """symengine or SymPy: derivatives of energies, or of positions where that is faster."""

    def __init__(self, tool):
        import mechanics

        self.tool, self.mechanics = tool, mechanics

    def derive(self, n, m):
        return self.mechanics.of_symbols(self.tool, n, m)

    def count(self, derived):
        *_, M, f = derived
        return counted(self.tool, M, f)

    def values(self, derived, q, v, p):
        *symbols, M, f = derived
        point = dict(zip([s for group in symbols for s in group], [*q, *v, *p]))
        number = lambda e: float(self.tool.sympify(e).subs(point))
        return np.array([[number(e) for e in row] for row in M]), np.array([number(e) for e in f])


class Kane:
    """SymPy's KanesMethod."""

    def derive(self, n, m):
        import sympy_models

        return sympy_models.disk() if m == 3 else sympy_models.chain(n - 1)

    def count(self, derived):
        import sympy

        _, M, f, *_ = derived
        return counted(sympy, M.tolist(), list(f))

    def values(self, derived, q, v, p):
        symbols, M, f, numbers, _ = derived
        point = dict(zip(symbols, numbers(q, v, p)))
        return tuple(np.array(x.subs(point).evalf().tolist(), float) for x in (M, f))

    def accelerations(self, derived, q, v, rates):
        return derived[-1](q, v, rates)


def made(name):
    if name == "casadi":
        return Casadi()
    if name == "kane":
        return Kane()
    return Symbolic(__import__(name))


def main():
    tool, folder = made(sys.argv[1]), Path(sys.argv[2])
    for line in sys.stdin:
        match line.split():
            case ["derive", problem, repeats]:
                p, y = [[float(x) for x in line.split()] for line in (folder / problem / "states").open()][:2]
                n = len(y) // 2
                seconds = 0
                for _ in range(int(repeats)):
                    # What SymPy remembers of the derivation before would hide what this one takes.
                    if sympy := sys.modules.get("sympy"):
                        sympy.core.cache.clear_cache()
                    begin = time.perf_counter()
                    derived = tool.derive(n, len(p))
                    seconds += time.perf_counter() - begin
                answer = [seconds / int(repeats)]
            case ["count"]:
                answer = tool.count(derived)
            case ["solve"]:
                M, f = tool.values(derived, y[:n], y[n:], p)
                answer = np.linalg.solve(M, np.ravel(f))
                if hasattr(tool, "accelerations"):
                    answer = tool.accelerations(derived, y[:n], y[n:], answer)
            case _:
                sys.exit(f"not understood: {line.strip()}")
        print(*(repr(float(x)) for x in answer), flush=True)


main()
