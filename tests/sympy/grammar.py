"""Expressions in the grammar of the model file (docs/model.md): text to SymPy and back."""

import re
from fractions import Fraction
from functools import reduce

import sympy
from sympy import Derivative, Mul, Rational, pi
from sympy.core.function import AppliedUndef


class Beyond(Exception):
    """What this script knows, but does not get done."""


class Unsupported(Exception):
    """The model is wrong, or uses a feature that these scripts do not know."""


FUNCTIONS = {
    "sin": sympy.sin,
    "cos": sympy.cos,
    "tan": sympy.tan,
    "sec": lambda x: 1 / sympy.cos(x),
    "csc": lambda x: 1 / sympy.sin(x),
    "cot": lambda x: sympy.cos(x) / sympy.sin(x),
    "sqrt": sympy.sqrt,
    "exp": sympy.exp,
    "log": sympy.log,
    "asin": sympy.asin,
    "acos": sympy.acos,
    "atan": sympy.atan,
    "sinh": sympy.sinh,
    "cosh": sympy.cosh,
    "tanh": sympy.tanh,
    "abs": sympy.Abs,
    "sign": sympy.sign,
}
OF_SEVERAL = {
    "min": lambda a, *rest: reduce(lambda a, b: (a + b - sympy.Abs(a - b)) / 2, rest, a),
    "max": lambda a, *rest: reduce(lambda a, b: (a + b + sympy.Abs(a - b)) / 2, rest, a),
    "atan2": lambda y, x: 2 * sympy.atan(y / (x + sympy.sqrt(x**2 + y**2))),
}
WORDS = {f: word for word, f in FUNCTIONS.items() if word not in ("sec", "csc", "cot", "sqrt")}
# A component of a velocity, `v(P) @ A [1]`, `v(disk, P) @ A [1]`, `v(P of disk) @ A [1]` or `omega(B) @ A [1]`, or of a
# position, `p(P) @ A [1]`, is one word.
WAVES = (sympy.sin, sympy.cos, sympy.tan)
VELOCITY = r"(?:v\s*\(\s*\w+\s*(?:,\s*\w+\s*|of\s+\w+\s*)?\)|(?:omega|p)\s*\(\s*\w+\s*\))\s*@\s*\w+\s*\[\s*\d+\s*\]"
TOKEN = re.compile(rf"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|{VELOCITY}|[A-Za-z]\w*'*|[-+*/^(),])")
DEEPEST = 200


class Parser:
    """Recursive descent; `names` maps what may be named, primes included, to SymPy expressions."""

    def __init__(self, text, names):
        self.text, self.names, self.at = text, names, 0
        self.tokens = []
        place, end = 0, len(text.rstrip())
        while place < end:
            found = TOKEN.match(text, place)
            if not found:
                raise Unsupported(f"cannot read `{text[place:].strip()}` in `{text}`")
            self.tokens.append(found[1])
            place = found.end()

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, expected=""):
        token = self.peek()
        if not token or (expected and token != expected):
            raise Unsupported(f"`{expected or 'a value'}` is missing in `{self.text}`")
        self.at += 1
        return token

    def whole(self):
        value = self.sum()
        if self.peek():
            raise Unsupported(f"`{self.peek()}` is not expected in `{self.text}`")
        return value

    def sum(self):
        terms = [self.product()]
        while self.peek() in ("+", "-"):
            sign = 1 if self.take() == "+" else -1
            terms.append(sign * self.product())
        return sympy.Add(*terms)

    def product(self):
        value = self.signed()
        while self.peek() in ("*", "/"):
            divides = self.take() == "/"
            factor = self.signed()
            if divides and factor == 0:
                raise Unsupported(f"division by 0 in `{self.text}`")
            value = value / factor if divides else value * factor
        return value

    def signed(self):
        """Signs bind weaker than powers: -x^2 is -(x^2), while 2^-x is 2^(-x)."""
        if self.peek() in ("+", "-"):
            return self.signed() if self.take() == "+" else -self.signed()
        base = self.atom()
        if self.peek() == "^":
            self.take()
            return base ** self.signed()
        return base

    def atom(self):
        token = self.take()
        if token == "(" or token in FUNCTIONS:
            if token != "(":
                self.take("(")
            value = self.sum()
            self.take(")")
            return FUNCTIONS[token](value) if token in FUNCTIONS else value
        if token in OF_SEVERAL and self.peek() == "(" and token not in self.names:
            self.take("(")
            arguments = [self.sum()]
            while self.peek() == ",":
                self.take()
                arguments.append(self.sum())
            self.take(")")
            return OF_SEVERAL[token](*arguments)
        if token[0].isdigit() or token[0] == ".":
            return Rational(Fraction(token))
        if token == "pi":
            return pi
        try:
            return self.names[token]
        except KeyError:
            raise Unsupported(f"`{token}` may not stand in `{self.text}`") from None


