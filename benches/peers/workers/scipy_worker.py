"""SciPy's DOP853 with a right-hand side that numba compiles: `ode` (compiled stepper) or `solve_ivp` (stepper in Python).

A worker of run.py. The right-hand side is the closed form of disk_loops.c, line by line, compiled before any run.
"""

import math
import sys

import numba
import numpy as np
import scipy.integrate
from worker import PARAMETERS, SPAN, START, serve

_, R, G = PARAMETERS
NO_LIMIT = 1_000_000


@numba.njit("float64[::1](float64, float64[::1])")
def rates(_t, y):
    s1, c1 = math.sin(y[0]), math.cos(y[0])
    s2, c2 = math.sin(y[1]), math.cos(y[1])
    r1, r2, r3 = y[5], y[6], y[7]
    a1 = -2 * r2 * r3 / c2
    a2 = (s2 * 4 * (G / R) + c2 * (r1 * (r1 * s2 + 2 * r3) - 4 * r2 * r2 * s2)) / (1 + 4 * s2 * s2)
    turn, carry = s2 * a1, c2 * r1 * r2
    radial = R * (s2 * (r1 * r1 + r2 * r2) - c2 * a2)
    across = R * (turn + 2 * carry)
    out = np.empty(10)
    for i in range(5):
        out[i] = y[5 + i]
    out[5] = a1
    out[6] = a2
    out[7] = -(turn + carry)
    out[8] = c1 * across - s1 * radial
    out[9] = c1 * radial + s1 * across
    return out


class Ode:
    start = np.array(START)

    def solver(self, tolerance, f=rates):
        solver = scipy.integrate.ode(f)
        return solver.set_integrator("dop853", rtol=tolerance, atol=tolerance, nsteps=NO_LIMIT)

    def prepare(self, tolerance):
        times, accepted = [], []

        def counted(t, y):
            times.append(t)
            return rates(t, y)

        self.solver(tolerance, counted).set_initial_value(self.start, 0.0).integrate(SPAN)
        # In a run of its own, since asking for every step adds evaluations. The start is among them.
        watched = self.solver(tolerance)
        watched.set_solout(lambda t, _y: accepted.append(t))
        watched.set_initial_value(self.start, 0.0).integrate(SPAN)
        steps, evaluations = len(accepted) - 1, len(times)
        # An accepted step takes 12 evaluations, a rejected one 11, the start 2.
        return steps + (evaluations - 2 - 12 * steps) // 11, evaluations

    def run(self, tolerance):
        return self.solver(tolerance).set_initial_value(self.start, 0.0).integrate(SPAN)


class SolveIvp:
    start = np.array(START)

    def solution(self, tolerance):
        span = (0.0, SPAN)
        return scipy.integrate.solve_ivp(rates, span, self.start, method="DOP853", rtol=tolerance, atol=tolerance)

    def prepare(self, tolerance):
        # It does not tell its rejected steps, but every attempt takes 12 evaluations, and the start 2.
        evaluations = int(self.solution(tolerance).nfev)
        return (evaluations - 2) // 12, evaluations

    def run(self, tolerance):
        return self.solution(tolerance).y[:, -1]


serve({"ode": Ode, "solve_ivp": SolveIvp}[sys.argv[1]]())
