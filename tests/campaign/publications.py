"""Kind `publications`: printed equations, right and wrong ones, whose verdicts the oracle knows.

An entry starts from a formula that the program derived, is rewritten into an equal form or broken, and is printed in a
notation. Whether the printed entry is right is decided by its values: against the oracle's value of the quantity, or
by the oracle's accelerations put into a printed row, at random states and random parameters.
"""
import functools, os
import numpy as np
import rollers, trees
from draft import toml
from expressions import add, count, mul, neg, nodes, num, read, replaced, size, substituted, sym, symbols, value
from fittings import fit
from formula import Numbers, evaluate
from makers import choose_speeds
from mechanism import Mechanism
from mechanisms import write
from notation import Notation
from oracle import equations, permitted
from rewriting import broken, equal_form
from verdict import Outcome

STATES = 3
# Relative difference below which a printed value is right, and above which it is wrong. Between them nothing is judged.
RIGHT, WRONG = 1e-9, 1e-5


def model(r, hostile):
    """A small mechanism without numbers of its own: all its quantities are symbols."""
    few = ["pin", "pin", "pin", "slider", "slider", "cylinder", "universal", "screw", "ball"]
    make = r.choice([
        functools.partial(trees.joint_tree, size=r.choice([1, 2, 2, 3]), kinds=few, literals=False),
        functools.partial(trees.joint_tree, size=r.choice([1, 2]), kinds=few, literals=False),
        functools.partial(trees.placed_tree, literals=False),
        functools.partial(rollers.disc, literals=False), functools.partial(rollers.sleigh, literals=False)])
    d = fit(make(r, hostile), 2)
    for entry in d.sections["inputs"].values():
        entry["value"] = 0
    choose_speeds(d)
    return d


class States:
    """Random states with random parameters, and the oracle's equations there."""
    def __init__(self, r, d, mechanism):
        self.scopes, self.solved = [], []
        for k in range(STATES):
            parameters = Numbers(mechanism.values())
            for name, entry in d.sections["parameters"].items():
                low, high = (0.5, 2.5) if entry.get("positive") else (-2.0, 2.0)
                parameters[name] = r.uniform(low, high)
            for name in d.sections["inputs"]:
                parameters[name] = r.uniform(-2, 2)
            q = {c: v[0] + (r.uniform(-0.2, 0.2) if c[0] != "e" else 0) for c, v in d.start.items()}
            rates = {c: r.uniform(-1.5, 1.5) for c in d.start}
            q = {c: q[c] for c in mechanism.coordinates}
            time = r.uniform(0.2, 2)
            rates = permitted(mechanism, q, {c: rates[c] for c in q}, time, parameters)
            inputs = {name: repr(parameters[name]) for name in d.sections["inputs"]}
            eq = equations(mechanism, q, rates, time, parameters, inputs)
            if not eq.condition < 1e6:
                raise np.linalg.LinAlgError
            self.solved.append(eq)
            scope = dict(parameters) | q | {f"{c}'": v for c, v in rates.items()} | {"t": time}
            scope |= {u: float(eq.i.speed(u).v) for u in mechanism.speeds}
            scope |= {f"{u}'": eq.i.rate_of(eq.i.speed(u), eq.accelerations) for u in mechanism.speeds}
            scope |= {f"{c}''": float(a) for c, a in zip(mechanism.coordinates, eq.accelerations)}
            self.scopes.append(scope)

    def values(self, tree):
        return [value(tree, scope) for scope in self.scopes]

    def sizes(self, tree):
        """What rounding is relative to; an acceleration that happens to be 0 counts as 1."""
        return [size(tree, {n: abs(v) + 1.0 if n.endswith("'") else v for n, v in scope.items()})
                for scope in self.scopes]


def basis(eq, speeds):
    """W of q' = W u + w: motions by unit speeds."""
    slopes = np.array([eq.i.speed(u).g[eq.i.n + 1:] for u in speeds])
    return eq.free @ np.linalg.inv(slopes @ eq.free)


