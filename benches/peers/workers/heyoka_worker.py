"""heyoka's Taylor method on the closed form of disk_loops.c, compiled for each tolerance.

A worker of run.py. It also computes a reference of its own in 128-bit numbers, by a method and an arithmetic that share nothing
with the others.
"""

import heyoka as hy
import numpy as np
from closed_form import equations
from worker import PARAMETERS, SPAN, START, serve


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
