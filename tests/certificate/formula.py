"""Formulas of certificates, and their values: residues at a random point, or bounds of degrees and coefficients.

Used by check.py and kinematics.py in this folder, with the standard library of Python alone.
"""
import functools, hashlib, math, re
from fractions import Fraction

TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?(?:[eE][+-]?\d{1,3})?)|([^\W\d]\w*'*)|(\S))")
SMALL = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31)  # Modulo the prime of a certificate, these are squares.
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


def over(a, b): return tree("/", a, b)


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
            value = tree("*", (value, power())) if take()[2] == "*" else over(value, power())
        return value
    def power():
        digits, name, sign = take()
        base = tree("n", Fraction(digits)) if digits else tree("s", name)
        need(digits or name not in ("n", "s") or peek() != "(", f"`{name}` is no function")
        if name and peek() == "(" or sign == "(":
            take() if name else None
            parts = [total()]
            while name and peek() == ",": parts.append(take() and total())
            take(")")
            base = parts[0] if sign else tree(name, *parts)
        need(digits or name or sign, f"`{text[:80]}` is no formula")
        if peek() != "^": return base
        sign = -1 if take() and peek() == "-" and take() else 1
        digits = take()[0]
        need(digits.isdigit() and len(digits) < 4, f"`{text[:80]}` has an exponent that is no whole number below 1000")
        return tree("^", base, sign * int(digits))
    value = total()
    need(at[0] == len(tokens) - 2, f"`{text[:80]}` is no formula")
    return value


def is_small(e):
    """True for a written number. Roots of other primes than small ones may not exist, or have either sign."""
    if e[0] == "/": return is_small(e[1]) and is_small(e[2])
    if e[0] == "n": need(e[1] and not pow(math.prod(SMALL), 999, e[1].numerator * e[1].denominator), f"a root of {e[1]}")
    return e[0] == "n"


def expanded(value, numbers):
    """A part of a model with its repeated entries, such as "K{i in 1..7}", written out."""
    if isinstance(value, str):
        number = lambda m: str(sum((-1 if s == "-" else 1) * numbers.get(x, 0) if x in numbers else int(s + x)
                                   for s, x in re.findall(r"([+-]?)\s*(\w+)", m[1])))
        return re.sub(r"\{([^{}]*)\}", number, value)
    if isinstance(value, list): return [expanded(x, numbers) for x in value]
    if not isinstance(value, dict): return value
    out = {}
    for key, x in value.items():
        loop = re.search(r"\{(\w+) in (\w+)\.\.(\w+)\}", key)
        if not loop: out[key if "{" not in key else expanded(key, numbers)] = expanded(x, numbers)
        else:
            first, last = (int(numbers.get(n, n)) for n in loop.groups()[1:])
            for i in range(first, last + 1):
                need("{" not in key.replace(loop[0], "", 1), f"not checked: the repetition {key}")
                out[key.replace(loop[0], str(i))] = expanded(x, {**numbers, loop[1]: i})
    return out


class Residue:
    """Number modulo the prime P of the certificate."""
    __slots__, P = ("v",), 0
    def __init__(self, v): self.v = v % Residue.P
    def __add__(self, o): return Residue(self.v + o.v)
    def __sub__(self, o): return Residue(self.v - o.v)
    def __mul__(self, o): return Residue(self.v * o.v)
    def inverse(self, factor=None):
        need(self.v, "a divisor vanishes identically")
        return Residue(pow(self.v, -1, Residue.P))


