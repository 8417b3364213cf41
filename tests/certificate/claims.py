"""Claims that a certificate must establish about a derivation, with the values of both sides. Used by check.py."""
from fractions import Fraction
from formula import Residue, Residues, Scope, add, need, parse


class Case:
    """Claims about a derivation, and their values in one domain: residues at a point, or bounds."""
    def __init__(self, certificate, domain):
        self.certificate, self.domain, self.divisors = certificate, domain, {}
        self.inputs = list(certificate["model"].get("inputs", {}))
        self.parameters = {*self.inputs, *certificate["model"].get("parameters", {})}
        self.by = {f["formulation"]: f for f in certificate["derivation"]["formulations"]}
        need(len(self.by) == len(certificate["derivation"]["formulations"]), "a formulation is given twice")
        self.kane, lagrange = self.by.get("kane"), self.by.get("lagrange")
        need(self.kane and lagrange, "not checked: a certificate needs Kane's and Lagrange's equations")
        speeds, rates = self.kane["rows"], self.kane["coordinate_rates"]
        coordinates = lagrange["rows"][:len(rates)]
        need(self.kane["unknowns"] == [u + "'" for u in speeds], "Kane's unknowns are not the rates of the speeds")
        need(lagrange["unknowns"][:len(rates)] == [q + "''" for q in coordinates], "a coordinate has no second rate")
        need(len(set(coordinates + speeds)) == len(rates) + len(speeds), "a variable has two meanings")
        one, zero = domain.number(Fraction(1)), domain.number(Fraction(0))
        u = {s: domain.symbol(s) for s in speeds}
        def rates_at(q, along):
            scope = self.scope("kane", {**q, **{s: (u[s], along.get(s)) for s in speeds}})
            return [scope(r) for r in rates]
        still = {q: (domain.symbol(q), None) for q in coordinates}
        velocity = [r[0] for r in rates_at(still, {})]
        moving = {q: (still[q][0], v) for q, v in zip(coordinates, velocity)}
        def motion(rate):
            """Symbols along the motion with the given rates of the speeds, each with its rate."""
            second = [r[1] or zero for r in rates_at(moving, rate)]
            return {**moving, **{s: (u[s], rate[s]) for s in speeds},
                    **{q + "'": (v, a) for q, v, a in zip(coordinates, velocity, second)}}
        self.w = [[r[1] or zero for r in rates_at(still, {s: one})] for s in speeds]
        self.offset = [r[1] or zero for r in rates_at(moving, {})]
        rest = self.scope("kane", {**still, **{s: (zero, None) for s in speeds}})
        self.is_driven = isinstance(domain, Residues) and any(rest(r)[0].v for r in rates)
        self.free = [domain.symbol(s + "'") for s in speeds]
        self.symbols = motion(dict(zip(speeds, self.free)))  # No formula may contain u' or q''.
        self.speeds, self.coordinates, self.motion, self.zero = speeds, coordinates, motion, zero
        self.rates_at, self.velocity = rates_at, velocity

    def scope(self, name, symbols, named=None, more=()):
        terms = [*(self.by[name]["named"] if named is None else named), *more]
        trees = {d["name"]: parse(d["value"]) for d in terms}
        need(len(trees) == len(terms), f"{name}: a name is defined twice")
        return Scope(self.domain, symbols, trees, self.divisors.setdefault(name, []))

    def dot(self, a, b):
        total = self.zero
        for x, y in zip(a, b, strict=True): total = total + x * y
        return total

    def system(self, name, scope):
        f = self.by[name]
        need(len(f["rows"]) == len(f["forcing"]) == len(f["mass_matrix"]), f"{name}: a row is missing")
        need(all(len(row) == len(f["unknowns"]) for row in f["mass_matrix"]), f"{name}: a coefficient is missing")
        return [[scope(e)[0] for e in row] for row in f["mass_matrix"]], [scope(e)[0] for e in f["forcing"]]

    def claims(self):
        """Every claim, as (name, left, right). Each holds if both sides are the same fraction."""
        scopes = {name: self.scope(name, self.symbols) for name in self.by}
        matrix, force = self.system("kane", scopes["kane"])
        residual = [self.dot(row, self.free) - b for row, b in zip(matrix, force)]
        if isinstance(self.domain, Residues): self.check_motion(matrix, scopes)
        for name, f in self.by.items():
            m, g = self.system(name, scopes[name])
            maps, count = [], 0
            if name != "kane":
                maps, count, columns, m, g = self.combination(name, m, g)
                yield from self.equivalence(name, maps, count, columns, (m, g), (matrix, force))
                for what in ("kinetic_energy", "potential_energy", "power"):
                    yield (name, what), scopes[name](f[what])[0], scopes["kane"](self.kane[what])[0]
            if f["accelerations"]: yield from self.accelerations(name, maps, count)
            if name == "kane" and not self.is_driven:
                rate = add(scopes[name](f["kinetic_energy"]), scopes[name](f["potential_energy"]))[1] or self.zero
                along = self.dot([self.symbols[s][0] for s in self.speeds], residual)
                yield ("kane", "power", "rate"), rate, scopes[name](f["power"])[0] + along
        stated = {line["reactions"] for line in self.certificate["reactions"]}
        for name, f in self.by.items():
            is_complete = name in stated or name == "lagrange" or len(f["unknowns"]) == len(self.speeds)
            need(is_complete or not self.kane["accelerations"], f"{name}: the values of the reactions are missing")
        for line in self.certificate["reactions"]: yield from self.reactions(line, line["reactions"])
        for i in self.certificate["integrals"]: yield from self.integral(i, residual, scopes["kane"])
        for line in self.certificate["parameters"]: yield from self.parameter(line)

    def parameter(self, line):
        """No row of Kane's equations changes if a parameter grows and others change by formulas of parameters."""
        name, formulas = "parameter " + line["without_effect"], line["along"]
        need(formulas[line["without_effect"]] == "1" and set(formulas) <= self.parameters, f"{name}: it does not grow")
        moving = {x: (self.symbols[x][0], self.domain.symbol("rate of " + x)) for x in (*self.coordinates, *self.speeds)}
        scope = self.scope(name, moving, line["named"])
        rates = {p: (self.domain.symbol(p), scope(rate)[0]) for p, rate in formulas.items()}
        if isinstance(self.domain, Residues):
            slopes = [scope(rate)[1] for rate in formulas.values()]
            need(not any(x and x.v for x in slopes), f"{name}: a rate contains a variable")
        scope = self.scope("kane", {x: (v, None) for x, (v, _) in self.symbols.items()} | rates)
        for row, m, b in zip(self.speeds, self.kane["mass_matrix"], self.kane["forcing"]):
            rate = self.dot([scope(e)[1] or self.zero for e in m], self.free) - (scope(b)[1] or self.zero)
            yield (name, row), rate, self.zero

    def check_motion(self, matrix, scopes):
        """Kane's mass matrix has full rank, and the rates of the coordinates are Kane's in all formulations."""
        need(rank(matrix) == len(self.speeds), "Kane's mass matrix is singular")
        for name, f in self.by.items():
            stated = [scopes[name](rate)[0].v for rate in f["coordinate_rates"]]
            need(stated == [v.v for v in self.velocity], f"{name}: the rates of the coordinates are not Kane's")

    def combination(self, name, m, g):
        """Multipliers of the rows that give Kane's rows, their count, and the system in the rates of the speeds."""
        f, n = self.by[name], len(self.coordinates)
        if name == "lagrange":
            g = [b - self.dot(row[:n], self.offset) for row, b in zip(m, g)]
            m = [[self.dot(row[:n], w) for w in self.w] + row[n:] for row in m]
            return self.w, n, self.kane["unknowns"] + f["unknowns"][n:], m, g
        need(name in self.certificate["combinations"], f"{name}: the multipliers are missing")
        c = self.certificate["combinations"][name]
        scope = self.scope("multipliers of " + name, self.symbols, c["named"])
        need(f["unknowns"][:len(self.speeds)] == self.kane["unknowns"], f"{name}: the unknowns differ from Kane's")
        return [[scope(e)[0] for e in row] for row in c["multipliers"]], len(m), f["unknowns"], m, g

    def equivalence(self, name, maps, count, columns, system, kane):
        """The multiplied rows are Kane's, without other unknowns; rows of constraints vanish; all ranks are full."""
        (m, g), p = system, len(self.speeds)
        need(len(maps) == p, f"{name}: a row of multipliers is missing")
        for row, line, k, b in zip(self.speeds, maps, *kane):
            expected = k + [self.zero] * (len(columns) - p)
            for at, x in enumerate(columns):
                yield (name, row, x), self.dot(line, [r[at] for r in m[:count]]), expected[at]
            yield (name, row, "right"), self.dot(line, g[:count]), b
        for row, line, b in zip(self.by[name]["rows"][count:], m[count:], g[count:]):
            for x, entry in zip([*columns, "right"], [*line, b]): yield (name, row, x), entry, self.zero
        if isinstance(self.domain, Residues):
            others = [row[p:] for row in m[:count]]
            need(rank(maps) == p, f"{name}: the multipliers are not independent")
            need(rank(others) == len(columns) - p == count - p, f"{name}: the rows do not determine the other unknowns")

    def accelerations(self, name, maps, count):
        """The accelerations in closed form solve the equations, for all values of unknowns that they leave open."""
        f, defined = self.by[name], {d["name"] for d in self.by[name]["accelerations"]}
        scope = self.scope(name, self.symbols, more=f["accelerations"])
        x = [scope(e)[0] for e in f["unknowns"]]
        m, g = self.system(name, scope)
        left = [self.dot(row, x) for row in m]
        if defined >= set(f["unknowns"]): maps, count = [], 0
        for row, line in zip(self.speeds, maps):
            yield (name, "accelerations", row), self.dot(line, left[:count]), self.dot(line, g[:count])
        for row, a, b in zip(f["rows"][count:], left[count:], g[count:]): yield (name, "accelerations", row), a, b

    def reactions(self, line, name):
        """Along the motion, the values of the reactions solve every row of their formulation."""
        solved = self.scope("kane", self.symbols, more=self.kane["accelerations"])
        rates = {x: (solved(x)[0], None) for x in self.kane["unknowns"]}
        scope = self.scope("reactions of " + name, self.symbols | rates, line["named"])
        values = {r["name"]: scope(r["value"])[0] for r in line["values"]}
        others = self.by[name]["unknowns"][len(self.speeds):]
        need(sorted(values) == sorted(others), f"{name}: the values are not those of all reactions")
        x = [a for a, _ in rates.values()] + [values[r] for r in others]
        for row, line, b in zip(self.by[name]["rows"], *self.system(name, self.scope(name, self.symbols))):
            yield (name, "reactions", row), self.dot(line, x), b

    def integral(self, i, residual, kane):
        """The rate of the integral is a combination of Kane's rows, and it is no constant. Its kind tells its value."""
        name = "integral " + i["integral"]
        scope = self.scope(name, self.symbols, i["named"])
        value, rate = scope(i["value"])
        yield (name, "rate"), rate or self.zero, self.dot([scope(e)[0] for e in i["multipliers"]], residual)
        if i["is_energy"]:
            energies = [kane(self.kane[key])[0] for key in ("kinetic_energy", "potential_energy")]
            yield (name, "value"), value, energies[0] + energies[1]
        if i["is_momentum_of"]:
            q, one = i["is_momentum_of"] + "'", self.domain.number(Fraction(1))
            still = {k: (v[0], one if k == q else None) for k, v in self.symbols.items()}
            momentum = self.scope("lagrange", still)(self.by["lagrange"]["kinetic_energy"])[1]
            yield (name, "value"), value, momentum or self.zero
        if isinstance(self.domain, Residues):
            def slope(of, varied, value, named):
                """Slope of a formula if the variables or inputs have the rates `varied`."""
                symbols = {k: (x[0], varied.get(k)) for k, x in self.symbols.items()}
                symbols |= {k: (self.domain.symbol(k), x) for k, x in varied.items() if k not in symbols}
                found = self.scope(of, symbols, named)(value)[1]
                return found is not None and found.v != 0
            along = {k: self.domain.random("along", k) for k in (*self.coordinates, *self.speeds, *self.inputs)}
            inputs = {k for k in self.inputs if slope(name, {k: along[k]}, i["value"], i["named"])}
            need(inputs == set(i["while_constant"]), f"{name}: it holds only while {', '.join(inputs)} is constant")
            varied = {k: (self.symbols[k][0], along[k]) for k in (*self.coordinates, *self.speeds)}
            rates = self.rates_at({q: varied[q] for q in self.coordinates}, along)
            varied = {k: x for k, (_, x) in varied.items()} | {q + "'": x[1] for q, x in zip(self.coordinates, rates)}
            need(slope(name, varied, i["value"], i["named"]), f"{name}: the integral is a constant")
            speeds = {s: along[s] for s in self.speeds}
            need(not i["is_momentum_of"] or not slope("lagrange", speeds, self.by["lagrange"]["kinetic_energy"], None),
                 f"{name}: Lagrange's kinetic energy contains speeds")


def rank(matrix):
    """Rank of a matrix of residues. It is at most the rank of the matrix of fractions."""
    rows, found = [[x.v for x in row] for row in matrix], 0
    for at in range(len(rows[0])):
        pivot = next((k for k in range(found, len(rows)) if rows[k][at]), None)
        if pivot is None: continue
        rows[found], rows[pivot] = rows[pivot], rows[found]
        inverse = pow(rows[found][at], -1, Residue.P)
        for k in range(found + 1, len(rows)):
            factor = rows[k][at] * inverse
            if factor: rows[k] = [(x - factor * y) % Residue.P for x, y in zip(rows[k], rows[found])]
        found += 1
    return found