def truths(d, mechanism, formulations):
    """Quantities with a derived formula: (name, formula, oracle's value as a function of a solved state)."""
    result = []
    kane = formulations["kane"]
    speeds = [u[:-1] for u in kane["unknowns"]]
    for a in range(len(speeds)):
        def forcing(eq, a=a):
            w = basis(eq, speeds)
            rates = np.array([eq.i.rate_of(eq.i.speed(u), eq.accelerations) for u in speeds])
            return (w.T @ eq.mass @ w)[a] @ rates
        result.append((f"f[{a + 1}]", kane["forcing"][a], forcing))
        for b in range(len(speeds)):
            def entry(eq, a=a, b=b):
                w = basis(eq, speeds)
                return (w.T @ eq.mass @ w)[a, b]
            result.append((f"M[{a + 1},{b + 1}]", kane["mass_matrix"][a][b], entry))
    result.append(("T", kane["kinetic_energy"], lambda eq: eq.kinetic))
    lagrange = formulations.get("lagrange")
    if lagrange and not any(mechanism.data.get(s) for s in ("constraints", "rolling")) and \
            all(u.endswith("''") for u in lagrange["unknowns"]) and "t''" not in lagrange["unknowns"]:
        names = [u[:-2] for u in lagrange["unknowns"]]
        index = [mechanism.coordinates.index(c) for c in names]
        result.append(("T", lagrange["kinetic_energy"], lambda eq: eq.kinetic))
        for a in range(len(names)):
            result.append((f"A[{a + 1}]", lagrange["forcing"][a], lambda eq, a=a: (eq.q - eq.h)[index[a]]))
            for b in range(len(names)):
                result.append((f"E[{a + 1},{b + 1}]", lagrange["mass_matrix"][a][b],
                               lambda eq, a=a, b=b: eq.mass[index[a], index[b]]))
    for step in kane["steps"]:
        for line in step["lines"]:
            name = line["name"]
            if name.startswith(("v(", "omega(", "p(")) and name.endswith("]") and " @ " in name:
                try:
                    evaluate(name, mechanism_scope(mechanism, d))
                except Exception:
                    continue
                result.append((name, line["value"], functools.partial(component, name)))
    return result


def mechanism_scope(mechanism, d):
    eq = equations(mechanism, {c: d.start[c][0] for c in mechanism.coordinates},
                   {c: d.start[c][1] for c in mechanism.coordinates})
    return eq.i.velocity


def component(name, eq):
    number = evaluate(name, eq.i.velocity)
    return float(number.v) if hasattr(number, "v") else float(number)


class Entry:
    """One printed entry: its text in the publication and whether its verdict must be right or wrong."""
    def __init__(self, ids, lines, right, notation):
        self.ids, self.lines, self.right, self.notation = ids, lines, right, notation


def truth_of(errors):
    """Right, wrong, or `None` if numbers do not tell."""
    if max(errors) < RIGHT:
        return True
    return False if max(errors) > WRONG else None


def relative(printed, true, scale):
    return [abs(p - t) / (s + abs(t) + 1e-300) if np.isfinite(p) else np.nan for p, t, s in zip(printed, true, scale)]


def quoted(text):
    return f"'{text}'" if "\\" in text else f'"{text}"'


