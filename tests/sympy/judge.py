#!/usr/bin/env python3
"""Whether two expressions mean the same, by SymPy alone.

Reads JSON lines {"left": expr, "right": expr, "positive": [names]} from standard input, expressions in the
grammar of the model file, every name (primes included) a variable. Answers each with one line:

    equal        proved by algebra
    different    they differ at a rational point: in exact arithmetic where only sines, cosines and rational
                 functions stand in them, else by more than the rounding of at least 50 digits
    unknown      neither, or it cannot be read

Names under "positive" are positive, all others real. `equal` is meant generically: x/x is 1.
"""

import json
import random
import signal
import sys
from contextlib import contextmanager

import sympy
from sympy import Add, Integer, Mul, Rational, Symbol, cos, pi, sin, tan

sys.dont_write_bytecode = True  # The source tree stays as it is.
from grammar import Unsupported, expression  # noqa: E402

POINTS = 12
SECONDS = 20


class Variables(dict):
    """Makes a symbol of every name that is asked for."""

    def __init__(self, positive):
        super().__init__()
        self.positive = set(positive)

    def __missing__(self, name):
        known = {"positive": True} if name in self.positive else {"real": True}
        return self.setdefault(name, Symbol(name, **known))


class OutOfTime(Exception):
    """A simplification took too long."""


@contextmanager
def at_most(seconds):
    def stop(signum, frame):
        raise OutOfTime

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


# ---------------------------------------------------------------------------------------------------
# Exact values
# ---------------------------------------------------------------------------------------------------


def angle_terms(argument):
    """The argument of a sine as {product of variables: rational factor}, or None if it is not such a sum."""
    terms = {}
    for term in Add.make_args(sympy.expand(argument)):
        factor, product = term.as_coeff_Mul()
        powers = [part.as_base_exp() for part in Mul.make_args(product) if part != 1]
        if not all((base.is_Symbol or base is pi) and exponent.is_Integer for base, exponent in powers):
            return None
        terms[product] = factor
    return terms


def is_rational_function(e):
    """Built of rationals, variables and pi by + - * / and whole powers only."""
    return all(
        part.is_Symbol or part.is_Rational or part is pi or part.is_Add or part.is_Mul
        or (part.is_Pow and part.exp.is_Integer)
        for part in sympy.preorder_traversal(e)
    )


def on_unit_circle(e):
    """The expression with each sine and cosine as a rational function of t = tan(angle/2), or None.

    Every product of variables that stands in an angle has its own t. Such products are independent over the
    rationals, so their sines and cosines are independent of each other, of the variables and of pi: the
    expression is identically zero if and only if this rational function is. None where anything but sines,
    cosines and rational functions stands in the expression.
    """
    e = e.replace(tan, lambda x: sin(x) / cos(x))
    waves = sorted(e.atoms(sin, cos), key=sympy.default_sort_key)
    angles = {wave: angle_terms(wave.args[0]) for wave in waves}
    if None in angles.values():
        return None
    shares = {}
    for product, factor in (item for terms in angles.values() for item in terms.items()):
        shares[product] = sympy.ilcm(shares.get(product, 1), factor.q)
    if 1 in shares and e.has(pi):
        return None  # Whether pi and sin(1) are independent is not known.
    e = e.xreplace({wave: wave_value(wave, terms, shares) for wave, terms in angles.items()})
    return e if is_rational_function(e) else None


def wave_value(wave, terms, shares):
    """sin or cos of a sum of whole multiples of the basic angles, by products of unit complex numbers."""
    real, imaginary = Integer(1), Integer(0)
    for product, factor in terms.items():
        if product is pi:
            c, s = cos(factor * pi), sin(factor * pi)
        else:
            t, times = Symbol(f"t of {product}", real=True), factor * shares[product]
            c1, s1 = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
            c = sympy.chebyshevt_poly(abs(times), c1)
            s = sympy.sign(times) * s1 * sympy.chebyshevu_poly(abs(times) - 1, c1)
        real, imaginary = real * c - imaginary * s, real * s + imaginary * c
    return imaginary if isinstance(wave, sin) else real


def value_at(e, chance, exact):
    """The value at a random rational point: 0, a number that surely is not 0, or None where undefined."""
    names = sorted(e.free_symbols, key=lambda s: s.name)
    at = {}
    for name in names:
        number = Rational(chance.randint(1, 997), chance.randint(211, 499))
        at[name] = number if name.is_positive or chance.random() < 0.5 else -number
    if exact and e.has(pi):
        at[pi] = Rational(chance.randint(1, 997), 499)
    value = e.xreplace(at)
    if value.is_Rational:
        return value
    if exact or not value.is_number or value.has(sympy.nan, sympy.zoo, sympy.oo, -sympy.oo):
        return None
    return certain_value(value)


def certain_value(value):
    """A number that SymPy knows to be off zero, Integer 0 if 50 digits vanish, None if it is not real."""
    digits = value.evalf(50, maxn=1000)
    if digits.is_real is False or digits.has(sympy.I):
        return None
    if digits == 0 or (digits.is_Float and abs(digits) < sympy.Float("1e-40")):
        return Integer(0)
    return digits if digits.is_Float and digits._prec > 1 else None


def zeros(difference, seed):
    """At how many random points it is zero, up to POINTS; None if at one it surely is not."""
    circle = on_unit_circle(difference)
    chance, count = random.Random(seed), 0
    for _ in range(3 * POINTS):
        value = value_at(difference if circle is None else circle, chance, exact=circle is not None)
        if value is not None and value != 0:
            return None
        count += value == 0
        if count == POINTS:
            break
    return count


# ---------------------------------------------------------------------------------------------------
# Proofs of zero
# ---------------------------------------------------------------------------------------------------


def by_circle(e):
    circle = on_unit_circle(e)
    return e if circle is None else sympy.cancel(sympy.together(circle))


PROOFS = (sympy.expand, lambda e: sympy.expand(sympy.expand_trig(e)), by_circle, sympy.trigsimp, sympy.simplify)


def proved_zero(difference):
    for proof in PROOFS:
        try:
            with at_most(SECONDS):
                if proof(difference) == 0:
                    return True
        except Exception:  # Out of time, or one of the many ways in which SymPy gives up: no proof.
            continue
    return False


def judge(left, right, positive):
    names = Variables(positive)
    difference = expression(left, names) - expression(right, names)
    if difference == 0:
        return "equal"
    if difference.has(sympy.nan, sympy.zoo, sympy.oo):
        return "unknown"
    try:
        with at_most(SECONDS):
            count = zeros(difference, f"{left} {right}")
    except OutOfTime:
        return "unknown"
    if count is None:
        return "different"
    return "equal" if count == POINTS and proved_zero(difference) else "unknown"


def main():
    sys.setrecursionlimit(10000)
    for line in sys.stdin:
        if not line.strip():
            continue
        try:
            task = json.loads(line)
            verdict = judge(task["left"], task["right"], task.get("positive", []))
        except (Unsupported, ValueError, KeyError):
            verdict = "unknown"
        print(verdict, flush=True)


if __name__ == "__main__":
    main()
