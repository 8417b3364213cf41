"""heyoka's Taylor method on the closed form of disk_loops.c, compiled for each tolerance.

A worker of run.py. It also computes a reference of its own in 128-bit numbers, by a method and an arithmetic that share nothing
with the others.
"""

import heyoka as hy
import numpy as np
from worker import PARAMETERS, SPAN, START, serve


def equations(R, g):
    """The closed form; R and g are numbers, which the compiler may use: as constants they are an advantage."""
    q1, q2, q3, q4, q5, r1, r2, r3, r4, r5 = hy.make_vars("q1", "q2", "q3", "q4", "q5", "r1", "r2", "r3", "r4", "r5")
    s1, c1, s2, c2 = hy.sin(q1), hy.cos(q1), hy.sin(q2), hy.cos(q2)
    a1 = -2.0 * r2 * r3 / c2
    a2 = (4.0 * (g / R) * s2 + c2 * (r1 * (r1 * s2 + 2.0 * r3) - 4.0 * r2 * r2 * s2)) / (1.0 + 4.0 * s2 * s2)
    turn, carry = s2 * a1, c2 * r1 * r2
    radial = R * (s2 * (r1 * r1 + r2 * r2) - c2 * a2)
    across = R * (turn + 2.0 * carry)
    return [
        (q1, r1), (q2, r2), (q3, r3), (q4, r4), (q5, r5),
        (r1, a1), (r2, a2), (r3, -(turn + carry)), (r4, c1 * across - s1 * radial), (r5, c1 * radial + s1 * across),
    ]  # fmt: skip


class Taylor:
    start = np.array(START)

    def __init__(self):
        self.integrators = {}

    def prepare(self, tolerance):
        # What was compiled before, in this process or another, would hide how long it takes.
        hy.llvm_state.set_diskcache_enabled(False)
        hy.llvm_state.clear_memcache()
        _, R, g = PARAMETERS
        self.integrators[tolerance] = hy.taylor_adaptive(equations(R, g), self.start, tol=tolerance)
        integrator = self.integrators[tolerance]
        steps = self.propagate(integrator)
        # A step evaluates the derivatives of every order once.
        return steps, steps

    def propagate(self, integrator):
        integrator.time = 0.0
        integrator.state[:] = self.start
        outcome, _, _, steps, *_ = integrator.propagate_until(SPAN)
        assert outcome == hy.taylor_outcome.time_limit, outcome
        return steps

    def run(self, tolerance):
        integrator = self.integrators[tolerance]
        self.propagate(integrator)
        return integrator.state

    def reference(self, tolerance):
        """The start and g as they are written, to 33 digits."""
        real = hy.real128
        degree = real("3.14159265358979323846264338327950288") / real(180)
        texts = ("10", "2", "45", "5", "1", "0.01", "-0.1", "0.02", "0.4", "0.1")
        start = np.array([real(text) * (degree if i < 3 else real(1)) for i, text in enumerate(texts)], dtype=real)
        integrator = hy.taylor_adaptive(equations(real(1), real("9.81")), start, fp_type=real, tol=real(tolerance))
        integrator.propagate_until(real(SPAN))
        return [float(x) for x in integrator.state]


serve(Taylor())
