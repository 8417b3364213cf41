"""Tampers with certificates of reductions in many ways, and expects that reduction.py refuses every one.

    tamper_reduction.py COUNT FILE…

The forger renews all hashes and the prime, so that only the mathematics and the scene can refuse. Exit status 0 if the
files are accepted and COUNT tampered ones of each are refused.
"""
import json, random, re, sys
from check import digest
from reduction import check_reduction
from tamper import change_formula, proved_prime, refuse_all, spoilt, written

PROOF, SCENE, FOLDED, EQUATIONS, CONSTANTS, OUTPUTS, MOTION = range(1, 8)


def renewed(lines, is_renewed=True):
    """The text of a certificate with the hashes and the prime that belong to its statement."""
    dump = lambda line: json.dumps(line, ensure_ascii=False, separators=(",", ":")) + "\n"
    if is_renewed:
        for at, key in ((PROOF, "proof"), (SCENE, "scene_text")): lines[at]["sha256"] = digest(lines[at][key])
    statement = "".join(map(dump, lines[:-1]))
    if is_renewed: lines[-1] = {"prime": str(proved_prime(digest(statement))), "witness": 3}
    return statement + dump(lines[-1])


def tampered(text, rng, kind):
    """One tampered certificate, and in words what was changed. None if the certificate has no such part."""
    lines = [json.loads(line) for line in text.split("\n") if line]
    def value_of(list, what, key="value"):
        if not list: return None
        entry = rng.choice(list)
        entry[key] = spoilt(entry[key], rng)
        return renewed(lines), what
    reduced, motion = lines[EQUATIONS], lines[MOTION]
    if kind == 0: return value_of(reduced["coordinate_rates"], "rate of a coordinate")
    if kind == 1:
        rows = [k for k, b in enumerate(reduced["forcing"])]
        if not rows: return None
        k = rng.choice(rows)
        reduced["forcing"][k] = f"{reduced['forcing'][k]} + 1"
        return renewed(lines), "right-hand side"
    if kind == 2:
        rows = [(row, k) for k, row in enumerate(reduced["mass_matrix"])]
        if not rows: return None
        row, k = rng.choice(rows)
        row[k] = f"3*({row[k]})"
        return renewed(lines), "coefficient"
    if kind == 3:  # Other definitions may be common factors of equations, which then remain true.
        names = {v["name"] for v in motion["variables"]}
        return value_of([d for d in reduced["named"] if names & set(re.findall(r"\w+", d["value"]))], "definition")
    if kind == 4: return value_of(lines[CONSTANTS]["constants"], "value of a constant")
    if kind == 5: return value_of(lines[CONSTANTS]["positions"], "position at the start", "position")
    if kind == 6: return value_of(lines[OUTPUTS]["outputs"], "output")
    if kind == 7: return value_of(motion["variables"], "rate of a variable")
    if kind == 8:  # A coordinate plus a number may be another motion of the whole model.
        entry = rng.choice(motion["whole"])
        entry["value"] = f"3*({entry['value']}) + 1"
        return renewed(lines), "coordinate or speed of the whole model"
    if kind == 9:
        if not lines[FOLDED]["folded"]: return None
        name = rng.choice(list(lines[FOLDED]["folded"]))
        lines[FOLDED]["folded"][name] = "7/5"
        return renewed(lines), "number of a parameter"
    if kind == 10:
        if not reduced["quadratures"] and not reduced["states"]: return None
        list_ = reduced["states"] or reduced["quadratures"]
        del list_[rng.randrange(len(list_))]
        return renewed(lines), "missing variable"
    if kind == 11:
        del lines[OUTPUTS]["outputs"][0]
        return renewed(lines), "missing output"
    if kind == 12:
        line, key = rng.choice([(lines[PROOF], "proof"), (lines[SCENE], "scene_text")])
        line["sha256"] = digest(line[key] + " ")
        return renewed(lines, False), f"hash of the {key}"
    if kind == 13:
        lines[-1]["prime"] = str(int(lines[-1]["prime"]) + 4)
        return renewed(lines, False), "prime"
    if kind == 14:
        proof = [json.loads(line) for line in lines[PROOF]["proof"].split("\n") if line]
        what = change_formula(proof, rng)
        lines[PROOF]["proof"] = written(proof, True)
        return renewed(lines), what
    if kind == 15:
        motion["whole"][0]["name"], motion["whole"][1]["name"] = motion["whole"][1]["name"], motion["whole"][0]["name"]
        return renewed(lines), "exchange of two coordinates"
    if kind == 16:
        if len(motion["whole"]) < 2 or not reduced["states"] or not reduced["quadratures"]: return None
        reduced["states"], reduced["quadratures"] = reduced["quadratures"], reduced["states"]
        return renewed(lines), "exchange of states and quadratures"
    del motion["whole"][rng.randrange(len(motion["whole"]))]
    return renewed(lines), "missing coordinate or speed"


if __name__ == "__main__":
    sys.exit(refuse_all(sys.argv[1:], check_reduction, tampered, 18))
