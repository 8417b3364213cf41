"""Checks a certificate of `tripos prove MODEL --certificate FILE` with the standard library of Python alone.

    check.py FILE [--model MODEL_OR_FOLDER] [--derivation JSON]

Exit status 0 if every claim holds, else 1 and the reason. docs/certificate.md states the format and what is checked.
This program decides what must be proved. The certificate supplies multipliers, a prime, and lists to compare with.
"""
import hashlib, json, math, sys, tomllib
from pathlib import Path
from claims import Case
from formula import Bounds, NextPoint, Refused, Residue, Residues, Scope, expanded, need

MALFORMED = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError)
LINES = {frozenset(keys.split()) for keys in (
    "tripos_certificate model", "model_text sha256", "derivation sha256", "combination named multipliers",
    "reactions named values", "integral value multipliers named is_energy is_momentum_of while_constant", "nonzero",
    "without_effect along named", "not_certified", "prime witness", "identities")}
BITS, Q = 64, 2**127 - 1  # A false claim must pass with a chance below 2^-BITS. Q is a prime of Mersenne.
WINDOW = 22  # Of 2^124 numbers, at most 2^22 lead to the same prime.


def check_divisors(cases):
    """Every divisor is a number, or a number times one that the certificate states. Every stated one is needed."""
    stated = cases[0].certificate["nonzero"]
    need(set(stated) == set(cases[0].divisors), "the lists of divisors do not belong to the formulas")
    for name, texts in stated.items():
        found = {(a.v, b.v): t for (t, a), (_, b) in zip(*(c.divisors[name] for c in cases), strict=True)}
        named = cases[0].certificate["named"][name]
        values = [[c.scope(name, c.symbols, named)(text)[0].v for text in texts] for c in cases]
        need(all(map(all, values)), f"{name}: a stated divisor vanishes identically")
        unused = set(range(len(texts)))
        for (a, b), tree in found.items():
            match = [k for k in range(len(texts)) if (a * values[1][k] - b * values[0][k]) % Residue.P == 0]
            need(match or a == b, f"{name}: the divisor {tree} is not stated")
            unused -= set(match)
        need(not unused, f"{name}: no formula is divided by {[texts[k][:80] for k in unused]}")


def check_prime(k, witness, digest):
    """The prime 2 k Q + 1 follows from the hash of the statement, and is a prime by Pocklington's criterion."""
    least = 2**125 + int(digest[:31], 16)
    need(0 <= k - least + 4 < 2**WINDOW and k < 2**126 and k % 4 == 1, "the prime does not belong to the statement")
    p = 2 * k * Q + 1
    is_prime = pow(witness, p - 1, p) == 1 and math.gcd(pow(witness, 2 * k, p) - 1, p) == 1
    need(is_prime, "the prime is not proved to be prime")
    return p


