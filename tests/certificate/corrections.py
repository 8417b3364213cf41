"""Corrections of printed formulas that `tripos diff` names, carried out without Tripos. Used by verdicts.py.

A correction is the text of the verdict, such as `3*u1*u3 should be 2*u1*u3`. Each place of the printed formula at which
the wrong part has its value is tried, so that the text alone says what is changed.
"""
import functools, itertools, re
from formula import NextPoint, Refused, Residue, parse, tree
from fractions import Fraction
from kinematics import known

MOST = 4000  # Changed formulas that are tried for one entry.
RATIOS = [Fraction(a, b) for a in (1, -1, 2, -2, 3, -3, 4, -4) for b in (1, 2, 3, 4)]
CHANGES = ((r"the term (.+) should not be there", "extra"), (r"the term (.+) is missing", "missing"),
           (r"the term (.+) should be (.+)", "term"), (r"(.+) should be (.+) throughout", "all"),
           (r"(.+) should be (.+)", "one"))


def number(a): return tree("n", Fraction(a))
def scaled(e, k): return tree("*", (number(k), e))
def plus(*parts): return tree("+", parts)


def changes_of(text, names):
    """The changes that a text names, as (place, kind, parts). The place is None, one of the names, or words for a part
    of a row. Parts of formulas that the text names as places are left out: the changed part is sought everywhere."""
    found, place = [], None
    for clause in text.split("; "):
        place = None
        for piece in re.split(r", (?=in |the term |\S[^,]* should be )", clause):
            while m := re.match(r"in ([^;]+?)(?:, |$)", piece):
                if m[1] in names or m[1].startswith("the "): place = m[1]
                piece = piece[m.end():]
            if not piece: continue
            match = next(((m, kind) for p, kind in CHANGES if (m := re.fullmatch(p, piece))), None)
            known(match, f"the correction `{piece}`")
            found.append((place, match[1], [parse(x) for x in match[0].groups()]))
    known(found, f"the correction `{text}`")
    return found


def flattened(e, sign=1):
    """Terms of a sum, as (tree, sign)."""
    if e[0] == "+": return [x for part in e[1] for x in flattened(part, sign)]
    if e[0] == "*" and e[1][0][0] == "n" and e[1][0][1] == -1: return flattened(e[1][1], -sign)
    return [(e, sign)]


def factors(e, sign=1):
    """Factors of a product, as (tree, 1) or (tree, -1) below the bar."""
    if e[0] == "*": return [x for part in e[1] for x in factors(part, sign)]
    if e[0] == "/": return factors(e[1], sign) + factors(e[2], -sign)
    if e[0] == "^" and 0 < e[2] < 5: return factors(e[1], sign) * e[2]
    return [(e, sign)]


