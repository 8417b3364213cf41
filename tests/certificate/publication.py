"""Entries of a publication file, read without Tripos. Used by verdicts.py.

An entry is (id, kind, data). Its formulas are trees of formula.py. This program reads the language of model files; for
other notations it takes the formula that the certificate states, and counts it.
"""
import re, tomllib
from formula import need, parse, tree
from kinematics import known

KEYS = {"title", "source", "notation", "file", "macros", "about", "order", "small", "abbreviations", "coordinates",
        "names", "symbols", "equation", "definition", "matrix", "system", "listing", "initial"}
ROOT = re.compile(r"((?<![\w.])\w+|(?<!\w)\([^()]*\))\^(?:\((\d+)/2\)|(\d*)\.5)")
SQUARES = {"rotation": (3, 3), "I": (3, 3)}


def with_roots(m):
    """A power with half an exponent, written with a square root."""
    halves = int(m[2] or 2 * int(m[3] or 0) + 1)
    return f"({m[1]}^{halves // 2}*sqrt({m[1]}))"


def negative(e): return tree("*", (parse("-1"), e))
def difference(a, b): return tree("+", (a, negative(b)))


def symbols_in(e, into=None):
    """Names in a tree."""
    into = set() if into is None else into
    if e[0] == "s": into.add(e[1])
    elif e[0] != "n":
        for part in e[1] if e[0] in "+*" else e[1:]:
            if isinstance(part, tuple): symbols_in(part, into)
    return into


def renamed(e, meanings):
    """A tree in which names have the meanings that `[symbols]` gives them."""
    if e[0] == "s": return meanings.get(e[1], e)
    if e[0] == "n": return e
    if e[0] in "+*": return tree(e[0], tuple(renamed(part, meanings) for part in e[1]))
    return tree(e[0], *(renamed(part, meanings) if isinstance(part, tuple) else part for part in e[1:]))


