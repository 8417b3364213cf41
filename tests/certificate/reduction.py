"""Checks a certificate of `tripos scene SCENE --certificate FILE` with the standard library of Python alone.

    reduction.py FILE [--model MODEL_OR_FOLDER] [--scene FILE]

The whole model's coordinates and speeds, written in the variables of the reduced equations, must satisfy the whole
model's equations along the reduced motion. Exit status 0 if every claim holds, 1 if one does not, and 3 if parts were
not checked. docs/certificate.md states the format and what is checked.
"""
import json, sys, tomllib
from check import MALFORMED, check, check_prime, digest, read, read_certificate, unique
from claims import rank
from formula import NextPoint, Refused, Residue, Residues, Scope, need, parse, tree
from kinematics import NotChecked, check_model, known
from publication import renamed, symbols_in

LINES = ["tripos_reduction scene", "proof sha256", "scene_text sha256", "folded",
         "states quadratures named coordinate_rates speeds mass_matrix forcing", "constants positions", "outputs time",
         "variables whole", "not_certified", "prime witness"]
MARK = "reduced "  # Before the names of the reduced equations, which may be those of the whole model.
ENERGIES = {"kinetic_energy": (1, 0), "potential_energy": (0, 1), "total_energy": (1, 1)}


def read_reduction(text):
    """The certificate as a dictionary, with the hash of its statement."""
    lines = text.split("\n")
    need(lines.pop() == "" and all(lines), "the last line is open, or a line is empty")
    records = [json.loads(line, object_pairs_hook=unique) for line in lines]
    need([set(r) for r in records] == [set(keys.split()) for keys in LINES], "a line has unknown members")
    need(records[0]["tripos_reduction"] == 1, "this is no certificate of a reduction of version 1")
    for record, key in ((records[1], "proof"), (records[2], "scene_text")):
        need(record["sha256"] == digest(record[key]), f"the hash of the {key} is wrong")
    need(records[-2]["not_certified"], "the certificate does not say what it leaves out")
    c = {key: value for record in records for key, value in record.items() if key != "sha256"}
    return c | {"statement": digest("".join(line + "\n" for line in lines[:-1]))}


def formulas(list, what):
    """Trees of definitions, by their names."""
    found = {d["name"]: parse(d["value"]) for d in list}
    need(len(found) == len(list), f"{what}: a name is given twice")
    return found


def number_of(model, scene, name):
    """Number of a parameter in a scene: the scene's own, or the model's. As a tree."""
    own = scene.get("parameters", {}).get(name, scene.get("inputs", {}).get(name))
    declared = model.get("parameters", {}).get(name, model.get("inputs", {}).get(name))
    value = own if own is not None else declared.get("value") if isinstance(declared, dict) else declared
    need(value is not None, f"the parameter {name} has no number")
    return parse(str(value))


