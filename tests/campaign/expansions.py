"""Kind `expansions`: printed formulas that hold near a point, to first or second order, right and wrong ones.

The printed formula is Taylor's polynomial of a derived one, by this program's own differentiation of trees. It is
right if it has the same slopes at the point up to its order; its higher terms do not matter.
"""
import itertools, os
import numpy as np
import publications
from fractions import Fraction
from expressions import add, count, derivative, mul, num, power, read, substituted, sym, symbols, value
from mechanism import Mechanism
from mechanisms import write
from notation import Notation
from publications import RIGHT, WRONG, States, quoted, truths
from rewriting import broken, equal_form
from verdict import Outcome


class Point:
    """A point of expansion: values of the coordinates; rates and speeds are 0 there."""
    def __init__(self, r, d, speeds):
        self.at = {c: r.choice([0, 0, 0, Fraction(1, 2), Fraction(-1, 4)]) for c in d.start if c[0] != "e"}
        self.at |= {u: 0 for u in speeds}
        self.names = list(self.at)

    def scope(self, states):
        """Numbers of all names at the point, with the random parameters of a state."""
        scope = dict(states)
        scope |= {name: float(v) for name, v in self.at.items()}
        return scope | {f"{name}'": 0.0 for name in self.names}

    def text(self):
        return "{ " + ", ".join(f"{n} = {float(v)!r}" if v else f"{n} = 0" for n, v in self.at.items()) + " }"

    def polynomial(self, tree, order):
        """Taylor's polynomial of a tree, as a tree."""
        table = {name: num(v) for name, v in self.at.items()}
        names = [n for n in self.names if n in symbols(tree)]
        terms = [substituted(tree, table)]
        for degree in range(1, order + 1):
            for chosen in itertools.combinations_with_replacement(names, degree):
                slope = tree
                for name in chosen:
                    slope = derivative(slope, name)
                factor = Fraction(1)
                for name in set(chosen):
                    factor /= 2 if chosen.count(name) == 2 else 1
                terms.append(mul(num(factor), substituted(slope, table), *(add(sym(n), num(-self.at[n])) if self.at[n]
                                                                   else sym(n) for n in chosen)))
        kept = [t for t in terms if not is_zero(t)]
        return add(*kept) if kept else num(0)

    def slopes(self, tree, order, scope):
        """Values of all derivatives up to an order at the point."""
        result, level = [value(tree, scope)], [tree]
        for _ in range(order):
            level = [derivative(t, n) for t in level for n in self.names]
            result += [value(t, scope) for t in level]
        return np.array(result)


def is_zero(tree):
    """Whether a tree is 0 at random values of its names."""
    r = np.random.default_rng(3)
    scope = {n: r.uniform(0.5, 1.5) for n in sorted(symbols(tree))}
    return abs(value(tree, scope)) < 1e-13


def entries(r, d, mechanism, formulations):
    """Entries as (id, lines, truth), with the notation in which they are printed."""
    speeds = [u[:-1] for u in formulations["kane"]["unknowns"]]
    states, point = States(r, d, mechanism), Point(r, d, speeds)
    names = [*d.sections["parameters"], *d.start, *speeds, *d.sections["inputs"]]
    notation = Notation(r.choice(["latex", "python", "matlab", "tripos"]), r, names)
    every = [t for t in truths(d, mechanism, formulations) if t[1] not in ("0", "1") and len(t[1]) < 400]
    r.shuffle(every)
    result = []
    for name, text, _ in every[:6]:
        tree, order = read(text), r.choice([1, 1, 2])
        if symbols(tree) & formulations["named"] or any("'" in s for s in symbols(tree)) or "t" in symbols(tree):
            continue
        if not symbols(tree) & set(point.names) or any(s[0] == "e" for s in symbols(tree) & set(d.start)):
            continue
        printed = point.polynomial(tree, order)
        if printed[0] == "n" or count(printed) > 300:
            continue
        if r.random() < 0.5:
            printed = broken(r, printed, sorted(symbols(printed)))
        if r.random() < 0.4:
            # Another form near the point: a higher term, or a sine in place of its angle.
            x = r.choice(point.names)
            if point.at[x] == 0:
                printed = add(printed, mul(num(r.choice([2, -1])), power(sym(x), order + 1), sample(r, d)))
        printed = equal_form(r, printed, r.choice([0, 1, 2]), names)
        truth = judged(states, point, tree, printed, order)
        if truth is None:
            continue
        key = f"n{len(result)}"
        lines = ["[[equation]]", f'id = "{key}"', 'section = "1"', f'quantity = "{name}"', f"order = {order}",
                 f"about = {point.text()}", f"printed = {quoted(notation.text(printed))}"]
        result.append((key, lines, truth))
    return notation, result