class Publication:
    """Random entries about one mechanism."""
    def __init__(self, r, d, mechanism, formulations):
        self.r, self.d, self.m, self.formulations = r, d, mechanism, formulations
        self.states, self.entries = States(r, d, mechanism), []
        self.notation = None
        self.kind = r.choice(["latex", "python", "matlab", "tripos"])
        speeds = [u[:-1] for u in formulations["kane"]["unknowns"]]
        self.names = [*d.sections["parameters"], *d.start, *speeds, *d.sections["inputs"]]
        self.notation = Notation(self.kind, r, self.names)
        # Coordinates of the author: another sign, or another zero.
        self.author, self.shorts = {}, {}
        if r.random() < 0.2:
            for c in d.start:
                if c[0] in "qx" and r.random() < 0.5:
                    self.author[c] = f"pi/2 - {c}" if c[0] == "q" and r.random() < 0.5 else f"-{c}"
        rates = [f"{c}'" for c in d.start]
        self.all_names = [*self.names, *rates]

    def printed(self, tree):
        """The tree in some form, right or broken; and whether it was broken."""
        r = self.r
        wrong = r.random() < 0.5
        if wrong:
            tree = broken(r, tree, sorted(symbols(tree)))
        return equal_form(r, tree, r.choice([0, 1, 2, 4, 6]), self.all_names)

    def show(self, tree):
        """The printed text: in the coordinates of the author, with abbreviations."""
        if self.author:
            table = {}
            for c, form in self.author.items():
                table[c] = read(form)
                table |= {c + dots: neg(sym(c + dots)) for dots in ("'", "''")}
            tree = substituted(tree, table)
        elif self.r.random() < 0.25:
            places = [(p, n) for p, n in nodes(tree) if n[0] == "f" and n[1] in ("sin", "cos") and n[2][0] == "s"]
            for _, node in places[:3]:
                key = repr(node)
                if key not in self.shorts:
                    self.shorts[key] = (f"ab{'cdefghijklmnopqrstuvwxyz'[len(self.shorts) % 24]}", node)
                name = self.shorts[key][0]
                while True:
                    path = next((p for p, n in nodes(tree) if repr(n) == key), None)
                    if path is None:
                        break
                    tree = replaced(tree, path, sym(name))
        return self.notation.text(tree)

    def quantities(self, amount):
        every = [t for t in truths(self.d, self.m, self.formulations) if t[1] not in ("0", "1") and len(t[1]) < 1000]
        if self.author:
            every = [t for t in every if t[0] == "T" or "(" in t[0]]
        self.r.shuffle(every)
        for name, text, oracle in every[:amount]:
            if self.formulations["named"] & set(symbols(read(text))):
                continue
            tree = self.printed(read(text))
            true = [oracle(eq) for eq in self.states.solved]
            try:
                errors = relative(self.states.values(tree), true, self.states.sizes(tree))
            except (ZeroDivisionError, OverflowError):
                continue
            if not np.isfinite(errors).all():
                continue
            key = f"e{len(self.entries)}"
            lines = ["[[equation]]", f'id = "{key}"', 'section = "1"', f'quantity = "{name}"',
                     f"printed = {quoted(self.show(tree))}"]
            self.entries.append(Entry([key], lines, [truth_of(errors)], self.notation))

    def equation(self, by):
        """One printed equation of motion, with terms on both sides."""
        f = self.formulations.get(by)
        if not f or any("''" not in u and not u.endswith("'") for u in f["unknowns"]) or "t''" in f["unknowns"]:
            return
        k = self.r.randrange(len(f["unknowns"]))
        terms = [mul(read(m), sym(u)) for m, u in zip(f["mass_matrix"][k], f["unknowns"]) if m != "0"]
        tree = add(*terms, neg(read(f["forcing"][k])))
        if count(tree) > 350 or self.formulations["named"] & set(symbols(tree)):
            return
        tree = self.printed(tree)
        try:
            sizes = self.states.sizes(tree)
            errors = [abs(v) / (s + 1e-300) for v, s in zip(self.states.values(tree), sizes)]
        except (ZeroDivisionError, OverflowError):
            return
        if not np.isfinite(errors).all() or min(sizes) == 0 or not any(u in symbols(tree) for u in f["unknowns"]):
            return
        r, left, right = self.r, list(tree[1]) if tree[0] == "+" else [tree], []
        while len(left) > 1 and r.random() < 0.4:
            right.append(neg(left.pop()))
        key = f"e{len(self.entries)}"
        text = f"{self.show(add(*left))} = {self.show(add(*right)) if right else '0'}"
        if self.kind in ("python", "matlab"):
            text = self.show(tree) + " = 0"
        lines = ["[[equation]]", f'id = "{key}"', 'section = "2"', f'formulation = "{by}"', f"printed = {quoted(text)}"]
        # A value is judged by the size of its terms, and a row by whether the true accelerations satisfy it.
        self.entries.append(Entry([key], lines, [truth_of(errors)], self.notation))

    def system(self, by):
        """A printed linear system; each row is judged."""
        f = self.formulations.get(by)
        if not f or any(not u.endswith("'") for u in f["unknowns"]) or "t''" in f["unknowns"]:
            return
        n = len(f["unknowns"])
        if n > 4:
            return
        rows, right, truth = [], [], []
        values = []
        for k in range(n):
            texts = [*f["mass_matrix"][k], f["forcing"][k]]
            trees = [read(t) for t in texts]
            if sum(map(count, trees)) > 500 or self.formulations["named"] & set().union(*map(symbols, trees)):
                return
            if self.r.random() < 0.4:
                j = self.r.randrange(n + 1)
                trees[j] = broken(self.r, trees[j], sorted(symbols(trees[j]))) if trees[j][0] != "n" else num(1)
            trees = [equal_form(self.r, t, self.r.choice([0, 1, 2]), self.all_names) for t in trees]
            if self.r.random() < 0.15:
                trees = [mul(num(self.r.choice([2, -1, 3])), t) for t in trees]
            row = add(*(mul(t, sym(u)) for t, u in zip(trees, f["unknowns"])), neg(trees[-1]))
            try:
                sizes = self.states.sizes(row)
                errors = [abs(v) / (s + 1e-300) for v, s in zip(self.states.values(row), sizes)]
                values.append([[value(t, scope) for t in trees[:-1]] for scope in self.states.scopes])
            except (ZeroDivisionError, OverflowError):
                return
            if not np.isfinite(errors).all() or min(sizes) == 0:
                return
            truth.append(truth_of(errors))
            rows.append([self.notation.text(t) for t in trees[:-1]])
            right.append(self.notation.text(trees[-1]))
        for k in range(len(self.states.scopes)):
            matrix = np.array([v[k] for v in values])
            if np.linalg.cond(matrix) > 1e8:
                return
        key = f"s{len(self.entries)}"
        table = ", ".join("[" + ", ".join(quoted(t) for t in row) + "]" for row in rows)
        lines = ["[[system]]", f'id = "{key}"', 'section = "3"', f'formulation = "{by}"',
                 f"unknowns = {toml(list(f['unknowns']))}", f"matrix = [{table}]",
                 "right = [" + ", ".join(quoted(t) for t in right) + "]"]
        self.entries.append(Entry([f"{key}-row{k + 1}" for k in range(n)], lines, truth, self.notation))

    def text(self):
        lines = ['title = "Random publication"', 'source = "the campaign"', f'notation = "{self.kind}"', ""]
        if self.author:
            lines += ["[coordinates]", *(f'{c} = "{form}"' for c, form in self.author.items()), ""]
        if self.shorts:
            lines += ["[abbreviations]", *(f"{name} = {quoted(self.notation.text(node))}"
                                           for name, node in self.shorts.values()), ""]
        used = {new: name for new, name in self.notation.symbols.items()}
        if used:
            lines += ["[symbols]", *(f"{quoted(new) if chr(92) in new else chr(34) + new + chr(34)} = \"{name}\""
                                     for new, name in used.items()), ""]
        for entry in self.entries:
            lines += [*entry.lines, ""]
        return "\n".join(lines)