def read_certificate(text):
    """The certificate as a dictionary, with the hash of its statement. Refuses wrong hashes and unknown lines."""
    lines = text.split("\n")
    need(lines.pop() == "" and all(lines), "the last line is open, or a line is empty")
    records = [json.loads(line, object_pairs_hook=unique) for line in lines]
    need(all(frozenset(record) in LINES for record in records), "a line has unknown members")
    head, model, derivation, *body, nonzero, left_out, prime, identities = records
    need(head["tripos_certificate"] == 1, "this is no certificate of version 1")
    need(head["model"] == tomllib.loads(model["model_text"])["name"], "the title is another than the model's")
    for record, key in ((model, "model_text"), (derivation, "derivation")):
        need(record["sha256"] == digest(record[key]), f"the hash of the {key} is wrong")
    c = {"model_text": model["model_text"], "derivation_text": derivation["derivation"], "nonzero": nonzero["nonzero"]}
    need(left_out["not_certified"], "the certificate does not say what it leaves out")
    c |= {"prime": prime["prime"], "witness": prime["witness"], "identities": identities["identities"]}
    c["derivation"] = json.loads(derivation["derivation"], object_pairs_hook=unique)
    c["model"] = tomllib.loads(model["model_text"])
    c["model"] = expanded(c["model"], c["model"].pop("counts", {}))
    c["statement"] = digest("".join(line + "\n" for line in lines[:-2]))
    c["integrals"] = [line for line in body if "integral" in line]
    c["reactions"] = [line for line in body if "reactions" in line]
    c["parameters"] = [line for line in body if "without_effect" in line]
    c["combinations"] = {line["combination"]: line for line in body if "combination" in line}
    c["named"] = {f["formulation"]: f["named"] + f["accelerations"] for f in c["derivation"]["formulations"]}
    c["named"] |= {"multipliers of " + name: line["named"] for name, line in c["combinations"].items()}
    c["named"] |= {"reactions of " + line["reactions"]: line["named"] for line in c["reactions"]}
    c["named"] |= {"integral " + line["integral"]: line["named"] for line in c["integrals"]}
    c["named"] |= {"parameter " + line["without_effect"]: line["named"] for line in c["parameters"]}
    need(len(c["named"]) == len(c["derivation"]["formulations"]) + len(body), "a line is unknown or given twice")
    check_names(c)
    return c


def check_names(c):
    """Every variable has a name of its own, and no named term has that of a variable, a parameter, the time or pi."""
    by = {f["formulation"]: f for f in c["derivation"]["formulations"]}
    kane, lagrange = by.get("kane"), by.get("lagrange")
    need(kane and lagrange, "not checked: a certificate needs Kane's and Lagrange's equations")
    coordinates = lagrange["rows"][:len(kane["coordinate_rates"])]
    stated = {name for section in ("parameters", "inputs", "expressions") for name in c["model"].get(section, {})}
    fixed = {*stated, "pi", *kane["rows"], *coordinates}
    fixed |= {q + "'" for q in coordinates}
    unknowns = {x for f in by.values() for x in f["unknowns"]}
    need(all(len(set(f["unknowns"])) == len(f["unknowns"]) for f in by.values()), "an unknown is given twice")
    need(not unknowns & (fixed | {"t"}), "an unknown has the name of a variable")
    for name, terms in c["named"].items():
        # The accelerations of other formulations may go by way of the rates of the speeds.
        solved = {*by[name]["unknowns"], *kane["unknowns"]} if name in by else set()
        written = {term["name"] for term in (by[name]["named"] if name in by else terms)}
        own = {term["name"] for term in terms}
        need(all(term.isidentifier() for term in own - solved), f"{name}: a named term has no name")
        need(not written & unknowns and not (own - solved) & (fixed | unknowns | {"t"}),
             f"{name}: a named term has the name of a variable")
    check_constraints(c["model"], kane, lagrange["rows"][len(coordinates):])
    # Without the clock, the time would be a constant.
    need("t" not in coordinates or kane["coordinate_rates"][coordinates.index("t")] == "1", "the time does not pass")


def check_constraints(model, kane, constraints):
    """Every declared speed is one of the derivation, and every constraint of the derivation is one of the model."""
    joints, bodies, placed = model.get("joints", {}), model.get("bodies", {}), set()
    speeds = {*model.get("speeds", {}), *(s for j in joints.values() for s in j.get("speeds", []))} - set(kane["rows"])
    need(not speeds, f"there is no equation for {', '.join(speeds)}, so that another constraint fixes it")
    loops = [name for name, j in joints.items() if {"centre", "frame"} <= set(bodies[j["body"]])
             or j["body"] in placed or placed.add(j["body"])]
    units = [name for name, f in model.get("frames", {}).items() if "euler_parameters" in f]
    units += [bodies[j["body"]].get("frame", j["body"] + "_frame") for j in joints.values() if "sequence" in j]
    ends = [*"123", *(f"turn{i}{k}" for i in "123" for k in "123")]
    names = {"t", *model.get("constraints", {}), *(f"{name}_norm" for name in units)}
    names |= {f"{name}_{end}" for name in (*model.get("rolling", {}), *loops) for end in ends}
    lacking = set(constraints) - {f"constraint {name}" for name in names}
    need(not lacking, f"the model lacks {', '.join(lacking)}")


