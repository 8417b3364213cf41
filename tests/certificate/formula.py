"""Formulas of certificates, and their values: residues at a random point, or bounds of degrees and coefficients.

Used by check.py and kinematics.py in this folder, with the standard library of Python alone.
"""
import functools, hashlib, math, re
from fractions import Fraction

TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)|([^\W\d]\w*'*)|(\S))")
class Refused(Exception): pass
class NextPoint(Exception): pass


def need(holds, reason):
    if not holds: raise Refused(reason)


TREES = {}


def tree(kind, *parts):
    """The one tree with this kind and these parts: ("n", a), ("s", name), ("+", terms), ("*", pair), ("/", a, b),
    ("^", a, n) or (function, a)."""
    key = (kind, *(id(x) if isinstance(x, tuple) else x for x in (parts[0] if kind in ("+", "*") else parts)))
    return TREES.setdefault(key, (kind, *parts))


@functools.cache
def parse(text):
    """Tree of a formula in the language of model files."""
    tokens, at = TOKEN.findall(text) + [("", "", "")], [-1]
    def peek(): return tokens[at[0] + 1][2]
    def take(wanted=None):
        at[0] += 1
        need(at[0] < len(tokens) and wanted in (None, tokens[at[0]][2]), f"`{text[:80]}` is no formula")
        return tokens[at[0]]
    def negative(): return tree("*", (tree("n", Fraction(-1)), product()))
    def total():
        terms = [product()]
        while peek() in ("+", "-"): terms.append(product() if take()[2] == "+" else negative())
        return tree("+", tuple(terms)) if len(terms) > 1 else terms[0]
    def product():
        if peek() == "-": return take() and negative()
        value = power()
        while peek() in ("*", "/"):
            value = tree("*", (value, power())) if take()[2] == "*" else tree("/", value, power())
        return value
    def power():
        number, name, sign = take()
        base = tree("n", Fraction(number)) if number else tree("s", name)
        need(number or name not in ("n", "s") or peek() != "(", f"`{name}` is no function")
        if name and peek() == "(" or sign == "(":
            base = total() if sign else take() and tree(name, total())
            take(")")
        need(number or name or sign, f"`{text[:80]}` is no formula")
        if peek() != "^": return base
        sign = -1 if take() and peek() == "-" and take() else 1
        number = take()[0]
        need(number.isdigit() and len(number) < 4, f"`{text[:80]}` has an exponent that is no whole number below 1000")
        return tree("^", base, sign * int(number))
    value = total()
    need(at[0] == len(tokens) - 2, f"`{text[:80]}` is no formula")
    return value


class Residue:
    """Number modulo the prime P of the certificate."""
    __slots__, P = ("v",), 0
    def __init__(self, v): self.v = v % Residue.P
    def __add__(self, o): return Residue(self.v + o.v)
    def __sub__(self, o): return Residue(self.v - o.v)
    def __mul__(self, o): return Residue(self.v * o.v)
    def inverse(self):
        need(self.v, "a divisor vanishes identically")
        return Residue(pow(self.v, -1, Residue.P))


class Residues:
    """Values at one random point: the hash `seed` gives the values of all symbols; positive ones are squares."""
    def __init__(self, seed, positive): self.seed, self.positive, self.roots, self.angles = seed, positive, set(), {}
    def random(self, *what): return Residue(int.from_bytes(hashlib.sha512(self.seed + repr(what).encode()).digest()))
    def number(self, a): return Residue(a.numerator * (a.denominator == 1 or pow(a.denominator, -1, Residue.P)))
    def symbol(self, name): return self.random(name) * self.random(name) if name in self.positive else self.random(name)
    def circle(self, angle):
        t = self.random("angle", angle)
        n = (t * t + Residue(1)).inverse()
        return (Residue(1) - t * t) * n, (t + t) * n
    def root(self, x):
        r = Residue(pow(x.v, (Residue.P + 1) // 4, Residue.P))
        if (r * r).v != x.v: raise NextPoint
        self.roots.add(x.v)
        return r
    def opaque(self, f, x): return self.random(f, x.v)


class Bound:
    """Bounds of a fraction of polynomials with whole coefficients: degrees, and log2 of the sums of coefficients."""
    __slots__ = ("n", "d", "h", "k")
    def __init__(self, n, d, h, k): self.n, self.d, self.h, self.k = n, d, h, k
    def __add__(self, o):
        n, h = max(self.n + o.d, o.n + self.d), max(self.h + o.k, o.h + self.k) + 1
        return Bound(n, self.d + o.d, h, self.k + o.k)
    __sub__ = __add__
    def __mul__(self, o): return Bound(self.n + o.n, self.d + o.d, self.h + o.h, self.k + o.k)
    def inverse(self): return Bound(self.d, self.n, self.k, self.h)


class Bounds:
    """Degrees in the symbols, in sines and cosines, and in roots. `root_size` bounds the formulas under roots."""
    def __init__(self): self.root_size, self.angles = 1, {}
    def number(self, a): return Bound(0, 0, math.log2(abs(a.numerator) or 1), math.log2(a.denominator))
    def symbol(self, name): return Bound(1, 0, 0, 0)
    def circle(self, angle): return Bound(1, 0, 0, 0), Bound(1, 0, 0, 0)
    def root(self, x):
        self.root_size = max(self.root_size, 2 + x.n + x.d + int(x.h + x.k))
        return Bound(1, 0, 0, 0)
    def opaque(self, f, x): return Bound(1, 0, 0, 0)


def add(x, y): return x[0] + y[0], x[1] if y[1] is None else y[1] if x[1] is None else x[1] + y[1]
def mul(x, y): return x[0] * y[0], add((y[0], x[1] and x[1] * y[0]), (y[0], y[1] and x[0] * y[1]))[1]


class Scope:
    """Values (value, rate or None) of formulas: `symbols` has those of the motion, `named` the trees of named terms."""
    PARTS = 1
    def __init__(self, domain, symbols, named, divisors=None):
        need(not set(symbols) & set(named), "a named term has the name of a variable")
        self.domain, self.symbols, self.named, self.memo = domain, symbols, named, {}
        self.divisors = [] if divisors is None else divisors
    def __call__(self, text): return self.value(parse(text) if isinstance(text, str) else text)
    def number(self, a): return self.domain.number(Fraction(a)), None
    def value(self, e):
        if id(e) not in self.memo: self.memo[id(e)] = self.evaluated(e, *e[:2])
        return self.memo[id(e)]
    def evaluated(self, e, kind, a):
        if kind == "n": return self.number(a)
        if kind == "s":
            if a in self.named: return self.value(self.named[a])
            need(a[-1:].isidentifier() or a[-1:].isalnum() or a in self.symbols, f"a formula contains the rate {a}")
            need(a != "t" or a in self.symbols, "a formula contains the time, which is no coordinate")
            return self.symbols.get(a) or (self.domain.symbol(a), None)
        if kind in "+*":
            x = self.value(a[0])
            for b in a[1:]: x = (add if kind == "+" else mul)(x, self.value(b))
            return x
        if kind == "/": return mul(self.value(a), self.inverse(e[2]))
        if kind == "^":
            x = one = self.number(1)
            base = self.value(a) if e[2] > 0 else self.inverse(a)
            for _ in range(abs(e[2])): x = base if x is one else mul(x, base)
            return x
        return self.function(kind, a)
    def inverse(self, e):
        """The inverse of a tree, factor by factor; every factor that is no number is noted as a divisor."""
        if e[0] == "*": return functools.reduce(mul, map(self.inverse, e[1]))
        if e[0] == "/": return mul(self.inverse(e[1]), self.value(e[2]))
        if e[0] == "^": return self.value(tree("^", e[1], -e[2]))
        if e[0] == "tan": return self.value(tree("/", tree("cos", e[1]), tree("sin", e[1])))
        x = self.value(e)
        if e[0] != "n": self.divisors.append((e, x[0]))
        i = x[0].inverse()
        return i, x[1] and self.number(-1)[0] * i * i * x[1]
    def function(self, f, e):
        x, one = self.value(e), self.domain.number(Fraction(1))
        if f in ("sin", "cos", "tan"):
            c, s = self.angle(e)
            minus = self.domain.number(Fraction(-1)) * s
            if f == "tan":
                self.divisors.append((tree("cos", e), c))
                t = s * c.inverse()
                return t, x[1] and (one + t * t) * x[1]
            return (s, x[1] and c * x[1]) if f == "sin" else (c, x[1] and minus * x[1])
        if f == "sqrt":
            r = self.domain.root(x[0])
            return r, x[1] and x[1] * (r + r).inverse()
        y = self.domain.opaque(f, x[0])
        rates = {"sign": lambda: None, "abs": lambda: self.domain.opaque("sign", x[0]), "exp": lambda: y,
                 "ln": lambda: x[0].inverse(), "atan": lambda: (one + x[0] * x[0]).inverse()}
        need(f in rates, f"the function `{f}` is not known")
        return y, rates[f]() and x[1] and rates[f]() * x[1]
    def angle(self, e):
        """Cosine and sine of a sum of multiples of monomials, by the addition theorem."""
        known = self.domain.angles.get(e[1]) if e[0] == "s" and e[1] not in self.named else None
        if known: return known
        c, s = self.number(1)[0], None
        for monomial, k in self.polynomial(e).items():
            if monomial == ("pi",) and (2 * k).denominator == 1:
                for _ in range(int(2 * k) % 4): c, s = self.number(-1)[0] * (s or self.number(0)[0]), c
                continue
            need(k.denominator <= 2 and abs(k) < 64, f"the angle {e} has a part with the factor {k}")
            if (Scope.PARTS * k).denominator > 1:  # From here on, circles stand for half angles.
                Scope.PARTS = 2
                raise NextPoint
            k = int(Scope.PARTS * k)
            x, y = self.domain.circle(monomial)
            if k < 0: y = self.number(-1)[0] * y
            for _ in range(abs(k)):
                c, s = (c * x, c * y) if s is None else (c * x - s * y, s * x + c * y)
        if e[0] == "s" and e[1] not in self.named: self.domain.angles[e[1]] = c, s
        return c, s or self.number(0)[0]
    def polynomial(self, e):
        """The polynomial {monomial: coefficient} that a tree is; a part that is none counts as one symbol."""
        kind, a = e[:2]
        if kind == "s" and a in self.named: return self.polynomial(self.named[a])
        if kind == "n": return {(): Fraction(a)} if a else {}
        if kind == "^" and e[2] > 0: kind, a = "*", [a] * e[2]
        parts = [self.polynomial(b) for b in a] if kind in "+*" else []
        if kind == "/" and e[2][0] == "n": return {m: k / e[2][1] for m, k in self.polynomial(a).items()}
        total = dict(parts[0]) if parts else {(a if kind == "s" else repr(e),): Fraction(1)}
        for part in parts[1:]:
            products = [(tuple(sorted(m + n)), k * j) for m, k in total.items() for n, j in part.items()]
            pairs, total = (part.items(), total) if kind == "+" else (products, {})
            for m, k in pairs: total[m] = total.get(m, 0) + k
        return {m: k for m, k in total.items() if k}