class Reduction:
    """Claims of a certificate at one point."""
    def __init__(self, r, c, domain):
        self.r, self.c, self.domain, self.done = r, c, domain, []
        by = {f["formulation"]: f for f in c["derivation"]["formulations"]}
        self.kane, self.model = by["kane"], c["model"]
        self.coordinates = by["lagrange"]["rows"][:len(self.kane["coordinate_rates"])]
        scene = tomllib.loads(r["scene_text"], parse_float=str)
        is_number = lambda x: not isinstance(x, (dict, list)) and not symbols_in(parse(str(x)))
        known(all(map(is_number, scene.get("inputs", {}).values())), "inputs of a scene that are no numbers")
        self.scene = scene
        free = {*self.model.get("parameters", {}), *self.model.get("inputs", {})} - set(r["folded"])
        variables, self.constants = formulas(r["variables"], "variables"), formulas(r["constants"], "constants")
        self.whole_values = formulas(r["whole"], "whole")
        named = formulas(r["named"], "named")
        positions = [p["name"] for p in r["positions"]]
        own = [*variables, *self.constants, *named, *positions, r["time"]]
        need(len(set(own)) == len(own) and not set(own) & (free | {"pi"}), "a name has two meanings")
        self.marks = {name: tree("s", MARK + name) for name in own}
        states = sorted([*self.coordinates, *self.kane["rows"]])
        need(sorted(self.whole_values) == states, "a coordinate or speed is missing")
        self.check_numbers()
        # Motion on the level set.
        self.constant_values = {MARK + name: (domain.symbol(MARK + name), None) for name in self.constants}
        values = {MARK + name: domain.symbol(MARK + name) for name in variables}
        still = self.scope({name: (x, None) for name, x in values.items()} | self.constant_values, {}, free)
        rates = {MARK + name: still(renamed(e, self.marks))[0] for name, e in variables.items()}
        self.motion = {name: (x, rates[name]) for name, x in values.items()}
        # The whole model along this motion.
        folded = {name: parse(value) for name, value in r["folded"].items()}
        written = {name: renamed(e, self.marks) for name, e in self.whole_values.items()}
        inside = self.scope(self.motion | self.constant_values, {}, free)
        for name, e in written.items(): inside(e)
        terms = {d["name"]: parse(d["value"]) for d in self.kane["named"]}
        need(not set(terms) & set(written), "a named term has the name of a variable")
        self.whole = Scope(domain, self.motion | self.constant_values, terms | written | folded)
        self.free, self.named, self.rates = free, named, rates

    def scope(self, symbols, named, names):
        """Scope of formulas that contain only these symbols, definitions and parameters."""
        return Known(self.domain, symbols, named, names)

    def check_numbers(self):
        """The parameters that are numbers have those of the scene."""
        for name, value in self.r["folded"].items():
            is_known = name in {**self.model.get("parameters", {}), **self.model.get("inputs", {})}
            need(is_known, f"{name} is no parameter")
            both = parse(value), number_of(self.model, self.scene, name)
            numbers = [Scope(self.domain, {}, {})(e)[0] for e in both]
            need(numbers[0].v == numbers[1].v, f"the scene has another number for {name}")

    def same(self, left, right, what):
        need(left.v == right.v, f"{what} does not hold")
        self.done.append(what)

    def check(self):
        r, zero = self.r, Residue(0)
        rate = lambda e: self.whole(e)[1] or zero
        for q, text in zip(self.coordinates, self.kane["coordinate_rates"]):
            self.same(rate(q), self.whole(text)[0], f"the kinematic equation of {q}")
        for u, row, right in zip(self.kane["rows"], self.kane["mass_matrix"], self.kane["forcing"]):
            total = zero - self.whole(right)[0]
            for e, v in zip(row, self.kane["rows"], strict=True): total = total + self.whole(e)[0] * rate(v)
            self.same(total, zero, f"Kane's equation of {u}")
        for name, e in self.constants.items():
            self.same(self.whole(e)[0], self.constant_values[MARK + name][0], f"the constant {name}")
        self.check_equations()
        self.check_outputs()
        return self.done

    def reduced(self, variables, more=None):
        """Scope of the reduced equations, which knows only these variables and the constants."""
        known_variables = {MARK + name: self.motion[MARK + name] for name in variables}
        named = {MARK + name: renamed(e, self.marks) for name, e in self.named.items()}
        return self.scope(known_variables | self.constant_values | (more or {}), named, self.free)

    def check_equations(self):
        """The reduced equations have the rates of the motion, and those of the states contain only states."""
        r = self.r
        states, all = r["states"], [*r["states"], *r["quadratures"]]
        need(len(set(all)) == len(all) and all_in(all, self.motion), "a variable of the reduced equations is unknown")
        rates = formulas(r["coordinate_rates"], "rates")
        need(sorted([*rates, *r["speeds"]]) == sorted(all), "a reduced equation is missing")
        scope, of_states = self.reduced(all), self.reduced(states)
        for name, e in rates.items():
            self.same(scope(renamed(e, self.marks))[0], self.rates[MARK + name], f"the rate of {name}")
            if name in states: of_states(renamed(e, self.marks))
        rows = list(zip(r["speeds"], r["mass_matrix"], r["forcing"], strict=True))
        for u, row, right in rows:
            # A speed that is a state needs a row without quadratures, unless all speeds are solved together.
            own = of_states if u in states else scope
            total = own(renamed(parse(right), self.marks))[0]
            for e, v in zip(row, r["speeds"], strict=True):
                x = own(renamed(parse(e), self.marks))[0]
                need(not x.v or u not in states or v in states, f"the rate of {u} depends on that of {v}")
                total = total - x * self.rates[MARK + v]
            self.same(total, Residue(0), f"the reduced equation of {u}")
        found = rank([[scope(renamed(parse(e), self.marks))[0] for e in row] for _, row, _ in rows]) if rows else 0
        need(found == len(rows), "the reduced equations do not determine the rates")

    def check_outputs(self):
        """The outputs are those of the scene, with the values of the whole model."""
        r, t = self.r, MARK + self.r["time"]
        time = self.domain.symbol(t)
        more = {t: (time, None)}
        for p in r["positions"]:
            position, rate = self.whole(parse(p["position"]))
            momentum = self.constant_values[MARK + p["rate"]][0]
            self.same(rate or Residue(0), momentum, f"the motion of {p['name']}")
            more[MARK + p["name"]] = position - momentum * time, None
        values = {o["name"]: renamed(parse(o["value"]), self.marks) for o in r["outputs"]}
        wanted = self.scene.get("outputs", [*self.coordinates, *self.kane["rows"]])
        wanted = [(o["name"], o["value"]) if isinstance(o, dict) else (o, o) for o in wanted]
        need(sorted(values) == sorted(name for name, _ in wanted), "the outputs are not those of the scene")
        scope = self.reduced([*r["states"], *r["quadratures"]], more)
        for name, formula in wanted:
            found = scope(values[name])[0]
            self.same(found, self.output(formula), f"the output {name}")

    def output(self, formula):
        """Value of an output for the whole model."""
        energy = lambda key: self.whole(self.kane[key])[0]
        if formula in ENERGIES and formula not in self.whole_values:
            a, b = ENERGIES[formula]
            parts = [energy("kinetic_energy")] * a + [energy("potential_energy")] * b
            return sum(parts[1:], parts[0])
        try: e = parse(formula)
        except Refused: raise NotChecked(f"the output {formula}") from None
        meanings, names = {}, {*self.whole_values, *self.free, *self.r["folded"], "pi"}
        for name in symbols_in(e) - names:
            known(name.endswith("'") and name[:-1] in self.whole_values, f"the output {formula}")
            meanings[name] = name[:-1]
        symbols = {name: (self.whole(of)[1] or Residue(0), None) for name, of in meanings.items()}
        return Scope(self.domain, self.whole.symbols | symbols, self.whole.named)(e)[0]


