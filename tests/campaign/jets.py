"""Numbers and arrays with exact first and second derivatives (forward differentiation)."""
import numpy as np


class Jet:
    """An array `v` with its slopes `g[..., i]` and, unless it is `None`, its second derivatives `h[..., i, j]`."""
    __slots__ = ("v", "g", "h")
    __array_priority__ = 100

    def __init__(self, v, g, h=None):
        self.v, self.g, self.h = v, g, h

    @staticmethod
    def variable(value, index, size, second):
        """The variable number `index` of `size` variables."""
        g = np.zeros(size)
        g[index] = 1.0
        return Jet(np.float64(value), g, np.zeros((size, size)) if second else None)

    def constant(self, value):
        """An array without slopes, of the kind of this number."""
        value, size = np.asarray(value, float), self.g.shape[-1]
        h = None if self.h is None else np.zeros(value.shape + (size, size))
        return Jet(value, np.zeros(value.shape + (size,)), h)

    def lift(self, other):
        return other if isinstance(other, Jet) else self.constant(other)

    def __getitem__(self, index):
        index = index if isinstance(index, tuple) else (index,)
        return Jet(self.v[index], self.g[index], None if self.h is None else self.h[index])

    def __neg__(self):
        return Jet(-self.v, -self.g, None if self.h is None else -self.h)

    def __add__(self, o):
        o = self.lift(o)
        return Jet(self.v + o.v, self.g + o.g, None if self.h is None or o.h is None else self.h + o.h)

    __radd__ = __add__

    def __sub__(self, o):
        return self + (-self.lift(o))

    def __rsub__(self, o):
        return self.lift(o) - self

    def __mul__(self, o):
        o = self.lift(o)
        a, b = np.asarray(self.v), np.asarray(o.v)
        g = self.g * b[..., None] + o.g * a[..., None]
        h = None
        if self.h is not None and o.h is not None:
            cross = self.g[..., :, None] * o.g[..., None, :]
            h = self.h * b[..., None, None] + o.h * a[..., None, None] + cross + np.swapaxes(cross, -1, -2)
        return Jet(a * b, g, h)

    __rmul__ = __mul__

    def chain(self, value, slope, curvature):
        """A function of this number, by its value and its first two derivatives."""
        slope, curvature = np.asarray(slope), np.asarray(curvature)
        g = self.g * slope[..., None]
        h = None
        if self.h is not None:
            h = self.h * slope[..., None, None]
            h = h + curvature[..., None, None] * self.g[..., :, None] * self.g[..., None, :]
        return Jet(value, g, h)

    def __truediv__(self, o):
        o = self.lift(o)
        return self * o.chain(1 / o.v, -1 / o.v**2, 2 / o.v**3)

    def __rtruediv__(self, o):
        return self.lift(o) / self

    def __pow__(self, p):
        if isinstance(p, Jet):
            p = float(p.v)
        if p == 0:
            return self.constant(np.ones_like(self.v))
        if p == 1:
            return self
        if p == 2:
            return self * self
        if p == int(p):
            p = int(p)
        return self.chain(self.v**p, p * self.v**(p - 1), p * (p - 1) * self.v**(p - 2))

    def __rpow__(self, base):
        raise ValueError("a power with a variable exponent")

    def __matmul__(self, o):
        """Product of a matrix with a matrix or a vector."""
        o = self.lift(o)
        column = "" if o.v.ndim == 1 else "k"
        v = self.v @ o.v
        g = np.einsum(f"ijn,j{column}->i{column}n", self.g, o.v) + np.einsum(f"ij,j{column}n->i{column}n", self.v, o.g)
        h = None
        if self.h is not None and o.h is not None:
            cross = np.einsum(f"ijn,j{column}m->i{column}nm", self.g, o.g)
            h = np.einsum(f"ijnm,j{column}->i{column}nm", self.h, o.v) + cross + np.swapaxes(cross, -1, -2)
            h = h + np.einsum(f"ij,j{column}nm->i{column}nm", self.v, o.h)
        return Jet(v, g, h)

    @property
    def T(self):
        return Jet(self.v.T, np.swapaxes(self.g, 0, 1), None if self.h is None else np.swapaxes(self.h, 0, 1))

    def sum(self):
        return Jet(self.v.sum(), self.g.sum(axis=0), None if self.h is None else self.h.sum(axis=0))


def stack(parts):
    """One array of several numbers or arrays of equal shape; at least one of them is a `Jet`."""
    like = next(part for part in parts if isinstance(part, Jet))
    parts = [like.lift(part) for part in parts]
    h = None if any(part.h is None for part in parts) else np.stack([part.h for part in parts])
    return Jet(np.stack([np.asarray(part.v) for part in parts]), np.stack([part.g for part in parts]), h)


def cross(a, b):
    """Vector product of two vectors, of which at least one is a `Jet`."""
    a, b = (a, b) if isinstance(a, Jet) else (b.lift(a), b)
    b = a.lift(b)
    return stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def function(name, x):
    """A function of the expression language at a plain number or a `Jet`."""
    plain = not isinstance(x, Jet)
    v = x if plain else x.v
    value, slope, curvature = DERIVATIVES[name](v)
    return value if plain else x.chain(value, slope, curvature)


def _tangent(v):
    t = np.tan(v)
    return t, 1 + t * t, 2 * t * (1 + t * t)


def _quotient(numerator):
    """Secant (of cos) or cosecant (of sin) with derivatives."""
    def values(v):
        s, c = np.sin(v), np.cos(v)
        d, slope = (c, -s) if numerator == "sec" else (s, c)
        return 1 / d, -slope / d**2, 2 * slope**2 / d**3 + 1 / d
    return values


def _cotangent(v):
    t = 1 / np.tan(v)
    return t, -1 - t * t, 2 * t * (1 + t * t)


DERIVATIVES = {
    "sin": lambda v: (np.sin(v), np.cos(v), -np.sin(v)),
    "cos": lambda v: (np.cos(v), -np.sin(v), -np.cos(v)),
    "tan": _tangent, "cot": _cotangent, "sec": _quotient("sec"), "csc": _quotient("csc"),
    "sqrt": lambda v: (np.sqrt(v), 0.5 / np.sqrt(v), -0.25 / (np.sqrt(v) * v)),
    "exp": lambda v: (np.exp(v),) * 3,
    "log": lambda v: (np.log(v), 1 / v, -1 / v**2),
    "asin": lambda v: (np.arcsin(v), (1 - v * v)**-0.5, v * (1 - v * v)**-1.5),
    "acos": lambda v: (np.arccos(v), -(1 - v * v)**-0.5, -v * (1 - v * v)**-1.5),
    "atan": lambda v: (np.arctan(v), 1 / (1 + v * v), -2 * v / (1 + v * v)**2),
    "sinh": lambda v: (np.sinh(v), np.cosh(v), np.sinh(v)),
    "cosh": lambda v: (np.cosh(v), np.sinh(v), np.cosh(v)),
    "tanh": lambda v: (np.tanh(v), 1 - np.tanh(v)**2, -2 * np.tanh(v) * (1 - np.tanh(v)**2)),
    "abs": lambda v: (np.abs(v), np.sign(v), 0.0 * v),
    "sign": lambda v: (np.sign(v), 0.0 * v, 0.0 * v),
}
