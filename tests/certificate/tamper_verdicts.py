"""Tampers with certificates of verdicts in many ways, and expects that verdicts.py refuses every one.

    tamper_verdicts.py COUNT FILE…

The forger renews all hashes and the prime, so that only the mathematics and the publication can refuse. Exit status 0
if the files are accepted and COUNT tampered ones of each are refused.
"""
import json, random, re, sys
from check import digest
from tamper import change_formula, proved_prime, refuse_all, spoilt, written
from verdicts import RIGHT, check_verdicts


def renewed(lines, is_renewed=True):
    """The text of a certificate with the hashes and the prime that belong to its statement."""
    dump = lambda line: json.dumps(line, ensure_ascii=False, separators=(",", ":")) + "\n"
    if is_renewed:
        for line in lines:
            for key in set(line) & {"proof", "publication_text", "text"}: line["sha256"] = digest(line[key])
    statement = "".join(map(dump, lines[:-1]))
    if is_renewed: lines[-1] = {"prime": str(proved_prime(digest(statement))), "witness": 3}
    return statement + dump(lines[-1])


def with_other_formula(lines, rng):
    """Changes the printed formula of an entry that is right, or whose correction would then not repair it."""
    claims = [x for x in lines if x.get("verdict") in RIGHT or "correction" in x]
    for claim in rng.sample(claims, len(claims)):
        if "reading" in claim:
            claim["reading"] += " + 1"  # A multiple of a wrong row is as wrong.
            return "reading of a formula"
        if claim["verdict"] not in RIGHT: continue
        text = lines[2]["publication_text"]
        m = re.search(rf'id = "{re.escape(claim["entry"])}"\n(?:\w+ = .*\n)*?printed = "([^"=]+)"', text)
        if not m: continue
        lines[2]["publication_text"] = text[:m.start(1)] + spoilt(m[1], rng) + " + 1" + text[m.end(1):]
        return "printed formula"
    return None


def with_other_number(lines, rng):
    """Changes a coefficient of a system or a listing in the text of the publication."""
    text = lines[2]["publication_text"]
    ids = {x["entry"] for x in lines if x.get("verdict") in RIGHT}
    rows = [m for m in re.finditer(r'"([^"\n]*[a-z][^"\n]*)"(?=[,\]])', text) if "{" not in m[1]]
    tables = [(m.start(), m[1]) for m in re.finditer(r'\[\[(\w+)\]\]', text)]
    kind = lambda at: next((k for start, k in reversed(tables) if start < at), None)
    before = lambda at: text.rfind("\n\n", 0, at)
    rows = [m for m in rows if kind(m.start()) in ("system", "listing")
            and re.search(r"(matrix|right|derivative|equations) = \[[^=]*$", text[before(m.start()):m.start()])]
    if not rows or not ids or '"reading"' in json.dumps(lines): return None
    m = rng.choice(rows)
    lines[2]["publication_text"] = text[:m.start(1)] + f"({m[1]})*q1 + 7*({m[1]})" + text[m.end(1):]
    return "entry of a system"


def tampered(text, rng, kind):
    """One tampered certificate, and in words what was changed. None if the certificate has no such part."""
    lines = [json.loads(line) for line in text.split("\n") if line]
    claims = [x for x in lines if "entry" in x]
    right = [x for x in claims if x["verdict"] in RIGHT]
    wrong = [x for x in claims if x["verdict"] == "different"]
    def edit(list, change, what):
        if not list: return None
        change(rng.choice(list))
        return renewed(lines), what
    if kind == 0: return edit(right, lambda x: x.update(verdict="different"), "verdict of a right entry")
    if kind == 1: return edit(wrong, lambda x: x.update(verdict="equal"), "verdict of a wrong entry")
    if kind == 2:
        def plain(x):
            entry = {"entry": x["entry"], "verdict": "equal"} | {k: x[k] for k in ("reading",) if k in x}
            x.clear(), x.update(entry)
        return edit(wrong, plain, "verdict and members of a wrong entry")
    if kind == 3:
        return edit([x for x in claims if x["verdict"] == "scaled" and "row" in x],
                    lambda x: x.update(verdict="equal"), "verdict of a scaled row")
    if kind == 4: return edit([x for x in claims if "factor" in x and (x["verdict"] in RIGHT or "row" not in x)],
                              lambda x: x.update(factor=spoilt(x["factor"], rng)), "factor")
    if kind == 5:
        def other(x):
            parts = x["correction"].rsplit(" should be ", 1)
            if len(parts) == 2: x["correction"] = f"{parts[0]} should be 7*({parts[1].removesuffix(' throughout')})"
            else: x["correction"] = x["correction"].replace("the term ", "the term 7*")
        return edit([x for x in claims if "correction" in x], other, "correction")
    if kind in (6, 7, 8):
        what = with_other_formula(lines, rng)
        return what and (renewed(lines), what)
    if kind == 9:
        what = with_other_number(lines, rng)
        return what and (renewed(lines), what)
    if kind == 10:
        lines.remove(rng.choice(claims))
        return renewed(lines), "missing verdict"
    if kind == 11:
        lines.insert(4, {"entry": "no-such-entry", "verdict": "equal"})
        return renewed(lines), "verdict without an entry"
    if kind == 12:
        line, key = rng.choice([(lines[1], "proof"), (lines[2], "publication_text")])
        line["sha256"] = digest(line[key] + " ")
        return renewed(lines, False), f"hash of the {key}"
    if kind == 13:
        lines[-1]["prime"] = str(int(lines[-1]["prime"]) + 4)
        return renewed(lines, False), "prime"
    if kind == 14:
        proof = [json.loads(line) for line in lines[1]["proof"].split("\n") if line]
        what = change_formula(proof, rng)
        lines[1]["proof"] = written(proof, True)
        return renewed(lines), what
    if kind == 15:
        if "[[equation]]" not in lines[2]["publication_text"]: return None
        lines[2]["publication_text"] = lines[2]["publication_text"].replace("[[equation]]", "[[definition]]", 1)
        return renewed(lines), "kind of an entry"
    if kind == 16:
        left = lines[-2]["not_certified"]
        left["no-such-entry"] = "it is too long"
        return renewed(lines), "entry that is left out"
    if kind == 17:
        numbers = [id for id, why in lines[-2]["not_certified"].items() if why == "a printed number"]
        if not numbers: return None
        id = rng.choice(numbers)
        del lines[-2]["not_certified"][id]
        lines.insert(4, {"entry": id, "verdict": "stated"})
        return renewed(lines), "number that counts as stated"
    if kind == 18:
        return edit([x for x in claims if "row" in x], lambda x: x.update(row=x["row"] + "x"), "name of a derived row")
    pattern = r'^\[names\]\n(?:.*\n)*?(\w+) = "omega\((\w+)\)([^"\n]*)\[1\]"'
    names = re.search(pattern, lines[2]["publication_text"], re.M)
    if not names: return None
    text, at = lines[2]["publication_text"], names.end() - 3
    lines[2]["publication_text"] = text[:at] + "3" + text[at + 1:]
    return renewed(lines), "quantity of a name"


if __name__ == "__main__":
    sys.exit(refuse_all(sys.argv[1:], check_verdicts, tampered, 20))