class Editor:
    """Changed copies of formulas, whose values are known at one instant."""
    def __init__(self, value): self.of = value
    def number(self, k): return Residue(k.numerator * pow(k.denominator, -1, Residue.P))
    def value(self, e):
        try: return self.of(e).v
        except Refused: return None

    def at_node(self, e, kind, parts):
        """Copies of a formula with a change of the formula itself, not of its parts."""
        if kind == "missing":
            yield plus(e, parts[0])
            return
        wrong, right = parts[0], parts[1] if len(parts) > 1 else number(0)
        own, x = self.value(e), self.value(wrong)
        if own == x: yield right
        if kind in ("extra", "term"): yield plus(e, scaled(wrong, -1), right)
        terms, goal = flattened(e), Residue(x or 0)
        if len(terms) > 1:
            values = [(self.of(t).v * s) % Residue.P for t, s in terms]
            goals = {(self.number(k) * goal).v: k for k in RATIOS}
            for k in range(len(terms)):
                if values[k] in goals: yield self.without(e, terms, (k,), right, goals[values[k]])
            for size in (2, 3, 4) if len(terms) < 9 else (2,):
                for chosen in itertools.combinations(range(len(terms)), size):
                    total = sum(values[k] for k in chosen) % Residue.P
                    if total in goals: yield self.without(e, terms, chosen, right, goals[total])
        elif e[0] in "*/^" and e[0] != "+" and own:
            list = factors(e)
            values = [Residue(self.of(f).v) if s > 0 else Residue(self.of(f).v).inverse() for f, s in list]
            goals = {(self.number(k) * goal).v: k for k in RATIOS}
            for size in range(1, len(list) if len(list) < 9 else 4):
                for chosen in itertools.combinations(range(len(list)), size):
                    part = functools.reduce(lambda a, b: a * b, (values[k] for k in chosen))
                    if part.v in goals: yield tree("*", (tree("/", e, wrong), right))

    def without(self, e, terms, chosen, right, ratio):
        """A sum in which some terms are replaced."""
        rest = [scaled(t, s) if s < 0 else t for k, (t, s) in enumerate(terms) if k not in chosen]
        return plus(*rest, scaled(right, ratio))

    def edits(self, e, kind, parts):
        """Copies of a formula with one change, of the formula itself or of one of its parts."""
        yield from self.at_node(e, kind, parts)
        if e[0] in "+*":
            for k, part in enumerate(e[1]):
                for new in self.edits(part, kind, parts): yield tree(e[0], (*e[1][:k], new, *e[1][k + 1:]))
        elif e[0] == "^":
            for new in self.edits(e[1], kind, parts): yield tree("^", new, e[2])
        elif e[0] not in "ns":
            for k in range(1, len(e)):
                for new in self.edits(e[k], kind, parts): yield tree(e[0], *e[1:k], new, *e[k + 1:])

    def everywhere(self, e, wrong, right):
        """The formula with a part replaced wherever it is."""
        if self.value(e) == self.value(wrong): return right
        if e[0] in "+*":
            new = tree(e[0], tuple(self.everywhere(p, wrong, right) for p in e[1]))
            return next((self.everywhere_product(n, wrong, right) for n in [new]), new) if e[0] == "*" else new
        if e[0] == "^": return tree("^", self.everywhere(e[1], wrong, right), e[2])
        if e[0] not in "ns": return tree(e[0], *(self.everywhere(p, wrong, right) for p in e[1:]))
        return e
    def everywhere_product(self, e, wrong, right): return e


def of_row(e, place, kind, parts):
    """Copies of a row, as left side minus right side, with a change of one of its entries."""
    factor = number(-1)
    if m := re.fullmatch(r"the coefficient of (\S+)", place): factor = tree("s", m[1])
    wrong = number(0) if kind == "missing" else parts[0]
    right = number(0) if kind == "extra" else parts[-1]
    yield plus(e, tree("*", (factor, plus(right, scaled(wrong, -1)))))


def corrected_values(instant, printed, text):
    """Values of the formulas to which a correction of a printed formula may lead."""
    abbreviations = instant.judge.publication.abbreviations
    changes = changes_of(text, abbreviations)
    tried = 0
    def copies(e, named, rest):
        nonlocal tried
        tried += 1
        if tried > MOST: return
        scope = instant.scope if named is abbreviations else type(instant.scope)(instant, named)
        if not rest:
            try: yield scope(e)[0].a
            except Refused: pass
            return
        (place, kind, parts), *others = rest
        editor = Editor(lambda x: scope(x)[0].a)
        def changed(target):
            if kind == "all": yield editor.everywhere(target, *parts)
            yield from editor.edits(target, "one" if kind == "all" else kind, parts)
        if place in abbreviations:
            for new in changed(named[place]): yield from copies(e, named | {place: new}, others)
            return
        if place and place.startswith("the "):
            for new in of_row(e, place, kind, parts): yield from copies(new, named, others)
        for new in changed(e): yield from copies(new, named, others)
    yield from copies(printed, abbreviations, changes)