def judge(random, program, folder, hostile):
    """One case of the kind."""
    try:
        d = model(random, hostile)
        mechanism = Mechanism(d.text())
        path = os.path.join(folder, "model.toml")
        write(path, d.text())
        answer = program("derive", path, "--json")
        if answer.panicked or answer.expired:
            return Outcome("panic" if answer.panicked else "time-out", "derive: " + answer.reason)
        if not answer.json or "formulations" not in answer.json:
            return Outcome("refused", answer.reason)
        formulations = {f["formulation"]: f for f in answer.json["formulations"]}
        formulations["named"] = {n["name"] for f in answer.json["formulations"] for n in f["named"]}
        pub = Publication(random, d, mechanism, formulations)
        pub.quantities(random.choice([2, 3, 5]))
        for _ in range(random.choice([0, 1, 2])):
            pub.equation(random.choice(["kane", "lagrange"]))
        if not pub.author and random.random() < 0.5:
            pub.system(random.choice(["kane", "lagrange"]))
    except (np.linalg.LinAlgError, ZeroDivisionError):
        return Outcome("unjudged", "the oracle's equations are singular")
    if not pub.entries:
        return Outcome("unjudged", "no formula is short enough")
    printed = os.path.join(folder, "publication.toml")
    write(printed, pub.text())
    answer = program("diff", path, printed, "--json")
    if answer.panicked or answer.expired:
        return Outcome("panic" if answer.panicked else "time-out", "diff: " + answer.reason)
    if not answer.json or "equations" not in answer.json and "entries" not in answer.json:
        return Outcome("refused", answer.reason)
    return verdict(pub, answer.json)


def verdict(pub, answer):
    given = {e["id"]: e for e in answer["equations"]}
    for s in answer.get("systems", []):
        for e in s.get("rows", s.get("entries", [])):
            given[e["id"]] = e
    wrong, undecided, judged = [], [], 0
    for entry in pub.entries:
        for key, right in zip(entry.ids, entry.right):
            if right is None or key not in given:
                continue
            said = given[key]["verdict"]
            if said == "undecided":
                undecided.append(key)
                continue
            judged += 1
            if said in ("equal", "scaled") and not right:
                if not given[key].get("up_to"):
                    wrong.append(f"{key} is acquitted and wrong")
            elif said == "different" and right:
                wrong.append(f"{key} is convicted and right")
    if wrong:
        return Outcome("wrong", f"{pub.kind}: " + "; ".join(wrong[:4]), judged)
    if undecided:
        return Outcome("undecided", "an entry is undecided", judged)
    return Outcome("right", "", judged)
