"""Rewriting of trees: into equal forms, and into forms with one mistake."""
from fractions import Fraction
from expressions import add, count, fun, mul, neg, nodes, num, power, replaced, sym


def equal_form(r, tree, steps, names):
    """The tree after some rewritings that keep its value."""
    for _ in range(steps):
        if count(tree) > 400:
            break
        places = [(path, node) for path, node in nodes(tree) if path or node[0] != "n"]
        r.shuffle(places)
        for path, node in places:
            new = rewritten(r, node, names)
            if new is not None:
                tree = replaced(tree, path, new)
                break
    return shuffled(r, tree)


def rewritten(r, node, names):
    """An equal form of one node, or `None`."""
    kind = node[0]
    if kind == "f":
        return of_function(r, node)
    if kind == "^":
        return of_power(r, node)
    if kind == "*":
        return of_product(r, node)
    if kind == "+" and len(node[1]) > 2:
        terms = list(node[1])
        a, b = sorted(r.sample(range(len(terms)), 2))
        pair = add(terms[a], terms.pop(b))
        terms[a] = pair
        return add(*terms)
    if kind == "s" and r.random() < 0.1 and "'" not in node[1]:
        return r.choice([add(mul(num(2), node), neg(node)), mul(num(Fraction(1, 2)), add(node, node))])
    return None


def of_function(r, node):
    name, x = node[1], node[2]
    half = mul(num(Fraction(1, 2)), x)
    right = mul(num(Fraction(1, 2)), sym("pi"))
    if name == "sin":
        if x[0] == "+" and r.random() < 0.6:
            a, b = x[1][0], add(*x[1][1:])
            return add(mul(fun("sin", a), fun("cos", b)), mul(fun("cos", a), fun("sin", b)))
        return r.choice([
            mul(num(2), fun("sin", half), fun("cos", half)), fun("cos", add(x, neg(right))),
            fun("cos", add(right, neg(x))), neg(fun("sin", neg(x))), mul(fun("tan", x), fun("cos", x)),
            fun("sin", add(sym("pi"), neg(x))), add(mul(num(3), fun("sin", mul(num(Fraction(1, 3)), x))),
                                                   mul(num(-4), power(fun("sin", mul(num(Fraction(1, 3)), x)), 3)))])
    if name == "cos":
        if x[0] == "+" and r.random() < 0.6:
            a, b = x[1][0], add(*x[1][1:])
            return add(mul(fun("cos", a), fun("cos", b)), neg(mul(fun("sin", a), fun("sin", b))))
        return r.choice([
            add(power(fun("cos", half), 2), neg(power(fun("sin", half), 2))),
            add(num(1), mul(num(-2), power(fun("sin", half), 2))), fun("sin", add(x, right)), fun("cos", neg(x)),
            neg(fun("cos", add(x, sym("pi")))), power(fun("sec", x), -1)])
    if name == "tan":
        return r.choice([mul(fun("sin", x), power(fun("cos", x), -1)), mul(fun("sin", x), fun("sec", x)),
                         neg(fun("tan", neg(x))), mul(fun("sin", mul(num(2), x)),
                                                      power(add(num(1), fun("cos", mul(num(2), x))), -1))])
    if name in ("sec", "csc"):
        return power(fun("cos" if name == "sec" else "sin", x), -1)
    return None


def of_power(r, node):
    base, e = node[1], node[2]
    if e == 2 and base[0] == "f" and base[1] in ("sin", "cos"):
        x, sign = base[2], num(-1 if base[1] == "sin" else 1)
        other = "cos" if base[1] == "sin" else "sin"
        return r.choice([
            add(num(1), neg(power(fun(other, x), 2))),
            mul(num(Fraction(1, 2)), add(num(1), mul(sign, fun("cos", mul(num(2), x)))))])
    if e == 2:
        if base[0] == "+" and len(base[1]) == 2:
            a, b = base[1]
            return add(power(a, 2), mul(num(2), a, b), power(b, 2))
        return mul(base, base)
    if e == -1 and base[0] == "f" and base[1] in ("sin", "cos"):
        return fun("sec" if base[1] == "cos" else "csc", base[2])
    return None


