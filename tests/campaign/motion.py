"""Motions of a mechanism: the oracle's equations, integrated by Dormand and Prince's method of order 8."""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from instant import Instant
from oracle import Equations, closed, equations, permitted

FINE, COARSE = 1e-12, 1e-9


class Lost(Exception):
    """The oracle cannot follow the motion."""


class Motion:
    """The motion from one start; `q`, `rates` at the end with an estimate of their errors."""
    def __init__(self, mechanism, q, rates, span, limit=2500, parameters=None, inputs=None, checked=True):
        self.m, self.names, self.calls, self.limit = mechanism, mechanism.coordinates, 0, limit
        self.parameters, self.inputs = parameters or mechanism.values(), inputs
        start = np.array([q[c] for c in self.names] + [rates[c] for c in self.names])
        self.fine = self.integrate(start, span, FINE, True)
        coarse = self.integrate(start, span, COARSE, False) if checked else self.fine
        end = self.fine.y[:, -1]
        self.q, self.rates = self.dictionaries(end)
        # The tenth part of the difference of the two runs bounds the error of the fine one with a wide margin, since
        # the tolerances differ by a thousand; rounding of the sums is added.
        self.error = np.abs(coarse.y[:, -1] - end) / 10 + 1e-12 * (1 + np.abs(end))
        self.onto_constraints(span[1])
        self.end = equations(mechanism, self.q, self.rates, span[1], self.parameters, inputs)

    def dictionaries(self, y):
        n = len(self.names)
        return dict(zip(self.names, map(float, y[:n]))), dict(zip(self.names, map(float, y[n:])))

    def integrate(self, start, span, tolerance, dense):
        try:
            result = solve_ivp(self.rate, span, start, "DOP853", rtol=tolerance, atol=tolerance / 10,
                               dense_output=dense)
        except (np.linalg.LinAlgError, FloatingPointError, ZeroDivisionError, ValueError) as error:
            raise Lost(str(error)) from error
        if result.status != 0 or not np.isfinite(result.y).all():
            raise Lost("the integration stopped")
        return result

    def rate(self, t, y):
        self.calls += 1
        if self.calls > self.limit:
            raise Lost("too many evaluations")
        q, rates = self.dictionaries(y)
        eq = Equations(Instant(self.m, q, rates, t, self.parameters, self.inputs))
        a = eq.solve()
        if not eq.condition < 1e9 or eq.smallest < 1e-7 or not np.isfinite(a).all():
            raise Lost("near a singular pose")
        return np.concatenate([y[len(self.names):], a])

    def onto_constraints(self, t):
        """The end on the constraints; what this moves counts as error."""
        q = closed(self.m, self.q, t, self.parameters)
        if q is None:
            raise Lost("the loops came apart")
        rates = permitted(self.m, q, self.rates, t, self.parameters)
        before = np.array([*self.q.values(), *self.rates.values()])
        after = np.array([*q.values(), *rates.values()])
        self.error = self.error + 10 * np.abs(after - before)
        self.q, self.rates = q, rates

    def at(self, t):
        """Equations at an instant of the motion, by the interpolation of its steps."""
        q, rates = self.dictionaries(self.fine.sol(t))
        return equations(self.m, q, rates, t, self.parameters, self.inputs)

    def spread(self, value):
        """Error of a number of the end that the errors of the state cause: the sum over all states."""
        total, here = 0.0, value(self.end)
        for k, name in enumerate([*self.names, *self.names]):
            step = max(self.error[k], 1e-9)
            q, rates = dict(self.q), dict(self.rates)
            (q if k < len(self.names) else rates)[name] += step
            there = value(equations(self.m, q, rates, self.fine.t[-1], self.parameters, self.inputs))
            total += abs(there - here) * self.error[k] / step
        return total

    def crossings(self, value, span):
        """Instants at which a number along the motion crosses zero, with the slopes there; `None` near a touch."""
        times = np.linspace(*span, 401)
        values = np.array([value(t) for t in times])
        near = 0.03 * np.abs(values).max()
        sizes = np.abs(values)
        for k in range(1, 400):
            least = sizes[k] <= min(sizes[k - 1], sizes[k + 1]) and sizes[k] < near
            if least and values[k - 1] * values[k + 1] > 0:
                return None
        if sizes[0] < near / 100 or sizes[-1] < near / 100:
            return None
        roots = []
        for a, b, fa, fb in zip(times, times[1:], values, values[1:]):
            if fa * fb < 0:
                t = brentq(value, a, b, xtol=1e-14, rtol=1e-14)
                h = 1e-4 * (span[1] - span[0])
                roots.append((t, (value(t + h) - value(t - h)) / (2 * h)))
        return roots