class Residues:
    """Values at one random point: the hash `seed` gives the values of all symbols; positive ones are squares. Roots
    have random signs if `are_signed`; the dictionary `roots` numbers the values under them."""
    def __init__(self, seed, positive, are_signed=True):
        self.seed, self.positive, self.are_signed, self.roots, self.angles = seed, positive, are_signed, {}, {}
    def random(self, *what): return Residue(int.from_bytes(hashlib.sha512(self.seed + repr(what).encode()).digest()))
    def number(self, a): return Residue(a.numerator * (a.denominator == 1 or pow(a.denominator, -1, Residue.P)))
    def symbol(self, name): return self.random(name) * self.random(name) if name in self.positive else self.random(name)
    def circle(self, angle):
        t = self.random("angle", angle)
        n = (t * t + Residue(1)).inverse()
        return (Residue(1) - t * t) * n, (t + t) * n
    def root(self, x, is_number=False):
        r = Residue(pow(x.v, (Residue.P + 1) // 4, Residue.P))
        at = None if is_number else self.roots.setdefault(x.v, len(self.roots))
        if (r * r).v != x.v: raise NextPoint(at)
        return Residue(0) - r if self.are_signed and not is_number and self.random("root", x.v).v % 2 else r
    def name(self, x, tree): return f"{x.v}"
    def opaque(self, f, x):
        is_odd = f in ("sign", "atan", "asin", "sinh", "tanh")
        y = self.random(f, min(x.v, Residue.P - x.v) if is_odd or f == "cosh" else x.v)
        return Residue(0) - y if is_odd and 2 * x.v > Residue.P else y
    def along(self, y, slope, x): return y


class Bound:
    """Bounds of a polynomial with whole coefficients over a product of factors: degree `n`, log2 `h` of the sum of the
    coefficients' sizes, and the exponents `d` of the factors, each with its own degree and size in FACTORS."""
    __slots__, FACTORS = ("n", "h", "d"), {}
    def __init__(self, n, h, d=None): self.n, self.h, self.d = n, h, d or {}
    def over(self, d):
        """Degree and size of the numerator over a common denominator."""
        n, h = self.n, self.h
        for f, k in d.items() if d is not self.d else ():
            more = k - self.d.get(f, 0)
            if more: n, h = n + more * Bound.FACTORS[f][0], h + more * Bound.FACTORS[f][1]
        return n, h
    def __add__(self, o):
        d = self.d
        if o.d is not d and o.d != d: d = {f: max(d.get(f, 0), o.d.get(f, 0)) for f in {**d, **o.d}}
        (n, h), (m, k) = self.over(d), o.over(d)
        return Bound(max(n, m), max(h, k) + math.log2(1 + 2.0 ** -min(abs(h - k), 50)), d)
    __sub__ = __add__
    def __mul__(self, o):
        d = self.d and o.d and {f: self.d.get(f, 0) + o.d.get(f, 0) for f in {**self.d, **o.d}}
        return Bound(self.n + o.n, self.h + o.h, d or self.d or o.d)
    def inverse(self, factor=None):
        factor = (factor or self, self.n, self.h)
        Bound.FACTORS[factor] = self.n, self.h
        n, h = Bound(0, 0).over(self.d)
        return Bound(n, h, {factor: 1})


class Bounds:
    """Degrees in the symbols, in sines and cosines, and in roots. `root_size` bounds the formulas under roots."""
    def __init__(self): self.root_size, self.angles, Bound.FACTORS = 1, {}, {}
    def number(self, a):
        top = Bound(0, math.log2(abs(a.numerator) or 1))
        return top if a.denominator == 1 else top * Bound(0, math.log2(a.denominator)).inverse(a.denominator)
    def symbol(self, name): return Bound(1, 0)
    def circle(self, angle): return Bound(1, 0), Bound(1, 0)
    def root(self, x, is_number=False):
        n, h = Bound(0, 0).over(x.d)
        self.root_size = max(self.root_size, 2 + x.n + n + int(x.h + h))
        return Bound(1, 0)
    def name(self, x, tree): return f"{id(tree)}"
    def opaque(self, f, x): return Bound(1, 0)
    def along(self, y, slope, x): return y


def add(x, y): return x[0] + y[0], x[1] if y[1] is None else y[1] if x[1] is None else x[1] + y[1]
def mul(x, y): return x[0] * y[0], add((y[0], x[1] and x[1] * y[0]), (y[0], y[1] and x[0] * y[1]))[1]
def turned(x, y): return x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]


def repeated(product, x, n):
    """The product of n > 0 factors x."""
    y = None
    while n:
        if n % 2: y = x if y is None else product(y, x)
        n //= 2
        if n: x = product(x, x)
    return y


class Scope:
    """Values (value, rate or None) of formulas: `symbols` has those of the motion, `named` the trees of named terms."""
    PARTS = 1  # Circles stand for angles divided by this number.
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
            base = self.value(a) if e[2] > 0 else self.inverse(a)
            return repeated(mul, base, abs(e[2])) if e[2] else self.number(1)
        return self.function(kind, *e[1:])
    def inverse(self, e):
        """The inverse of a tree, factor by factor; every factor that is no number is noted as a divisor."""
        if e[0] == "*": return functools.reduce(mul, map(self.inverse, e[1]))
        if e[0] == "/": return mul(self.inverse(e[1]), self.value(e[2]))
        if e[0] == "^": return self.value(tree("^", e[1], -e[2]))
        if e[0] == "tan": return self.value(over(tree("cos", e[1]), tree("sin", e[1])))
        x = self.value(e)
        if e[0] != "n": self.divisors.append((e, x[0]))
        i = x[0].inverse((id(e), self))
        return i, x[1] and self.number(-1)[0] * i * i * x[1]
    def function(self, f, e):
        if f == "tan": return mul(self.value(tree("sin", e)), self.inverse(tree("cos", e)))
        if f == "abs": return mul(self.value(e), self.value(tree("sign", e)))
        domain, x, one = self.domain, self.value(e), self.domain.number(Fraction(1))
        minus, half = domain.number(Fraction(-1)), domain.number(Fraction(1, 2))
        if f in ("sin", "cos"):
            c, s = self.angle(e)
            c, s = domain.along(c, lambda: minus * s, x[0]), domain.along(s, lambda: c, x[0])
            return (s, x[1] and c * x[1]) if f == "sin" else (c, x[1] and minus * s * x[1])
        slopes = {"sqrt": lambda: half * y.inverse(), "sign": lambda: one - one, "log": lambda: x[0].inverse(),
                  "exp": lambda: y, "atan": lambda: (one + x[0] * x[0]).inverse(), "tanh": lambda: one - y * y,
                  "sinh": lambda: domain.opaque("cosh", x[0]), "cosh": lambda: domain.opaque("sinh", x[0]),
                  "asin": lambda: domain.root(one - x[0] * x[0]).inverse(),
                  "acos": lambda: minus * domain.root(one - x[0] * x[0]).inverse()}
        need(f in slopes, f"the function `{f}` is not known")
        y = domain.root(x[0], is_small(e)) if f == "sqrt" else domain.opaque(f, x[0])
        y = domain.along(y, slopes[f], x[0])
        return y, x[1] and slopes[f]() * x[1]
    def angle(self, e):
        """Cosine and sine of a sum of multiples of monomials, by the addition theorem."""
        known = self.domain.angles.get(e[1]) if e[0] == "s" and e[1] not in self.named else None
        if known: return known
        sum = one, zero = self.number(1)[0], self.number(0)[0]
        for monomial, k in self.polynomial(e).items():
            if monomial == (("pi", 1),) and (12 * k).denominator == 1:
                a, b, i = (self.domain.root(self.number(n)[0], True) for n in (2, 6, Fraction(1, 16)))
                k, (x, y) = 12 * k % 24, ((b + a) * i, (b - a) * i)
            else: k, (x, y) = k * Scope.PARTS, self.domain.circle(monomial)
            if k.denominator > 1:
                Scope.PARTS *= k.denominator
                raise NextPoint
            need(abs(k) < 2**32, f"an angle has a part with the factor {k}/{Scope.PARTS}")
            if k: sum = turned(sum, repeated(turned, (x, y if k > 0 else zero - y), abs(int(k))))
        if e[0] == "s" and e[1] not in self.named: self.domain.angles[e[1]] = sum
        return sum
    def polynomial(self, e):
        """The polynomial {((name, exponent), …): coefficient} that a tree is. Other parts count as symbols."""
        kind, a = e[:2]
        def opaque(): return {((self.domain.name(self.value(e)[0], e), 1),): Fraction(1)}
        if kind == "n": return {(): Fraction(a)} if a else {}
        if kind == "s": return self.polynomial(self.named[a]) if a in self.named else {((a, 1),): Fraction(1)}
        if kind in ("/", "^"):
            divisor, n = (e[2], -1) if kind == "/" else (a, e[2])
            factor = self.polynomial(divisor)
            if n < 0 and len(factor) != 1: return opaque()
            if n < 0: factor = {tuple((x, -m) for x, m in x): 1 / k for x, k in factor.items()}
            parts = [self.polynomial(a), factor] if kind == "/" else [{(): Fraction(1)}, *[factor] * abs(n)]
        elif kind in "+*": parts = [self.polynomial(b) for b in a]
        else: return opaque()
        total = parts[0]
        for part in parts[1:]:
            products = [(product(m, n), k * j) for m, k in total.items() for n, j in part.items()]
            pairs, total = (part.items(), dict(total)) if kind == "+" else (products, {})
            for m, k in pairs: total[m] = total.get(m, 0) + k
            need(len(total) < 1000, "an angle has too many parts")
        return {m: k for m, k in total.items() if k}


def product(m, n):
    """The product of two monomials."""
    exponents = dict(m)
    for name, k in n: exponents[name] = exponents.get(name, 0) + k
    return tuple(sorted((name, k) for name, k in exponents.items() if k))