def expression(value, names):
    """A string in the model file's grammar, or a number, as a SymPy expression."""
    if isinstance(value, str):
        return Parser(value, names).whole()
    if isinstance(value, (int, Fraction)) and not isinstance(value, bool):
        return Rational(value)
    raise Unsupported(f"`{value}` is not a formula")


def text(e):
    """A SymPy expression in the grammar of the model file."""
    line = term_text(sympy.sympify(e))
    depth = deepest = 0
    for c in line:
        depth += (c == "(") - (c == ")")
        deepest = max(deepest, depth)
    if deepest > DEEPEST:
        raise Unsupported(f"an expression nests {deepest} deep, more than {DEEPEST}")
    return line


def term_text(e):
    """The text of anything, right as an operand of a sum (a sum itself is not in parentheses)."""
    if e.is_Add:
        first, *rest = (term_text(term) for term in e.args)
        return first + "".join(f" - {term[1:]}" if term[0] == "-" else f" + {term}" for term in rest)
    if e.is_Mul or e.is_Rational or e.is_Pow:
        return product_text(e)
    if e.is_Symbol:
        return e.name
    if isinstance(e, AppliedUndef):
        return e.func.__name__
    if isinstance(e, Derivative) and isinstance(e.expr, AppliedUndef):
        return e.expr.func.__name__ + "'" * e.derivative_count
    if e is pi:
        return "pi"
    if e is sympy.E:
        return "exp(1)"
    if e.func in WORDS:
        return f"{WORDS[e.func]}({term_text(e.args[0])})"
    raise Unsupported(f"the grammar has no words for `{e}`")


def product_text(e):
    """A product, quotient, power or number: factors over the line, then those under it."""
    over, under, sign = [], [], ""
    for factor in Mul.make_args(e):
        if factor.is_Rational:
            sign = "-" if factor < 0 else ""
            over += [str(abs(factor.p))] if abs(factor.p) != 1 else []
            under += [str(factor.q)] if factor.q != 1 else []
        elif factor.is_Pow and factor.exp.is_Rational and factor.exp < 0:
            under.append(power_text(factor.base, -factor.exp))
        elif factor.is_Pow:
            over.append(power_text(factor.base, factor.exp))
        else:
            over.append(power_text(factor, sympy.S.One))
    line = sign + ("*".join(over) or "1")
    if len(under) > 1:
        return f"{line}/({'*'.join(under)})"
    return "/".join([line, *under])


def power_text(base, exponent):
    """A power of positive exponent, right as an operand of a product."""
    if exponent == Rational(1, 2):
        return f"sqrt({term_text(base)})"
    if not (exponent.is_Rational and exponent.q in (1, 2)):
        raise Unsupported(f"exponents must be whole or half numbers, not `{exponent}`")
    inner = term_text(base)
    plain = base.is_Symbol or base.is_Function or isinstance(base, Derivative)
    plain = plain or base is pi or (base.is_Integer and base >= 0)
    inner = inner if plain else f"({inner})"
    if exponent == 1:
        return inner
    return f"{inner}^{exponent}" if exponent.q == 1 else f"{inner}^({exponent})"