class Publication:
    """The tables of a publication, with the readings of the certificate for formulas in other notations."""
    def __init__(self, text, claims, readings, reserved):
        self.data, self.claims, self.speeds, self.read = tomllib.loads(text, parse_float=str), claims, [], set()
        need(set(self.data) <= KEYS, f"unknown tables {set(self.data) - KEYS}")
        self.names = self.data.get("names", {})
        symbols = self.data.get("symbols", {}).items()
        self.symbols = {k: parse(x) for k, x in symbols if re.fullmatch(r"[^\W\d]\w*'*", k)}
        self.abbreviations, stated = {}, self.data.get("abbreviations", {})
        for name, value in stated.items():
            own = None if self.is_own(value, self.data) else readings.get(name)
            self.abbreviations[name] = self.formula("abbreviation " + name, value, self.data, own)
        for name in set(readings) - set(stated):  # Variables of a program.
            need(name not in reserved and name not in self.names, f"the abbreviation {name} has two meanings")
            self.abbreviations[name] = self.formula("abbreviation " + name, None, self.data, readings[name])

    def notation(self, table):
        named = table.get("notation", self.data.get("notation"))
        return named or ("of a file" if "file" in table or "file" in self.data else "tripos")

    def is_near(self, table):
        """True if the formulas of an entry hold near a point, or for small parameters."""
        about = table.get("about", self.data.get("about"))
        return bool(about or about is None and table.get("small", self.data.get("small")))

    def is_own(self, text, table):
        """True if this program reads a formula by itself."""
        is_formula = isinstance(text, int) or isinstance(text, str) and text.isascii()
        return is_formula and (isinstance(text, int) or self.notation(table) == "tripos")

    def formula(self, id, text, table, reading):
        """Tree of a printed formula. Only formulas in other notations may have a reading in the certificate."""
        if self.is_own(text, table):
            is_read = reading is not None and not isinstance(text, int)
            need(not is_read, f"{id}: the certificate reads a formula that needs no reading")
            while (new := ROOT.sub(with_roots, str(text))) != text: text = new
            return renamed(parse(text), self.symbols)
        self.read.add(id)
        need(reading is not None, f"{id}: the certificate does not say how the formula is read")
        return parse(reading)

    def reading(self, id): return self.claims.get(id, {}).get("reading")

    def ids_below(self, id, pattern):
        """Ids of the certificate that begin with an id and continue by a pattern."""
        return [x for x in self.claims if x.startswith(id) and re.fullmatch(pattern, x[len(id):])]

    def entries(self, dimensions):
        """All entries, as (id, kind, data). `dimensions` are the numbers of speeds and coordinates."""
        for kind in ("definition", "initial", "equation", "matrix", "system", "listing"):
            for table in self.data.get(kind, []):
                for id, what, data in getattr(self, kind + "s")(table, dimensions): yield id, what, table, data

    def definitions(self, table, _): yield table["id"], "stated", {}
    def initials(self, table, _): yield table["id"], "number", {}

    def equations(self, table, _):
        id, quantity, text = table["id"], str(table.get("quantity", "0")), table.get("printed")
        own = text is not None and self.notation(table) == "tripos" and text.isascii()
        if quantity.strip() == "0":
            return (yield id, "row", {"side": lambda: self.equation(id, text, table)})
        sides = text.split("=") if own else None
        if own and (len(sides) == 1 or not re.search(r"[+/]", sides[0])): sides = sides[1:] or sides
        elif own: sides = [text]
        ids = [id] if id in self.claims else self.ids_below(id, r"-[1-9]\d*")
        if own: ids = [id] if len(sides) == 1 else [f"{id}-{k + 1}" for k in range(len(sides))]
        need(ids and (own or ids in ([id], [f"{id}-{k + 1}" for k in range(len(ids))])), f"{id}: no verdict")
        for k, x in enumerate(ids):
            printed = sides[k] if own else None
            yield x, "value", {"quantity": quantity,
                               "printed": lambda x=x, p=printed: self.formula(x, p, table, self.reading(x))}

    def equation(self, id, text, table):
        """Left side minus right side of a printed equation of motion."""
        if text is None or self.notation(table) != "tripos" or not text.isascii():
            return self.formula(id, None, table, self.reading(id))
        sides = [self.formula(id, side, table, self.reading(id)) for side in text.split("=")]
        known(len(sides) < 3, "an equation of motion with several signs of equality")
        return difference(*sides) if len(sides) == 2 else sides[0]

    def matrixs(self, table, dimensions):
        id, quantity = table["id"], table["quantity"].strip()
        word = re.match(r"\w+", quantity)[0]
        speeds, coordinates = dimensions
        if word == "C":
            for x in self.ids_below(id, "-.*"): yield x, "other", {}
            return
        of_speeds, of_coordinates = {"F", "Fstar", "f"}, {"A", "h", "g", "dL_dqdot", "ddt_dL_dqdot", "dL_dq"}
        rows, columns = SQUARES.get(word, (3, 1))
        if word in of_speeds | of_coordinates: rows = speeds if word in of_speeds else coordinates
        if word in ("M", "E", "Edot"): rows = columns = speeds if word == "M" else coordinates
        comma = "," if max(rows, columns) > 9 else ""
        for i in range(1, rows + 1):
            for j in range(1, columns + 1):
                x = f"{id}-{i}{comma}{j}" if columns > 1 or f"{id}-{i}" not in self.claims else f"{id}-{i}"
                index = f"{i},{j}" if columns > 1 else f"{i}"
                yield x, "value", {"quantity": f"{quantity} [{index}]",
                                   "printed": lambda x=x: self.formula(x, None, table, self.reading(x))}

    def systems(self, table, _):
        id, equations = table["id"], table.get("equations")
        if equations is not None or "label" in table or "labels" in table:
            ids = [f"{id}-row{k + 1}" for k in range(len(equations or self.ids_below(id, r"-row\d+")))]
            need(ids, f"{id}: no verdicts on its rows")
            for k, x in enumerate(ids):
                text = equations[k] if equations else None
                yield x, "row", {"side": lambda x=x, t=text: self.equation(x, t, table)}
            return
        own = self.notation(table) == "tripos"
        cell = lambda x, text: lambda: self.formula(x, text, table, self.reading(x))
        for i, (row, right) in enumerate(zip(table["matrix"], table["right"], strict=True)):
            x = f"{id}-row{i + 1}"
            def side(x=x, row=row, right=right):
                if not own: return self.formula(x, None, table, self.reading(x))
                parts = [self.formula(x, e, table, self.reading(x)) for e in (*row, right)]
                known_parts = zip(parts, table["unknowns"], strict=False)
                return tree("+", (*(tree("*", (e, tree("s", u))) for e, u in known_parts), negative(parts[-1])))
            yield x, "row", {"side": side}
            for template, columns in (("matrix_ids", range(len(row))), ("right_ids", [None])):
                for j in columns if template in table else []:
                    y = table[template].replace("{i}", str(i + 1)).replace("{j}", str((j or 0) + 1))
                    text, column = (right, None) if j is None else (row[j], table["unknowns"][j])
                    yield y, "cell", {"printed": cell(y, text), "row": x, "column": column}

    def listings(self, table, _):
        id, state = table["id"], table["state"]
        texts = [t if isinstance(t, (int, str)) else None for t in table["derivative"]]
        in_rates = table["formulation"] == "lagrange"
        moving = [k for k, name in enumerate(state) if (name.endswith("'") if in_rates else name in self.speeds)]
        matrix = table.get("matrix")
        below = self.ids_below(id, r"-E\d+(,\d+)?")
        comma = "," if len(state) > 18 else ""
        for k, (name, text) in enumerate(zip(state, texts, strict=True)):
            x = f"{id}-dz{k + 1}"
            printed = lambda x=x, t=text: self.formula(x, t, table, self.reading(x))
            if k in moving and (matrix or below):
                yield x, "cell", {"printed": printed, "row": f"{id} row {moving.index(k)}", "column": None}
            else: yield x, "value", {"quantity": name + "'", "printed": printed}
        for i in range(len(moving) if matrix or below else 0):
            for j in range(len(moving)):
                x = f"{id}-E{i + 1}{comma}{j + 1}"
                text = matrix[i][j] if matrix else None
                need(x in self.claims or not matrix or str(text) == "0", f"{x}: no verdict")
                data = {"printed": lambda x=x, t=text: self.formula(x, t, table, self.reading(x)),
                        "row": f"{id} row {i}", "column": state[moving[j]] + "'"}
                if matrix or x in below: yield x, "cell", data