class Known(Scope):
    """Values of formulas that contain only known names."""
    def __init__(self, domain, symbols, named, parameters):
        super().__init__(domain, symbols, named)
        self.parameters = parameters | {"pi"}
    def evaluated(self, e, kind, a):
        is_known = kind != "s" or a in self.symbols or a in self.named or a in self.parameters
        need(is_known, f"a reduced formula contains {str(a).removeprefix(MARK)}")
        return super().evaluated(e, kind, a)


def all_in(names, motion): return all(MARK + name in motion for name in names)


def check_reduction(text, model=None, scene=None):
    """Checks a certificate of a reduction. Returns a summary, and what was not checked."""
    r = read_reduction(text)
    need(scene in (None, r["scene_text"]), "the scene is another than that of the certificate")
    check(r["proof"], model)
    c = read_certificate(r["proof"])
    try: missing = check_model(r["proof"])[1]
    except NotChecked as why: missing = [str(why)]
    Residue.P = check_prime(int(r["prime"]), r["witness"], r["statement"])
    parameters = c["model"].get("parameters", {})
    positive = {name for name, p in parameters.items() if isinstance(p, dict) and p.get("positive")}
    count, others, Scope.PARTS = 0, set(), 1
    for at in range(5000):
        try: done = Reduction(r, c, domain := Residues(f"{r['statement']} {at}".encode(), positive)).check()
        except NextPoint as root:
            others |= set(root.args)
            continue
        count += 1
        if count == 64 or count >= 2 and not set(domain.roots.values()) - others: break
    else: raise Refused("too few points were found at which all roots exist")
    return f"{len(done)} identities hold: the reduced motion is one of the whole model", missing


def main(argv):
    options = dict(zip(argv[1::2], argv[2::2], strict=True))
    sys.setrecursionlimit(20_000)
    try:
        need(set(options) <= {"--model", "--scene"}, f"unknown options {set(options)}")
        model, scene = options.get("--model"), options.get("--scene")
        words, missing = check_reduction(read(argv[0]), model and read(model, "model.toml"), scene and read(scene))
    except NotChecked as why:
        print(f"{argv[0]}: not checked: {why}")
        return 3
    except (Refused, OSError, *MALFORMED) as why:
        print(f"{argv[0]}: refused: {why if isinstance(why, Refused) else repr(why)}")
        return 1
    print(f"{argv[0]}: {words}")
    for reason in missing: print(f"{argv[0]}: not checked: the equations of the model: {reason}")
    return 3 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
