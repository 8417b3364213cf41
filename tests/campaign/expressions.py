"""Formulas as trees: read from the program's text, evaluated in doubles, rewritten, and written in four notations.

A tree is ("n", fraction), ("s", name), ("+", terms), ("*", factors), ("^", base, fraction), or ("f", function,
argument).
"""
import math, re
from fractions import Fraction
import numpy as np

TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][-+]?\d+)?)|([A-Za-z]\w*'*)|([-+*/^()]))")
FUNCTIONS = {"sin": np.sin, "cos": np.cos, "tan": np.tan, "sqrt": np.sqrt, "exp": np.exp, "log": np.log, "abs": np.abs,
             "sec": lambda x: 1 / np.cos(x), "csc": lambda x: 1 / np.sin(x), "cot": lambda x: 1 / np.tan(x),
             "sign": np.sign, "atan": np.arctan, "asin": np.arcsin, "acos": np.arccos, "tanh": np.tanh,
             "sinh": np.sinh, "cosh": np.cosh}


def num(value):
    return ("n", Fraction(value))


def sym(name):
    return ("s", name)


def add(*terms):
    return ("+", list(terms)) if len(terms) > 1 else terms[0]


def mul(*factors):
    return ("*", list(factors)) if len(factors) > 1 else factors[0]


def power(base, exponent):
    return ("^", base, Fraction(exponent))


def fun(name, argument):
    return ("f", name, argument)


def neg(a):
    return mul(num(-1), a)


class Reader:
    """Reads the program's formulas."""
    def __init__(self, text):
        self.tokens, at = [], 0
        text = text.strip()
        while at < len(text):
            m = TOKEN.match(text, at)
            if not m:
                raise ValueError(f"formula {text[at:at + 20]}")
            self.tokens.append(m[0].strip())
            at = m.end()
        self.at = 0

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def sum(self):
        terms = [self.product()]
        while self.peek() in ("+", "-"):
            terms.append(self.product() if self.take() == "+" else neg(self.product()))
        return add(*terms)

    def product(self):
        factors = [self.signed()]
        while self.peek() in ("*", "/"):
            factors.append(self.signed() if self.take() == "*" else power(self.signed(), -1))
        return mul(*factors)

    def signed(self):
        if self.peek() == "-":
            self.take()
            return neg(self.signed())
        if self.peek() == "+":
            self.take()
        return self.powered()

    def powered(self):
        base = self.atom()
        if self.peek() == "^":
            self.take()
            exponent = self.signed()
            return power(base, Fraction(value(exponent, {})).limit_denominator(1000))
        return base

    def atom(self):
        token = self.take()
        if token == "(":
            inner = self.sum()
            self.take()
            return inner
        if token[0].isdigit():
            return num(token)
        if self.peek() == "(" and token in FUNCTIONS:
            self.take()
            inner = self.sum()
            self.take()
            return fun(token, inner)
        return sym(token)


def read(text):
    reader = Reader(text)
    tree = reader.sum()
    if reader.at != len(reader.tokens):
        raise ValueError(f"formula {text}")
    return tree


def value(tree, scope):
    """Value in doubles."""
    kind = tree[0]
    if kind == "n":
        return float(tree[1])
    if kind == "s":
        return math.pi if tree[1] == "pi" else scope[tree[1]]
    if kind == "+":
        return sum(value(t, scope) for t in tree[1])
    if kind == "*":
        total = 1.0
        for t in tree[1]:
            total = total * value(t, scope)
        return total
    if kind == "^":
        e = tree[2]
        base = value(tree[1], scope)
        return base ** int(e) if e.denominator == 1 else np.float64(base) ** float(e)
    return float(FUNCTIONS[tree[1]](value(tree[2], scope)))


def size(tree, scope):
    """Value with all terms of sums counted by their sizes: what rounding is relative to."""
    kind = tree[0]
    if kind in "ns":
        return abs(value(tree, scope))
    if kind == "+":
        return sum(size(t, scope) for t in tree[1])
    if kind == "*":
        total = 1.0
        for t in tree[1]:
            total = total * size(t, scope)
        return total
    if kind == "^" and tree[2] > 0:
        return size(tree[1], scope) ** float(tree[2])
    return abs(value(tree, scope))


def symbols(tree):
    """Names in a tree."""
    kind = tree[0]
    if kind == "s":
        return {tree[1]} - {"pi"}
    if kind in "+*":
        return set().union(*(symbols(t) for t in tree[1]))
    return set() if kind == "n" else symbols(tree[1] if kind == "^" else tree[2])


def nodes(tree, path=()):
    """All subtrees with their paths."""
    yield path, tree
    kind = tree[0]
    if kind in "+*":
        for k, t in enumerate(tree[1]):
            yield from nodes(t, path + (k,))
    elif kind == "^":
        yield from nodes(tree[1], path + (-1,))
    elif kind == "f":
        yield from nodes(tree[2], path + (-2,))


def replaced(tree, path, new):
    """The tree with another subtree at a path."""
    if not path:
        return new
    k = path[0]
    if k == -1:
        return ("^", replaced(tree[1], path[1:], new), tree[2])
    if k == -2:
        return ("f", tree[1], replaced(tree[2], path[1:], new))
    parts = list(tree[1])
    parts[k] = replaced(parts[k], path[1:], new)
    return (tree[0], parts)


def substituted(tree, table):
    """The tree with names replaced by trees."""
    kind = tree[0]
    if kind == "s":
        return table.get(tree[1], tree)
    if kind in "+*":
        return (kind, [substituted(t, table) for t in tree[1]])
    if kind == "^":
        return ("^", substituted(tree[1], table), tree[2])
    return tree if kind == "n" else ("f", tree[1], substituted(tree[2], table))


def derivative(tree, name):
    """Derivative with respect to a name; products are differentiated factor by factor."""
    kind = tree[0]
    if kind == "n":
        return num(0)
    if kind == "s":
        return num(1 if tree[1] == name else 0)
    if name not in symbols(tree):
        return num(0)
    if kind == "+":
        return add(*([d for d in (derivative(t, name) for t in tree[1]) if d != num(0)] or [num(0)]))
    if kind == "*":
        terms = []
        for k, f in enumerate(tree[1]):
            d = derivative(f, name)
            if d != num(0):
                rest = [*tree[1][:k], *tree[1][k + 1:]]
                terms.append(mul(*rest, d) if d != num(1) else mul(*rest) if rest else num(1))
        return add(*(terms or [num(0)]))
    if kind == "^":
        base, e = tree[1], tree[2]
        return mul(num(e), power(base, e - 1), derivative(base, name)) if e != 1 else derivative(base, name)
    slope = SLOPES.get(tree[1])
    if slope is None:
        raise ZeroDivisionError(f"no derivative of {tree[1]}")
    return mul(slope(tree[2]), derivative(tree[2], name))


SLOPES = {
    "sin": lambda x: fun("cos", x), "cos": lambda x: neg(fun("sin", x)),
    "tan": lambda x: add(num(1), power(fun("tan", x), 2)), "exp": lambda x: fun("exp", x),
    "sec": lambda x: mul(fun("sec", x), fun("tan", x)),
    "sqrt": lambda x: mul(num(Fraction(1, 2)), power(x, Fraction(-1, 2))),
    "csc": lambda x: neg(mul(fun("csc", x), fun("cot", x))), "cot": lambda x: neg(power(fun("csc", x), 2)),
    "log": lambda x: power(x, -1), "tanh": lambda x: add(num(1), neg(power(fun("tanh", x), 2))),
    "atan": lambda x: power(add(num(1), power(x, 2)), -1),
}


def count(tree):
    return sum(1 for _ in nodes(tree))
