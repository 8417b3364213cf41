"""heyoka's Taylor method on the closed form of disk_loops.c, compiled for each tolerance: `heyoka_worker.py double | long`.

A worker of run.py. `long` computes in C's long double, of 80 bits on x86, from the start as the scene writes it. The worker also
computes a reference of its own in 128-bit numbers, by a method and an arithmetic that share nothing with the others.
"""

import sys

import heyoka as hy
import numpy as np
from closed_form import equations
from worker import PARAMETERS, SPAN, START, serve


TEXTS = ("10", "2", "45", "5", "1", "0.01", "-0.1", "0.02", "0.4", "0.1")


def exact(real):
    """The start as it is written, in these numbers."""
    degree = real("3.14159265358979323846264338327950288") / real(180)
    return np.array([real(text) * (degree if i < 3 else real(1)) for i, text in enumerate(TEXTS)], dtype=real)


class Taylor:
    def __init__(self, real, start, constants):
        self.real, self.start, self.constants = real, start, constants
        self.integrators = {}

    def prepare(self, tolerance):
        # What was compiled before, in this process or another, would hide how long it takes.
        hy.llvm_state.set_diskcache_enabled(False)
        hy.llvm_state.clear_memcache()
        options = dict(fp_type=self.real, tol=self.real(tolerance))
        self.integrators[tolerance] = hy.taylor_adaptive(equations(*self.constants), self.start, **options)
        integrator = self.integrators[tolerance]
        steps = self.propagate(integrator)
        # A step evaluates the derivatives of every order once.
        return steps, steps

    def propagate(self, integrator):
        integrator.time = self.real(0)
        integrator.state[:] = self.start
        outcome, _, _, steps, *_ = integrator.propagate_until(self.real(SPAN))
        assert outcome == hy.taylor_outcome.time_limit, outcome
        return steps

    def run(self, tolerance):
        integrator = self.integrators[tolerance]
        self.propagate(integrator)
        return integrator.state

    def reference(self, tolerance):
        """The start and g as they are written, to 33 digits."""
        real = hy.real128
        integrator = hy.taylor_adaptive(equations(real(1), real("9.81")), exact(real), fp_type=real, tol=real(tolerance))
        integrator.propagate_until(real(SPAN))
        return [float(x) for x in integrator.state]


def taylor(numbers):
    match numbers:
        case "double":
            return Taylor(float, np.array(START), PARAMETERS[1:])
        case "long":
            return Taylor(np.longdouble, exact(np.longdouble), (np.longdouble(1), np.longdouble("9.81")))


serve(taylor(sys.argv[1]))
