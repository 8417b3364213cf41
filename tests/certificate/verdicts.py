"""Checks a certificate of `tripos diff MODEL PUBLICATION --certificate FILE` with the standard library of Python alone.

    verdicts.py FILE [--model MODEL_OR_FOLDER] [--publication FILE]

The program reads the publication by itself, derives each printed quantity again, and decides each verdict at points
modulo a prime that nobody can choose. Exit status 0 if every verdict holds, 1 if one does not, and 3 if some verdicts
were not checked. docs/certificate.md states the format and what is checked.
"""
import functools, json, re, sys
from check import MALFORMED, check, check_prime, digest, read, read_certificate, unique
from claims import Case
from corrections import corrected_values
from derived import Instant, Printed, solved
from fractions import Fraction
from formula import NextPoint, Refused, Residue, Residues, Scope, need, parse
from kinematics import NotChecked, check_model, known
from publication import Publication, symbols_in

MEMBERS = {"tripos_verdicts model publication", "proof sha256", "publication_text sha256", "file text sha256",
           "abbreviations", "not_certified", "prime witness"}
LINES = {frozenset(line.split()) for line in MEMBERS}
OF_ENTRY = {"entry", "verdict", "reading", "factor", "row", "correction", "up_to"}
WITH_A_ZERO = {"V", "L", "energy"}  # Energies that may have another zero than the derived ones.
RIGHT, WRONG = {"equal", "scaled"}, {"different"}
POINTS = 2  # At each, the sides of a right entry are equal. With square roots, as many as check.py takes.


def read_verdicts(text):
    """The certificate as a dictionary, with the hash of its statement."""
    lines = text.split("\n")
    need(lines.pop() == "" and all(lines), "the last line is open, or a line is empty")
    records = [json.loads(line, object_pairs_hook=unique) for line in lines]
    is_known = lambda r: frozenset(r) in LINES or {"entry", "verdict"} <= set(r) <= OF_ENTRY
    need(all(map(is_known, records)), "a line has unknown members")
    head, proof, publication, *body, left_out, prime = records
    need(head["tripos_verdicts"] == 1, "this is no certificate of verdicts of version 1")
    files = [r for r in body if "file" in r]
    hashed = [(proof, "proof"), (publication, "publication_text"), *((f, "text") for f in files)]
    for record, key in hashed: need(record["sha256"] == digest(record[key]), f"the hash of the {key} is wrong")
    claims, readings = {}, {}
    for record in body:
        if "entry" in record: need(claims.setdefault(record["entry"], record) is record, "an entry is given twice")
        elif "abbreviations" in record: readings |= record["abbreviations"]
    for id, reason in left_out["not_certified"].items():
        need(id not in claims and reason, f"{id}: it is certified and left out")
        claims[id] = {"left_out": reason}
    return {"proof": proof["proof"], "text": publication["publication_text"], "claims": claims, "readings": readings,
            "title": head["publication"], "model_title": head["model"], "prime": prime["prime"],
            "witness": prime["witness"], "statement": digest("".join(line + "\n" for line in lines[:-1]))}


