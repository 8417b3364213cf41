"""Tampers with certificates in many ways, and expects that check.py refuses every one.

    tamper.py COUNT FILE…
    tamper.py models COUNT FILE…

With the word `models` it changes masses, inertias, loads and places in the text of the model alone, and expects that
kinematics.py refuses the unchanged equations.

The forger is strong: after a change of the statement he renews hashes, prime and witness, so that only the mathematics
can refuse. Exit status 0 if the files are accepted and COUNT tampered ones of each are refused.
"""
import json, random, re, sys
from check import MALFORMED, Q, check, digest, read, read_certificate
from formula import SMALL, Refused
from kinematics import NotChecked, check_model

ERRORS = (Refused, *MALFORMED)


def proved_prime(statement):
    """The prime that belongs to a statement, as the command finds it."""
    k = (2**125 + int(statement[:31], 16)) // 4 * 4 + 1
    def is_square(n, p): return pow(p if n % 4 == 1 else -p, (n - 1) // 2, n) == 1
    def suits(p): return all(is_square(n, p) for n in SMALL[1:]) and pow(3, p - 1, p) == 1
    while not suits(2 * k * Q + 1): k += 4
    return k


def written(lines, is_renewed):
    """The text of a certificate. A renewed one has the hashes and the prime that belong to its statement."""
    if is_renewed:
        for line, key in ((lines[1], "model_text"), (lines[2], "derivation")): line["sha256"] = digest(line[key])
    dump = lambda line: json.dumps(line, ensure_ascii=False, separators=(",", ":")) + "\n"
    statement = "".join(map(dump, lines[:-2]))
    if is_renewed: lines[-2] = {"prime": str(proved_prime(digest(statement))), "witness": 3}
    return statement + "".join(map(dump, lines[-2:]))


def spoilt(text, rng):
    """A formula with another value."""
    return rng.choice([f"-({text})", f"2*({text})", f"{text} + 1"]) if text != "0" else "1"


def rows_of_motion(lines, derivation, f):
    """Indices of the rows that the claims need. Other rows only determine a multiplier."""
    if f["formulation"] == "kane": return range(len(f["rows"]))
    rates = next(g for g in derivation["formulations"] if g["formulation"] == "kane")["coordinate_rates"]
    if f["formulation"] == "lagrange": return [k for k, rate in enumerate(rates) if not rate.isdigit()]
    return range(len(f["rows"]))


def change_formula(lines, rng):
    """Changes one formula of a derivation, and returns in words which."""
    derivation = json.loads(lines[2]["derivation"])
    f, kind = rng.choice(derivation["formulations"]), rng.randrange(5)
    if kind < 2:
        rows = rows_of_motion(lines, derivation, f)
        k, others = rng.choice(rows), range(len(f["coordinate_rates"]), len(f["unknowns"]))
        columns = [*rows, *others] if f["formulation"] == "lagrange" else range(len(f["unknowns"]))
        entries, at, what = f["mass_matrix"][k], rng.choice(columns), "coefficient"
        if kind: entries, at, what = f["forcing"], k, "right-hand side"
        entries[at] = spoilt(entries[at], rng)
    elif kind == 2:
        entries = next(g for g in derivation["formulations"] if g["formulation"] == "kane")["coordinate_rates"]
        at, what = rng.randrange(len(entries)), "rate of a coordinate"
        entries[at] = spoilt(entries[at], rng)
    elif kind == 3 and f["accelerations"]:
        step, what = rng.choice([a for a in f["accelerations"] if a["name"].endswith("'")]), "acceleration"
        step["value"] = spoilt(step["value"], rng)
    else:
        what = rng.choice(["kinetic_energy", "potential_energy", "power"])
        f[what] = spoilt(f[what], rng)
    lines[2]["derivation"] = json.dumps(derivation, indent=2)
    return f"{what} in a derivation"


def tampered(text, rng, kind):
    """One tampered certificate, and in words what was changed."""
    lines = [json.loads(line) for line in text.split("\n") if line]
    body = range(3, len(lines) - 4)
    if kind < 10:
        what = change_formula(lines, rng)
        return written(lines, True), what
    if kind == 10:
        key, line = rng.choice([("model_text", lines[1]), ("derivation", lines[2])])
        at = rng.randrange(len(line["sha256"]))
        line["sha256"] = line["sha256"][:at] + ("0" if line["sha256"][at] != "0" else "1") + line["sha256"][at + 1:]
        return written(lines, False), f"hash of the {key}"
    if kind == 11:
        lines[1]["model_text"] = lines[1]["model_text"].replace("value = ", "value = 1", 1)
        is_renewed = rng.random() < 0.5
        return written(lines, is_renewed), "model text"
    if kind == 12:
        k = int(lines[-2]["prime"])
        lines[-2]["prime"] = str(rng.choice([k + 4, k - 4, k + 2**20, 5, proved_prime(digest(str(rng.random())))]))
        return written(lines, False), "prime"
    if kind == 13:
        lines[-2]["witness"] = rng.choice([0, 1])
        return written(lines, False), "witness of the prime"
    if kind == 14:
        del lines[-1]["identities"][rng.randrange(len(lines[-1]["identities"]))]
        return written(lines, False), "missing identity"
    if kind == 15:
        name = rng.choice(lines[-1]["identities"])
        name[-1] += "'"
        return written(lines, False), "name of an identity"
    if kind == 16:
        lists = [v for v in lines[-4]["nonzero"].values() if v] or [lines[-4]["nonzero"]["kane"]]
        chosen = rng.choice(lists)
        if chosen and rng.random() < 0.5: del chosen[rng.randrange(len(chosen))]
        else: chosen.append("unstated + 1")
        return written(lines, True), "divisors"
    if kind == 17:
        del lines[rng.choice(body)]
        return written(lines, True), "missing line"
    line = rng.choice([lines[at] for at in body])
    if "integral" in line and rng.random() < 0.5:
        speed = next(iter(json.loads(lines[2]["derivation"])["formulations"][0]["rows"]))
        same, none = line["multipliers"], ["0"] * len(line["multipliers"])
        options = [(f"({line['value']})^2", same), ("1", same), ("1", none), (f"{speed}'", none)]
        line["value"], line["multipliers"] = rng.choice(options)
        return written(lines, True), "value of an integral"
    if "reactions" in line:
        r = rng.choice(line["values"])
        r["value"] = spoilt(r["value"], rng)
        return written(lines, True), "value of a reaction"
    if "without_effect" in line:
        name = rng.choice(list(line["along"]))
        line["along"][name] = spoilt(line["along"][name], rng)
        return written(lines, True), "rate of a parameter"
    row = line["multipliers"] if "integral" in line else rng.choice(line["multipliers"])
    at = rng.randrange(len(row))
    row[at] = spoilt(row[at], rng)
    return written(lines, True), "multiplier"


def forgeries(text):
    """Certificates with renewed hashes whose lines or names mean something else, each with words of its refusal."""
    def changed(edit, words):
        lines = [json.loads(line) for line in text.split("\n") if line]
        derivation = json.loads(lines[2]["derivation"])
        edit(lines, {f["formulation"]: f for f in derivation["formulations"]})
        lines[2]["derivation"] = json.dumps(derivation)
        return written(lines, True), words
    def named(name): return lambda _, by: by["kane"]["named"].append({"name": name, "value": "0"})
    def idle(lines, by):
        """A function that is zero in every motion."""
        q, rate = by["lagrange"]["rows"][0], by["kane"]["coordinate_rates"][0]
        none = ["0"] * len(by["kane"]["rows"])
        lines.insert(3, {"integral": "idle", "value": f"{q}' - ({rate})", "multipliers": none,
                         "named": by["kane"]["named"], "is_energy": False, "is_momentum_of": None, "while_constant": []})
    def signed(lines, by):
        """A force with the factor √u² / u = ±1."""
        kane, speed = by["kane"], by["kane"]["rows"][0]
        row = next(k for k, b in enumerate(kane["forcing"]) if b != "0")
        kane["forcing"][row] = f"({kane['forcing'][row]})*sqrt({speed}^2)/{speed}"
        lines[-4]["nonzero"]["kane"].append(speed)
    def without_values(lines, by):
        """Other energies in all formulations, and no accelerations or values of reactions that would contradict."""
        for f in by.values(): f.update(accelerations=[], kinetic_energy=f"7*({f['kinetic_energy']})")
        lines[3:-4] = [line for line in lines[3:-4] if "combination" in line]
        lines[-4]["nonzero"] = {name: [] for name in (*by, *(f"multipliers of {name}" for name in by))}
    def fixed(lines, by):
        """A coordinate that stands still, by a constraint."""
        by["lagrange"]["unknowns"].append("hidden"), by["lagrange"]["rows"].append("constraint hidden")
        for row in by["lagrange"]["mass_matrix"]: row.append("0")
        by["lagrange"]["mass_matrix"].append(["1"] + ["0"] * len(by["lagrange"]["mass_matrix"][0][1:]))
        by["lagrange"]["forcing"].append("0")
    def with_speeds(lines, by):
        """Lagrange's kinetic energy with a factor that vanishes in every motion."""
        q = next(line["is_momentum_of"] for line in lines if line.get("is_momentum_of"))
        at = next(k for k, name in enumerate(by["lagrange"]["rows"]) if name != q)
        rest = f"{by['lagrange']['rows'][at]}' - ({by['kane']['coordinate_rates'][at]})"
        by["lagrange"]["kinetic_energy"] += f" + ({rest})*{by['kane']['rows'][0]}"
        lines[-4]["nonzero"]["lagrange"] += lines[-4]["nonzero"]["kane"]
    lines = [json.loads(line) for line in text.split("\n") if line]
    by = {f["formulation"]: f for f in json.loads(lines[2]["derivation"])["formulations"]}
    for name in ("pi", "", by["lagrange"]["unknowns"][0], by["lagrange"]["rows"][0]):
        yield changed(named(name), "a named term has")
    yield changed(lambda lines, _: lines[-4].update(derivation="{}"), "unknown members")
    yield changed(lambda lines, _: lines[0].update(x={"prime": 1}), "unknown members")
    yield changed(lambda lines, _: lines[0].update(model="another"), "title")
    yield changed(lambda _, by: by["lagrange"]["coordinate_rates"].__setitem__(0, "77"), "rates of the coordinates")
    yield changed(lambda _, by: by["kane"]["forcing"].__setitem__(0, "2^1000000000"), "exponent")
    yield changed(idle, "is a constant")
    yield changed(fixed, "the model lacks constraint hidden")
    if any(b != "0" for b in by["kane"]["forcing"]): yield changed(signed, "the sides differ")
    if ["kane", "power", "rate"] in lines[-1]["identities"]: yield changed(without_values, "kane, power, rate")
    if any(line.get("is_momentum_of") for line in lines): yield changed(with_speeds, "kinetic energy contains speeds")
    for at, line in enumerate(lines):
        if line.get("while_constant"):
            yield changed(lambda lines, _, at=at: lines[at].update(while_constant=[]), "it holds only while")
        for other in set(line.get("along", ())) - {line.get("without_effect")}:
            doubled = f"2*({line['along'][other]})"
            yield changed(lambda lines, _, at=at: lines[at]["along"].update({other: doubled}), "parameter ")


ONE, SEVERAL = "mass|inertia|stiffness", "diagonal|acceleration|vector|position|centre|at"
PHYSICAL = re.compile(rf'\b(?:(?:{ONE}) = "[^"]*"|(?:{SEVERAL}) = \[[^\]]*\])')


def with_other_model(text, rng):
    """A certificate of the same equations for a model with one other formula, and this formula."""
    lines = [json.loads(line) for line in text.split("\n") if line]
    model = lines[1]["model_text"]
    values = [(value.start(), value[0]) for value in PHYSICAL.finditer(model)]
    formulas = [(start + f.start(1), f[1]) for start, value in values for f in re.finditer('"([^"]+)"', value)]
    at, formula = rng.choice([(at, f) for at, f in formulas if not f.isdigit()])
    lines[1]["model_text"] = f"{model[:at]}2*({formula}){model[at + len(formula):]}"
    return written(lines, True), formula


def spoil_models(count, paths):
    """Expects that kinematics.py refuses certificates whose model is another."""
    wrong, refused = [], 0
    for path in paths:
        text, rng = read(path), random.Random(path.rsplit("/", 1)[-1])
        done, left = check_model(text)
        print(f"{path}: {len(done)} statements hold")
        for _ in range(count):
            forged, what = with_other_model(text, rng)
            try: wrong.append(f"{path}: accepted with a changed {what}: {check_model(forged)}")
            except (NotChecked, *ERRORS) as why:
                if "differs from the model" in str(why): refused += 1
                else: wrong.append(f"{path}: not refused for its mechanics with a changed {what}: {why}")
    print(*wrong, f"{refused} changed models are refused, {len(wrong)} accepted", sep="\n")
    return 1 if wrong else 0


def refuse_all(argv, checker, tampered, kinds):
    """Checks the certificates argv[1:], and that argv[0] tampered ones of each are refused; returns the exit status.

    `checker(text)` returns a summary and the statements that were left unchecked; `tampered(text, rng, kind)` a forged
    text and what was changed, or None. A forgery that leaves more statements unchecked counts as refused.
    """
    count, wrong, refused, errors = int(argv[0]), [], {}, (NotChecked, *ERRORS)
    sys.setrecursionlimit(20_000)
    for path in argv[1:]:
        text, rng = read(path), random.Random(path.rsplit("/", 1)[-1])
        summary, missing = checker(text)
        print(f"{path}: {summary}")
        done, at = 0, 0
        while done < count:
            found, at = tampered(text, rng, at % kinds), at + 1
            if not found: continue
            done += 1
            forged, what = found
            try:
                summary, more = checker(forged)
                if not set(more) - set(missing): wrong.append(f"{path}: accepted although changed: {what}: {summary}")
                else: refused.setdefault(what, []).append(f"not checked: {more}")
            except errors as why: refused.setdefault(what, []).append(str(why))
    for what, reasons in refused.items():
        print(f"{len(reasons)} with a changed {what} are refused, such as: {reasons[0][:100]}")
    count = sum(map(len, refused.values()))
    print(*wrong, f"{count} tampered certificates are refused, {len(wrong)} accepted", sep="\n")
    return 1 if wrong else 0


def main(argv):
    if argv[0] == "models": return spoil_models(int(argv[1]), argv[2:])
    count, wrong, refused, tried = int(argv[0]), [], {}, []
    sys.setrecursionlimit(20_000)
    for path in argv[1:]:
        text, rng = read(path), random.Random(path.rsplit("/", 1)[-1])
        model = read_certificate(text)["model_text"]
        print(f"{path}: {check(text, model)}")
        for forged, words in forgeries(text):
            tried.append(words)
            try: wrong.append(f"{path}: accepted instead of `{words}`: {check(forged, model)}")
            except ERRORS as why:
                if words not in str(why): wrong.append(f"{path}: refused, but not for `{words}`: {why}")
        for at in range(count):
            forged, what = tampered(text, rng, at % 20)
            try: wrong.append(f"{path}: accepted although changed: {what}: {check(forged, model)}")
            except ERRORS as why: refused.setdefault(what, []).append(str(why))
    for what, reasons in refused.items():
        print(f"{len(reasons)} with a changed {what} are refused, such as: {reasons[0][:90]}")
    print(f"{len(tried)} forgeries with other names, lines and claims: {', '.join(sorted(set(tried)))}")
    count = sum(map(len, refused.values()))
    print(*wrong, f"{count} tampered certificates are refused, {len(wrong)} accepted", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