def unique(pairs):
    need(len(dict(pairs)) == len(pairs), "a key is given twice")
    return dict(pairs)


def digest(text): return hashlib.sha256(text.encode()).hexdigest()


def check(text, model=None, derivation=None):
    """Checks a certificate. Raises Refused with the reason if it does not hold; else returns a summary."""
    c = read_certificate(text)
    need(model in (None, c["model_text"]), "the model is another than that of the certificate")
    need(derivation in (None, c["derivation_text"]), "the derivation is another than that of the certificate")
    Residue.P = check_prime(int(c["prime"]), c["witness"], c["statement"])
    parameters = c["model"].get("parameters", {})
    positive = {name for name, p in parameters.items() if isinstance(p, dict) and p.get("positive")}
    terms = {term["name"] for named in c["named"].values() for term in named}
    need(not terms & set(parameters), "a named term has the name of a parameter")
    cases, count, others, Scope.PARTS = [], 0, set(), 1
    for at in range(5000):
        try:
            case, names = Case(c, Residues(f"{c['statement']} {at}".encode(), positive)), []
            for name, left, right in case.claims():
                need(left.v == right.v, f"{', '.join(name)}: the sides differ")
                names.append(list(name))
        except NextPoint as root:
            others |= set(root.args)
            continue
        cases, count = [*cases, case][:2], count + 1
        # A root that did not exist where those before it did is none of a square. Others may be, such as √x²: then a
        # false claim holds for all signs but one of 2^n. The signs are random.
        squares = len(set(case.domain.roots.values()) - others)
        if count >= (2 if not squares else BITS / -math.log2(1 - 2**-squares)): break
    else: raise Refused("too few points were found at which all roots exist")
    need(c["identities"] == names, "the list of identities is not that of the claims")
    check_divisors(cases)
    bounds = Bounds()
    sides = [left - right for _, left, right in Case(c, bounds).claims()]
    # Circles double degrees, squares for positive symbols double them again, and norms of roots raise them. A prime of
    # 253 bits is drawn with a chance of 2^(WINDOW - 124) at most, and the height / 253 of them divide all coefficients.
    raised = len(case.domain.roots) * math.log2(2 * bounds.root_size)
    degree, height = (math.log2(max(getattr(x, key) for x in sides) + 1) + 3 + raised for key in "nh")
    signs = count * -math.log2(1 - 2**-squares) if squares else BITS + 999
    bits = min(signs, 252 - degree, 124 - WINDOW + 7 - max(degree, height) - 1)
    need(bits >= BITS, f"a false claim could pass with a chance of 2^-{math.floor(bits)}")
    return f"{len(names)} identities hold; a false one would pass with a chance below 2^-{math.floor(bits)}"


def read(path, inside=""):
    return (Path(path) / inside if Path(path).is_dir() else Path(path)).read_bytes().decode()


def main(argv):
    options = dict(zip(argv[1::2], argv[2::2], strict=True))
    unknown = set(options) - {"--model", "--derivation"}
    sys.setrecursionlimit(20_000)
    try:
        need(not unknown, f"unknown options {unknown}")
        model, derivation = options.get("--model"), options.get("--derivation")
        summary = check(read(argv[0]), model and read(model, "model.toml"), derivation and read(derivation))
        print(f"{argv[0]}: {summary}")
    except (Refused, OSError, *MALFORMED) as why:
        print(f"{argv[0]}: refused: {why}" if isinstance(why, Refused) else f"{argv[0]}: refused: {why!r}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
