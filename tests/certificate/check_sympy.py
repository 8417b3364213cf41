"""Checks the short claims of a certificate with SymPy: exactly, as identities of fractions over the rational numbers.

    check_sympy.py FILE…

SymPy parses the formulas, differentiates them and divides polynomials. Sine and cosine of each angle are symbols with
s² + c² = 1. Claims with longer formulas are counted as left out. Exit status 1 if a claim does not hold.
"""
import hashlib, json, re, sys
import sympy
from sympy.polys.orderings import lex
from sympy.polys.rings import ring

LONGEST = 1500  # Characters of the formulas of a claim.


class Formulas:
    """Formulas of one formulation or line of the certificate as SymPy expressions."""
    def __init__(self, terms):
        self.terms, self.known = {t["name"]: t["value"] for t in terms}, {}

    def __call__(self, text):
        plain = lambda m: m[0] if m[0] in FUNCTIONS else f"v_{m[1]}{'p' * len(m[2])}"
        words = re.sub(r"([^\W\d]\w*)('*)", plain, text)
        names = {w: self.name(w) for w in set(re.findall(r"\bv_\w+", words))}
        return eval(re.sub(r"(?<![\w.])(\d+)", r"Integer(\1)", words.replace("^", "**")), {**FUNCTIONS, **names})

    def name(self, word):
        if word not in self.known:
            own = next((t for t in self.terms if "v_" + t.rstrip("'") + "p" * t.count("'") == word), None)
            self.known[word] = self(self.terms[own]) if own else sympy.Symbol(word)
        return self.known[word]


FUNCTIONS = {"sin": sympy.sin, "cos": sympy.cos, "tan": lambda x: sympy.sin(x) / sympy.cos(x), "sqrt": sympy.sqrt,
             "Integer": sympy.Integer, "sign": sympy.Function("sign_"), "__builtins__": {}}


def symbol(name): return sympy.Symbol("v_" + name.rstrip("'") + "p" * name.count("'"))


def is_zero(e):
    """True if an expression is zero modulo s² + c² = 1 for each angle and r² = x for each root."""
    is_wave = lambda f: isinstance(f, (sympy.sin, sympy.cos))
    e = sympy.expand_trig(e.replace(is_wave, lambda f: f.func(sympy.expand(f.args[0]))))
    names, relations = {}, []
    for wave in sorted(e.atoms(sympy.sin, sympy.cos), key=str):
        angle = wave.args[0]
        s, c = (sympy.Symbol(f"{f}_of_{abs(hash(angle))}") for f in ("s", "c"))
        names |= {sympy.sin(angle): s, sympy.cos(angle): c}
        relations.append(s**2 + c**2 - 1)
    e = e.xreplace(names)
    while roots := [p for p in e.atoms(sympy.Pow) if p.exp.is_Rational and not p.exp.is_Integer]:
        root = min(roots, key=lambda p: (len(p.base.atoms(sympy.Pow)), str(p)))
        r = sympy.Symbol(f"r_{len(relations)}")
        e = e.replace(lambda p: p.is_Pow and p.base == root.base and (2 * p.exp).is_Integer and not p.exp.is_Integer,
                      lambda p: r ** (2 * p.exp))
        relations.append(r**2 - root.base)
    others = e.atoms(sympy.core.function.AppliedUndef)
    e = e.xreplace({f: sympy.Symbol(f"f_{abs(hash(f))}") for f in others})
    numerator = sympy.together(e).as_numer_denom()[0]
    if numerator.is_Number: return numerator == 0
    relations = [sympy.together(r).as_numer_denom()[0] for r in dict.fromkeys(relations)]
    everything = sorted(set().union(*(r.free_symbols for r in [numerator, *relations])), key=str, reverse=True)
    everything.sort(key=lambda x: 0 if str(x).startswith("r_") else 1 if str(x).startswith("s_of") else 2)
    polynomials = ring(everything, sympy.QQ, lex)[0]
    return polynomials.from_expr(numerator.expand()).rem([polynomials.from_expr(r.expand()) for r in relations]) == 0