def of_product(r, node):
    factors = list(node[1])
    sums = [k for k, f in enumerate(factors) if f[0] == "+"]
    if sums and r.random() < 0.5:
        k = r.choice(sums)
        rest = factors[:k] + factors[k + 1:]
        return add(*(mul(*rest, t) for t in factors[k][1]))
    trig = [k for k, f in enumerate(factors) if f[0] == "f" and f[1] in ("sin", "cos")]
    if len(trig) > 1:
        a, b = r.sample(trig, 2)
        rest = [f for k, f in enumerate(factors) if k not in (a, b)]
        return mul(*rest, product_to_sum(factors[a], factors[b]))
    if r.random() < 0.25:
        angle = [f[2] for f in factors if f[0] == "f" and f[1] in ("sin", "cos")]
        if angle:
            one = add(power(fun("sin", angle[0]), 2), power(fun("cos", angle[0]), 2))
            return mul(*factors, one)
    if len(factors) > 2:
        return mul(factors[0], mul(*factors[1:]))
    return None


def product_to_sum(a, b):
    x, y, half = a[2], b[2], num(Fraction(1, 2))
    plus, minus = add(x, y), add(x, neg(y))
    if a[1] == b[1] == "sin":
        return mul(half, add(fun("cos", minus), neg(fun("cos", plus))))
    if a[1] == b[1] == "cos":
        return mul(half, add(fun("cos", minus), fun("cos", plus)))
    if a[1] == "cos":
        return product_to_sum(b, a)
    return mul(half, add(fun("sin", plus), fun("sin", minus)))


def shuffled(r, tree):
    """The same terms and factors in another order."""
    kind = tree[0]
    if kind in "+*":
        parts = [shuffled(r, t) for t in tree[1]]
        r.shuffle(parts)
        return (kind, parts)
    if kind == "^":
        return ("^", shuffled(r, tree[1]), tree[2])
    return tree if kind in "ns" else ("f", tree[1], shuffled(r, tree[2]))


def broken(r, tree, names):
    """The tree with one mistake; its value differs nearly always, which the caller checks by numbers."""
    places = list(nodes(tree))
    for _ in range(60):
        path, node = r.choice(places)
        new = mistaken(r, node, names)
        if new is not None:
            return replaced(tree, path, new)
    return mul(num(2), tree)


def mistaken(r, node, names):
    kind = node[0]
    if kind == "+":
        terms = list(node[1])
        k = r.randrange(len(terms))
        if r.random() < 0.5:
            terms[k] = neg(terms[k])
            return add(*terms)
        del terms[k]
        return add(*terms)
    if kind == "n" and abs(node[1]) != 1:
        return num(r.choice([node[1] * 2, node[1] / 2, node[1] + 1, node[1] * Fraction(1001, 1000)]))
    if kind == "f" and node[1] in ("sin", "cos"):
        if r.random() < 0.6:
            return fun("cos" if node[1] == "sin" else "sin", node[2])
        return fun(node[1], mul(num(2), node[2]))
    if kind == "s":
        others = [n for n in names if n != node[1] and n[0] == node[1][0] and n.count("'") == node[1].count("'")]
        if others and r.random() < 0.7:
            return sym(r.choice(others))
        if r.random() < 0.2:
            return power(node, 2)
        return None
    if kind == "^" and node[2] == 2:
        return r.choice([node[1], power(node[1], 3)])
    if kind == "*" and r.random() < 0.4:
        factors = list(node[1])
        if len(factors) > 2:
            del factors[r.randrange(len(factors))]
            return mul(*factors)
        return mul(num(r.choice([-1, 2, Fraction(1, 2)])), *factors)
    return None