class Point(Residues):
    """A random point whose Euler parameters are those of a unit quaternion."""
    def __init__(self, seed, positive, units):
        super().__init__(seed, positive)
        self.fixed = {}
        for first, *others in units:
            rest = Residue(1)
            for name in others: rest = rest - super().symbol(name) * super().symbol(name)
            r = Residue(pow(rest.v, (Residue.P + 1) // 4, Residue.P))
            if (r * r).v != rest.v: raise NextPoint
            self.fixed[first] = r if self.random("sign", first).v % 2 else Residue(0) - r
    def symbol(self, name): return self.fixed.get(name) or super().symbol(name)


def euler_parameters(model):
    """The four names of each set of Euler parameters of a model."""
    for frame in model.get("frames", {}).values():
        if "euler_parameters" in frame: yield frame["euler_parameters"]
    for name, joint in model.get("joints", {}).items():
        if joint.get("sequence") == "euler":
            count = 4 if joint["kind"] == "ball" else 7
            yield joint.get("coordinates", [f"q_{name}_{k + 1}" for k in range(count)])[-4:]


class Judge:
    """Verdicts on the entries of a publication at one point."""
    def __init__(self, c, publication, point):
        self.c, self.publication, self.point = c, publication, point
        self.case = Case(c, point)
        self.symbols = self.case.symbols
        self.matched, self.rows, self.cells, self.corrections = {}, {}, {}, 0

    @functools.cached_property
    def is_related(self):
        """True if equations between coordinates restrict the poses, so that this point may be no pose."""
        model, placed = self.c["model"], set()
        for e in model.get("constraints", {}).values():
            text = e["equation"] if isinstance(e, dict) else e
            name = text.split("=")[0].strip()
            is_solved = name in model.get("coordinates", {}) and name not in self.case.coordinates
            if not is_solved and "'" not in text and not re.search(r"\b(v|omega)\(", text): return True
        bodies = [j["body"] for j in model.get("joints", {}).values()]
        return any({"centre", "frame"} <= set(model["bodies"][b]) or b in placed or placed.add(b) for b in bodies)

    @functools.cached_property
    def free(self): return Instant(self, dict(zip(self.case.speeds, self.case.free)))

    @functools.cached_property
    def true(self):
        """The motion: the rates of the speeds solve Kane's equations, and the other unknowns have their values."""
        case = self.case
        matrix, force = case.system("kane", case.scope("kane", self.symbols))
        found = solved(matrix, force)
        known(len(found) == len(case.speeds), "the accelerations of a singular system")
        rates, others = {s: found[k] for k, s in enumerate(case.speeds)}, {}
        second = {q: case.motion(rates)[q + "'"][1] for q in case.coordinates}
        for name, f in case.by.items():
            given = [rates.get(x[:-1]) if x[:-1] in rates else second.get(x[:-2]) for x in f["unknowns"]]
            open = [k for k, x in enumerate(given) if x is None]
            if name == "kane" or not open: continue
            m, b = case.system(name, case.scope(name, self.symbols))
            for row, k in ((r, k) for r in range(len(m)) for k, x in enumerate(given) if x is not None):
                b[row] = b[row] - m[row][k] * given[k]
            values = solved([[row[k] for k in open] for row in m], b)
            others |= {f["unknowns"][k]: values[at] for at, k in enumerate(open) if at in values}
        return Instant(self, rates, others=others)

    def judge(self, id, kind, table, data):
        """Checks the claim about one entry. Raises Refused if it does not hold."""
        claim = self.publication.claims.get(id, {"verdict": "equal"} if kind == "cell" else None)
        need(claim is not None, f"{id}: no verdict")
        if "left_out" in claim: return
        verdict = claim["verdict"]
        if kind == "stated": return need(verdict == "stated", f"{id}: nothing can contradict it")
        need(kind not in ("number", "other"), f"{id}: this program cannot decide it")
        need(verdict in RIGHT | WRONG, f"{id}: the verdict is `{verdict}`")
        need(not self.publication.is_near(table), f"{id}: it holds near a point")
        known("coordinates" not in self.publication.data, "coordinates of the author")
        known(verdict in RIGHT or not self.is_related, "a wrong entry, in a model with equations between coordinates")
        getattr(self, "judge_" + kind)(id, table, data, claim, verdict in RIGHT)

    def factor(self, claim):
        """Value of the factor that a claim states, or None."""
        if claim.get("factor") is None: return None
        return Scope(self.point, self.symbols, {})(claim["factor"])[0]

    def judge_value(self, id, table, data, claim, is_right):
        """A printed value of a derived quantity."""
        quantity, printed = data["quantity"], data["printed"]()
        is_unknown = quantity in self.true_names()
        is_plain = (is_unknown or claim["verdict"] != "scaled") and "row" not in claim
        need(is_plain, f"{id}: a value is equal or different")
        is_solved = quantity.endswith("'") or is_unknown
        instant = self.true if is_solved else self.free
        left, right = instant.printed(printed), instant.quantity(quantity)
        if quantity in WITH_A_ZERO and (claim.get("up_to") or not is_right):
            need(claim.get("up_to") in (None, "a constant"), f"{id}: it is right up to something else")
            slopes = [x.v for x in (instant.slope(printed), instant.slope_of_energy(quantity))]
            need((slopes[0] == slopes[1]) == is_right, f"{id}: it is {'not ' * is_right}as derived, up to a constant")
            if is_right: return
        need("up_to" not in claim, f"{id}: only an energy has another zero")
        if is_right and claim.get("factor") is None: return need(left.v == right.v, f"{id}: it is not as derived")
        need(not is_right, f"{id}: an equal value has no factor")
        need(left.v != right.v, f"{id}: it is as derived")
        factor = self.factor(claim)
        need(factor is None or left.v == (factor * right).v, f"{id}: the factor is another one")
        if claim.get("correction"):
            values = corrected_values(instant, printed, claim["correction"])
            self.need_repair(id, claim, any(v.v == right.v for v in values))

    def need_repair(self, id, claim, holds):
        need(holds, f"{id}: the correction `{claim['correction']}` does not repair it")
        self.corrections += 1

    def true_names(self): return {x for f in self.case.by.values() for x in f["unknowns"]}

    def formulation(self, table, side):
        """Formulation whose unknowns an equation of motion has."""
        if "formulation" in table: return table["formulation"]
        names = symbols_in(side)
        others = set(self.case.by.get("newton-euler", self.case.kane)["unknowns"]) - set(self.case.kane["unknowns"])
        if names & others: return "newton-euler"
        return "kane" if names & set(self.case.kane["unknowns"]) else "lagrange"

    def coefficients(self, side, formulation):
        """Coefficients of the unknowns in an equation `side = 0`, and the right-hand side."""
        case, zero, one = self.case, Residue(0), Residue(1)
        unknowns = case.by[formulation]["unknowns"]
        def at(values):
            key = formulation, tuple((k, x.v) for k, x in sorted(values.items()))
            if key not in self.instants: self.instants[key] = Instant.of_unknowns(self, formulation, values)
            return self.instants[key].printed(side)
        rest = at({})
        found = [at({x: one}) - rest for x in unknowns]
        values = {x: self.point.random("unknown", x) for x in unknowns}
        linear = sum((c * values[x] for c, x in zip(found, unknowns)), rest)
        known(at(values).v == linear.v, "an equation that is not linear in its unknowns")
        return found, zero - rest

    @functools.cached_property
    def instants(self): return {}

    def derived_row(self, formulation, name):
        f = self.case.by[formulation]
        need(name in f["rows"], f"there is no derived row {name}")
        if (formulation, name) not in self.rows:
            m, b = self.case.system(formulation, self.case.scope(formulation, self.symbols))
            for row, line, right in zip(f["rows"], m, b): self.rows[formulation, row] = line, right
        return self.rows[formulation, name]

    def judge_row(self, id, table, data, claim, is_right):
        """A printed row of a system, or a printed equation of motion."""
        side = data["side"]()
        formulation = self.formulation(table, side)
        multipliers = {x for x in self.case.by["lagrange"]["unknowns"] if not x.endswith("'")}
        is_known = is_right or not symbols_in(side) & multipliers
        known(is_known, "a wrong row with multipliers, which the author may define")
        coefficients, right = self.coefficients(side, formulation)
        above = self.matched.setdefault(("rows", table["id"]), [])
        row, before = [*coefficients, right], len(independent(above))
        above.append(row)
        says_something = any(x.v for x in row) and len(independent(above)) > before
        holds = self.true.printed(side).v == 0
        if is_right: need(holds and says_something, f"{id}: the motion does not satisfy it, or it says nothing")
        else: need(not (holds and says_something), f"{id}: the motion satisfies it")
        factor = self.factor(claim)
        if claim.get("row"):
            known_row, b = self.derived_row(formulation, claim["row"])
            factor = factor or Residue(1)
            unknowns = self.case.by[formulation]["unknowns"]
            pairs = [(x, y) for x, y, name in zip(coefficients, known_row, unknowns) if name not in ("t''",)]
            is_match = all(x.v == (factor * y).v for x, y in [*pairs, (right, b)])
            need(is_match or not is_right, f"{id}: it is not the derived row {claim['row']} times the factor")
            is_plain = factor.v in (1, Residue(-1).v)
            need(not is_right or (claim["verdict"] == "equal") <= is_plain, f"{id}: an equal row has a factor")
            need(not is_right or (claim["verdict"] == "scaled") <= (factor.v != 1), f"{id}: the factor is 1")
            self.matched[id] = formulation, claim["row"], factor
        else: need(factor is None, f"{id}: a factor without a row")
        if claim.get("correction"):
            values = corrected_values(self.true, side, claim["correction"])
            self.need_repair(id, claim, any(v.v == 0 for v in values))

    def judge_cell(self, id, table, data, claim, is_right):
        """A printed entry of a row, against the entry of the derived row times the factor."""
        place = data["row"]
        formulation = {"newton-euler": "kane"}.get(table["formulation"], table["formulation"]) \
            if "state" in table else table["formulation"]
        if claim.get("row"):
            match = formulation, claim["row"], self.factor(claim) or Residue(1)
            same = self.matched.setdefault(place, match)
            is_same = same[:2] == match[:2] and same[2].v == match[2].v
            need(is_same, f"{id}: other entries of the row have another factor")
        known(place in self.matched, f"{id}: the derived row is not stated")
        formulation, name, factor = self.matched[place]
        m, b = self.derived_row(formulation, name)
        unknowns, column = self.case.by[formulation]["unknowns"], data["column"]
        expected = factor * (b if column is None else m[unknowns.index(column)])
        printed = data["printed"]()
        left = self.free.printed(printed)
        self.cells.setdefault(place, []).append((formulation, column, left.v, is_right))
        need((left.v == expected.v) == is_right, f"{id}: it is {'not ' * is_right}the derived entry times the factor")
        need(not is_right or (claim["verdict"] == "scaled") <= (factor.v != 1), f"{id}: the factor is 1")
        need(not is_right or id not in self.publication.claims or (claim["verdict"] == "equal") <= (factor.v == 1),
             f"{id}: the factor is not 1")
        if claim.get("correction"):
            values = corrected_values(self.free, printed, claim["correction"])
            self.need_repair(id, claim, any(v.v == expected.v for v in values))


    def check_rows(self):
        """No entry is wrong in a row that is a derived row times a factor."""
        for place, cells in self.cells.items():
            if all(is_right for *_, is_right in cells): continue
            formulation = cells[0][0]
            unknowns = self.case.by[formulation]["unknowns"]
            for name in self.case.by[formulation]["rows"]:
                m, b = self.derived_row(formulation, name)
                pairs = [(x, (b if column is None else m[unknowns.index(column)]).v) for _, column, x, _ in cells]
                first = next(((x, y) for x, y in pairs if y), (0, 0))
                is_multiple = first[0] and all((x * first[1] - y * first[0]) % Residue.P == 0 for x, y in pairs)
                need(not is_multiple or len(pairs) <= len(unknowns), f"{place}: it is a multiple of the row {name}")


def independent(rows):
    """The rows that do not depend on those before them, reduced."""
    found = []
    for row in rows:
        row = list(row)
        for at, other in found:
            factor = row[at]
            if factor.v: row = [x - factor * y for x, y in zip(row, other)]
        at = next((k for k, x in enumerate(row) if x.v), None)
        if at is not None:
            i = row[at].inverse()
            found.append((at, [x * i for x in row]))
    return found


def check_verdicts(text, model=None, publication=None):
    """Checks a certificate of verdicts. Returns a summary, and what was not checked."""
    v = read_verdicts(text)
    need(publication in (None, v["text"]), "the publication is another than that of the certificate")
    check(v["proof"], model)
    c = read_certificate(v["proof"])
    need(v["model_title"] == c["model"]["name"], "the title is another than the model's")
    Residue.P = check_prime(int(v["prime"]), v["witness"], v["statement"])
    parameters = c["model"].get("parameters", {})
    positive = {name for name, p in parameters.items() if isinstance(p, dict) and p.get("positive")}
    units, Scope.PARTS = list(euler_parameters(c["model"])), 1
    reserved = {name for section in ("parameters", "inputs", "expressions", "coordinates", "speeds")
                for name in c["model"].get(section, {})}
    missing_equations = []
    try: missing_equations = check_model(v["proof"])[1]
    except NotChecked as why: missing_equations = [str(why)]
    book = Publication(v["text"], v["claims"], v["readings"], reserved)
    need(v["title"] == book.data.get("title", ""), "the title is another than the publication's")
    count, others, refusals, done = 0, set(), {}, set()
    for at in range(5000):
        try:
            point = Point(f"{v['statement']} {at}".encode(), positive, units)
            judge = Judge(c, book, point)
            book.speeds = judge.case.speeds
            ids, missing = set(), {}
            for id, kind, table, data in book.entries((len(judge.case.speeds), len(judge.case.coordinates))):
                need(id not in ids, f"{id}: the id is used twice")
                ids.add(id)
                try: judge.judge(id, kind, table, data)
                except NotChecked as why: missing[id] = str(why)
            judge.check_rows()
        except NextPoint as root:
            others |= set(root.args)
            continue
        unknown = set(v["claims"]) - ids
        need(not unknown, f"the publication has no entries {', '.join(sorted(unknown)[:5])}")
        count += 1
        if count == 64 or count >= POINTS and not set(point.roots.values()) - others: break
    else: raise Refused("too few points were found at which all roots exist")
    claimed = {id: x for id, x in v["claims"].items() if "left_out" not in x and id not in missing}
    of = lambda words: sum(x["verdict"] in words for x in claimed.values())
    left_out = len(v["claims"]) - len(claimed) - len(missing)
    words = f"{of(RIGHT)} entries are right, {of(WRONG)} are wrong, {of({'stated'})} are statements; "
    words += f"{judge.corrections} corrections repair their entries; {left_out} entries are not certified"
    if book.read: words += f"; {len(book.read)} formulas are read as the certificate says"
    return words, missing | {f"equations of the model": why for why in missing_equations}


def main(argv):
    options = dict(zip(argv[1::2], argv[2::2], strict=True))
    sys.setrecursionlimit(20_000)
    try:
        need(set(options) <= {"--model", "--publication"}, f"unknown options {set(options)}")
        model, publication = options.get("--model"), options.get("--publication")
        words, missing = check_verdicts(
            read(argv[0]), model and read(model, "model.toml"), publication and read(publication, "publication.toml"))
    except (Refused, NotChecked, OSError, *MALFORMED) as why:
        print(f"{argv[0]}: refused: {why if isinstance(why, (Refused, NotChecked)) else repr(why)}")
        return 1
    print(f"{argv[0]}: {words}")
    for reason in sorted(set(missing.values())):
        print(f"{argv[0]}: not checked: {reason}: {', '.join(id for id, why in missing.items() if why == reason)}")
    return 3 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