def claims(lines):
    """Every claim, as its name, both sides as functions without arguments, and the length of its formulas."""
    derivation = json.loads(lines[2]["derivation"])
    by = {f["formulation"]: f for f in derivation["formulations"]}
    kane, rates = by["kane"], by["kane"]["coordinate_rates"]
    read = {name: Formulas(f["named"]) for name, f in by.items()}
    n, u = len(rates), [symbol(s) for s in kane["rows"]]
    q = [symbol(x) for x in by["lagrange"]["rows"][:n]]
    rate = [read["kane"](r) for r in rates]
    w = [[sympy.diff(r, s) for s in u] for r in rate]
    offset = [sum(sympy.diff(r, x) * v for x, v in zip(q, rate)) for r in rate]
    in_speeds = {symbol(name + "'"): v for name, v in zip(by["lagrange"]["rows"], rate)}
    for name, f in by.items():
        if name == "kane": continue
        m, g = [[read[name](e) for e in row] for row in f["mass_matrix"]], [read[name](e) for e in f["forcing"]]
        length = sum(map(len, sum(f["mass_matrix"], f["forcing"]))) // len(f["rows"])
        length += sum(len(t["value"]) for t in f["named"])
        if name == "lagrange":
            maps, columns = [list(c) for c in zip(*w)], kane["unknowns"] + f["unknowns"][n:]
            g = [(b - sum(a * o for a, o in zip(row, offset))).xreplace(in_speeds) for row, b in zip(m, g)]
            m = [[sum(a * x[k] for a, x in zip(row, w)) for k in range(len(u))] + row[n:] for row in m]
        else:
            line = next(x for x in lines if x.get("combination") == name)
            terms = Formulas(line["named"])
            maps, columns = [[terms(e) for e in row] for row in line["multipliers"]], f["unknowns"]
        for k, row in enumerate(kane["rows"]):
            for at, x in enumerate([*columns, "right"]):
                entry = kane["forcing"][k] if x == "right" else kane["mass_matrix"][k][at] if at < len(u) else "0"
                values = g if x == "right" else [line[at] for line in m]
                combined = sum(a * b for a, b in zip(maps[k], values))
                yield (name, row, x), combined - read["kane"](entry), length + len(entry)
    ud = [symbol(s + "'") for s in kane["rows"]]
    matrix = [[read["kane"](e) for e in row] for row in kane["mass_matrix"]]
    residual = [sum(e * a for e, a in zip(row, ud)) - read["kane"](b) for row, b in zip(matrix, kane["forcing"])]
    for line in (x for x in lines if "integral" in x):
        terms = Formulas(line["named"])
        value = terms(line["value"])
        along = sum(sympy.diff(value, x) * v for x, v in [*zip(q, rate), *zip(u, ud)])
        length = len(line["value"]) + sum(map(len, kane["forcing"])) + sum(len(t["value"]) for t in line["named"])
        combined = sum(terms(e) * r for e, r in zip(line["multipliers"], residual))
        yield ("integral", line["integral"]), along - combined, length


def main(paths):
    status = 0
    sys.setrecursionlimit(10**5)
    for path in paths:
        lines = [json.loads(line) for line in open(path, encoding="utf-8") if line.strip()]
        hashes = [(line["sha256"], line[key]) for line, key in ((lines[1], "model_text"), (lines[2], "derivation"))]
        wrong = [] if all(h == hashlib.sha256(t.encode()).hexdigest() for h, t in hashes) else ["a hash is wrong"]
        holds, left = 0, 0
        if len(lines[2]["derivation"]) > 60 * LONGEST:
            print(f"{path}: left out, since its derivation is long")
            continue
        for name, difference, length in claims(lines):
            if length > LONGEST: left += 1
            elif difference == 0 or is_zero(difference): holds += 1
            else: wrong.append(", ".join(name))
        print(f"{path}: SymPy proves {holds} claims exactly, {left} are left out as too long")
        for name in wrong: print(f"  DOES NOT HOLD: {name}")
        status |= bool(wrong)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