def sample(r, d):
    return sym(r.choice(list(d.sections["parameters"])))


def judged(states, point, tree, printed, order):
    """Right, wrong, or `None` if the numbers do not tell."""
    worst = 0.0
    for scope in states.scopes:
        here = point.scope(scope)
        try:
            mine = point.slopes(printed, order, here)
            true = point.slopes(tree, order, here)
        except (ZeroDivisionError, OverflowError):
            return None
        if not np.isfinite(mine).all() or not np.isfinite(true).all():
            return None
        worst = max(worst, float(np.abs(mine - true).max() / (np.abs(true).max() + np.abs(mine).max() + 1e-300)))
    return True if worst < RIGHT else False if worst > WRONG else None


def judge(random, program, folder, hostile):
    """One case of the kind."""
    try:
        d = publications.model(random, hostile)
        mechanism = Mechanism(d.text())
        path, printed = os.path.join(folder, "model.toml"), os.path.join(folder, "publication.toml")
        write(path, d.text())
        answer = program("derive", path, "--json")
        if answer.panicked or answer.expired:
            return Outcome("panic" if answer.panicked else "time-out", "derive: " + answer.reason)
        if not answer.json or "formulations" not in answer.json:
            return Outcome("refused", answer.reason)
        formulations = {f["formulation"]: f for f in answer.json["formulations"]}
        formulations["named"] = {n["name"] for f in answer.json["formulations"] for n in f["named"]}
        notation, found = entries(random, d, mechanism, formulations)
    except (np.linalg.LinAlgError, ZeroDivisionError):
        return Outcome("unjudged", "the oracle's equations are singular")
    if not found:
        return Outcome("unjudged", "no formula is short enough")
    lines = ['title = "Random expansions"', 'source = "the campaign"', f'notation = "{notation.kind}"', ""]
    if notation.symbols:
        lines += ["[symbols]", *(f"{quoted(new)} = \"{name}\"" for new, name in notation.symbols.items()), ""]
    write(printed, "\n".join(lines + [line for _, entry, _ in found for line in [*entry, ""]]))
    answer = program("diff", path, printed, "--json")
    if answer.panicked or answer.expired:
        return Outcome("panic" if answer.panicked else "time-out", "diff: " + answer.reason)
    if not answer.json or "equations" not in answer.json:
        return Outcome("refused", answer.reason)
    said = {e["id"]: e for e in answer.json["equations"]}
    wrong, undecided = [], 0
    for key, _, truth in found:
        verdict = said[key]["verdict"]
        undecided += verdict == "undecided"
        if verdict in ("equal", "scaled") and not truth and not said[key].get("up_to"):
            wrong.append(f"{key} is acquitted and wrong")
        elif verdict == "different" and truth:
            wrong.append(f"{key} is convicted and right")
    if wrong:
        return Outcome("wrong", f"{notation.kind}: " + "; ".join(wrong), len(found))
    if undecided:
        return Outcome("undecided", "an entry is undecided", len(found) - undecided)
    return Outcome("right", "", len(found))
