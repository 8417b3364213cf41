"""Values of the quantities that publications name, at one instant of a motion. Used by verdicts.py.

Positions, velocities, inertias and loads come from the model file by kinematics.py. Equations and energies come from
the formulas of the derivation. The name of each quantity is that of docs/publication.md.
"""
import functools, re
from formula import Residue, Scope, parse, tree
from kinematics import (KEYS, OTHERS, Jet, Jets, ModelScope, NotChecked, World, inner, known, named_terms, product,
                        times, transposed)
from publication import symbols_in

COMPONENT = r"(\w+)\((\w+)\) @ (\w+) \[(\d)\]"


def solved(matrix, right):
    """Values of the unknowns that a linear system determines, by their columns."""
    rows, pivots = [[*row, b] for row, b in zip(matrix, right, strict=True)], []
    for at in range(len(matrix[0])):
        k = next((k for k in range(len(pivots), len(rows)) if rows[k][at].v), None)
        if k is None: continue
        rows[len(pivots)], rows[k] = rows[k], rows[len(pivots)]
        i = rows[len(pivots)][at].inverse()
        line = rows[len(pivots)] = [x * i for x in rows[len(pivots)]]
        for k, row in enumerate(rows):
            if k != len(pivots) and row[at].v: rows[k] = [x - row[at] * y for x, y in zip(row, line)]
        pivots.append(at)
    known(not any(row[-1].v for row in rows[len(pivots):]), "a system without a solution")
    return {at: row[-1] for at, row in zip(pivots, rows) if sum(1 for x in row[:-1] if x.v) == 1}


class Printed(ModelScope):
    """Values of printed formulas. Names of the publication stand for derived quantities, and ddt is d/dt."""
    def __init__(self, instant, named):
        super().__init__(instant.jets, dict(instant.variables), named)
        self.instant = instant
    def evaluated(self, e, kind, a):
        quantities = self.instant.judge.publication.names
        if kind == "s" and a in quantities: return Jet(self.instant.quantity(quantities[a]), Residue(0)), None
        if kind == "s":
            known(a in self.named or a in self.symbols or a in self.instant.parameters, f"the variable {a}")
        return super().evaluated(e, kind, a)
    def inside(self, e):
        """Names in a formula, and in the abbreviations that it uses."""
        found = symbols_in(e)
        while more := {x for n in found if n in self.named for x in symbols_in(self.named[n])} - found: found |= more
        return found
    def function(self, f, *e):
        if f != "ddt": return super().function(f, *e)
        inside = self.inside(e[0])
        known(not inside & set(self.instant.judge.publication.names) and "'ddt'" not in repr(e), "a rate of a name")
        return self.value(e[0])[1] or self.number(0)[0], None


class Instant:
    """A state with given rates of the speeds, or with given second rates of the coordinates."""
    def __init__(self, judge, rates, seconds=None, others=None):
        self.judge, self.case = judge, judge.case
        self.symbols = dict(self.case.motion(rates))
        self.parameters = self.case.parameters | {"pi"}
        for q, a in (seconds or {}).items(): self.symbols[q + "'"] = self.symbols[q + "'"][0], a
        zero, given = Residue(0), others or {}
        self.slopes = {name: rate for name, (_, rate) in self.symbols.items() if rate is not None}
        self.jets = Jets(judge.point, self.slopes)
        slope = lambda name: self.slopes.get(name, zero)
        self.variables = {}
        for name, (value, _) in self.symbols.items():
            further = slope(name + "'") if name in self.case.coordinates else zero
            self.variables[name] = Jet(value, slope(name)), Jet(slope(name), further)
        for q in self.case.coordinates: self.variables[q + "''"] = Jet(slope(q + "'"), zero), None
        for s in self.case.speeds: self.variables[s + "'"] = Jet(slope(s), zero), None
        self.variables |= {name: (Jet(x, zero), None) for name, x in given.items()}
        self.scope = Printed(self, judge.publication.abbreviations)

    @classmethod
    def of_unknowns(cls, judge, formulation, values):
        """The instant in which the unknowns of a formulation have these values, and the other unknowns are 0."""
        zero, case = Residue(0), judge.case
        unknowns = case.by[formulation]["unknowns"]
        value = {x: values.get(x, zero) for x in unknowns}
        rates = {s: value.get(s + "'", zero) for s in case.speeds}
        seconds = {q: value[q + "''"] for q in case.coordinates if q + "''" in value}
        others = {x: v for x, v in value.items() if not x.endswith("'")}
        return cls(judge, rates, seconds, others)

    def printed(self, e): return self.scope(e)[0].a
    def slope(self, e):
        """Rate of a printed formula without names of quantities with rates of their own."""
        names = self.judge.publication.names
        known(not self.scope.inside(e) & set(names), "the rate of a name")
        rate = self.scope(e)[1]
        return rate.a if rate else Residue(0)
    def slope_of_energy(self, text):
        """Rate of V, L or T + V along the motion."""
        scope, zero = self.case.scope("kane", self.symbols), Residue(0)
        t, v = (scope(self.case.kane[key])[1] or zero for key in ("kinetic_energy", "potential_energy"))
        return {"V": v, "L": t - v, "energy": t + v}[text]

    @functools.cached_property
    def world(self):
        """Places of all parts, with their rates along the motion."""
        return self.world_along(self.slopes)

    def world_along(self, slopes):
        model, case = self.judge.c["model"], self.case
        for section, entries in model.items():
            known(section in KEYS or section in OTHERS, f"the section {section}")
            for name, entry in entries.items() if section in KEYS else []:
                unknown = set(entry) - KEYS[section] - {"about", "figure", "shape"}
                known(not unknown, f"{section}.{name}: {', '.join(unknown)}")
        named = {name: parse(str(value)) for name, value in named_terms(model, case.coordinates)}
        jet = lambda name: Jet(self.symbols[name][0], slopes.get(name, Residue(0)))
        values = {name: (jet(name), None) for name in self.symbols}
        values |= {q: (jet(q), jet(q + "'")) for q in case.coordinates}
        missing = [q for q in model.get("coordinates", {}) if q not in case.coordinates and q not in named]
        known(not missing, f"the coordinate {', '.join(missing)}, which a loop eliminates")
        return World(model, ModelScope(Jets(self.judge.point, slopes), values, named))

    @functools.cached_property
    def along(self):
        """Places of all parts, with their rates along each speed."""
        partial = [{q + "'": x for q, x in zip(self.case.coordinates, w)} for w in self.case.w]
        return {s: self.world_along({s: Residue(1), **rates}) for s, rates in zip(self.case.speeds, partial)}

    def quantity(self, text):
        key = re.sub(r"\s+", " ", text.strip())
        if key not in self.memo: self.memo[key] = self.derive(key)
        return self.memo[key]

    @functools.cached_property
    def memo(self): return {}

    def derive(self, text):
        """Value of a quantity by its name."""
        if text in self.variables: return self.variables[text][0].a
        if m := re.fullmatch(r"rotation\((\w+), ?(\w+)\) ?\[(\d), ?(\d)\]", text):
            r = product(transposed(self.world.frame(m[2])), self.world.frame(m[1]))
            return r[int(m[3]) - 1][int(m[4]) - 1][0].a
        if m := re.fullmatch(COMPONENT, text): return self.component(self.world, *m.groups())
        if m := re.fullmatch(r"v\((\w+), ?(\w+)\) @ (\w+) \[(\d)\]", text):
            velocity = self.world.end({"on": m[1], "at": m[2]}, "on", "at")[1]
            return self.along_axis(self.world, [x.a for x in velocity], m[3], m[4])
        if m := re.fullmatch(rf"d {COMPONENT} ?/ ?d (\w+)", text):
            known(m[1] in ("v", "omega") and m[5] in self.case.speeds, f"the quantity {text}")
            w = self.along[m[5]]
            axes = lambda: w.axes(m[2]) if m[2] in w.bodies else w.frame(m[2])
            x = w.spin(axes()) if m[1] == "omega" else w.velocity(w.point(m[2]))
            return self.along_axis(w, [x.b for x in x], m[3], m[4])
        if m := re.fullmatch(r"I\((\w+)\) @ (\w+) ?\[(\d), ?(\d)\]", text): return self.inertia(*m.groups())
        if m := re.fullmatch(r"(\w+) ?\[(\w+)\]", text): return self.row(*m.groups())
        if m := re.fullmatch(r"([ME]) ?\[(\w+), ?(\w+)\]", text):
            name = {"M": "kane", "E": "lagrange"}[m[1]]
            list = self.case.speeds if name == "kane" else self.case.coordinates
            at = [int(k) - 1 if k.isdigit() else list.index(k) for k in m.groups()[1:]]
            matrix, _ = self.case.system(name, self.case.scope(name, self.case.symbols))
            return matrix[at[0]][at[1]]
        return self.energy(text)

    def along_axis(self, world, vector, frame, axis):
        """Component of a vector along an axis of a frame."""
        columns = transposed(world.frame(frame))[int(axis) - 1]
        return inner([x[0].a for x in columns], vector)

    def component(self, world, kind, of, frame, axis):
        """Component of a vector of a point, frame or body."""
        zero, model = Residue(0), self.judge.c["model"]
        place = lambda: world.point(of)
        turning = lambda: world.spin(world.axes(of) if of in world.bodies else world.frame(of))
        def body():
            for name, entry in model.get("particles", {}).items():
                if name == of: return world.formula(entry["mass"])[0].a, world.point(entry["point"])
            known(of in world.bodies, f"the body {of}")
            return world.formula(world.bodies[of].get("mass", 0))[0].a, world.centre(of)
        def weight():
            g = model.get("gravity")
            if not g: return [zero] * 3
            return [x[0].a * body()[0] for x in times(world.frame(g["frame"]), world.vector(g["acceleration"]))]
        minus = lambda v: [zero - x for x in v]
        force = lambda: [body()[0] * x.b for x in world.velocity(body()[1])]
        momentum = lambda: [x[0] for x in world.angular_momentum(of)[1]]
        vectors = {"p": lambda: [x[0].a for x in place()], "v": lambda: [x.a for x in world.velocity(place())],
                   "a": lambda: [x.b for x in world.velocity(place())], "omega": lambda: [x.a for x in turning()],
                   "alpha": lambda: [x.b for x in turning()], "H": lambda: [x.a for x in momentum()],
                   "Hdot": lambda: [x.b for x in momentum()], "pdot": force, "Rstar": lambda: minus(force()),
                   "Tstar": lambda: minus([x.b for x in momentum()]), "weight": weight}
        known(kind in vectors, f"the quantity {kind}")
        return self.along_axis(world, vectors[kind](), frame, axis)

    def inertia(self, body, frame, i, k):
        """Entry of the central inertia of a body along the axes of a frame."""
        world = self.world
        inertia = world.bodies[body].get("inertia")
        known(isinstance(inertia, dict) and set(inertia) <= {"diagonal", "products", "frame"}, f"the inertia of {body}")
        (x, y, z), (xy, yz, zx) = world.vector(inertia["diagonal"]), world.vector(inertia.get("products", [0, 0, 0]))
        m = world.frame(inertia["frame"]) if "frame" in inertia else world.axes(body)
        r = product(transposed(world.frame(frame)), m)
        found = product(r, product([[x, xy, zx], [xy, y, yz], [zx, yz, z]], transposed(r)))
        return found[int(i) - 1][int(k) - 1][0].a

    def row(self, kind, index):
        """Entry of a column of the equations of motion."""
        of_speeds = kind in ("F", "Fstar", "f")
        list = self.case.speeds if of_speeds else self.case.coordinates
        at = int(index) - 1 if index.isdigit() else list.index(index)
        if kind in ("f", "A"):
            name = "kane" if kind == "f" else "lagrange"
            return self.case.system(name, self.case.scope(name, self.case.symbols))[1][at]
        if of_speeds: return self.generalized_force(kind, list[at])
        known(kind in ("dL_dqdot", "ddt_dL_dqdot", "partial_t_dL_dqdot", "dL_dq"), f"the quantity {kind}")
        return self.slope_of_lagrangian(kind, list[at])

    def generalized_force(self, kind, speed):
        """Kane's active or inertia force along a speed, by virtual power."""
        total, zero, other = Residue(0), Residue(0), self.along[speed]
        if kind == "F":
            for (f, _), (_, v) in zip(self.world.loads(), other.loads()):
                total = total + inner([x.a for x in f], [x.b for x in v])
            return total
        for (mass, r, w, h), (_, s, o, _) in zip(self.world.masses(), other.masses()):
            a, partial = [x.b for x in self.world.velocity(r)], [x.b for x in other.velocity(s)]
            total = total + mass[0].a * inner(a, partial)
            if w: total = total + inner([x[0].b for x in h], [x[0].b for x in o])
        return zero - total

    def slope_of_lagrangian(self, kind, q):
        """Slope of L = T − V with no constraint put in, along a coordinate or its rate, or the rate of such a slope."""
        zero, one, lagrange = Residue(0), Residue(1), self.case.by["lagrange"]
        if kind == "partial_t_dL_dqdot":
            clock = {"t": one} if "t" in self.case.coordinates else {}
            jets, varied = Jets(self.judge.point, clock), q + "'"
        else: jets, varied = Jets(self.judge.point, self.slopes), q if kind == "dL_dq" else q + "'"
        symbols = {name: (Jet(value, jets.slopes.get(name, zero)), Jet(one, zero) if name == varied else None)
                   for name, (value, _) in self.symbols.items()}
        named = {d["name"]: parse(d["value"]) for d in lagrange["named"]}
        scope = Scope(jets, symbols, named)
        total = [scope(lagrange[key])[1] or Jet(zero, zero) for key in ("kinetic_energy", "potential_energy")]
        total = total[0] - total[1]
        return total.a if kind in ("dL_dqdot", "dL_dq") else total.b

    def energy(self, text):
        """Value of an energy by its name."""
        if text in ("T_translation", "T_rotation"):
            total, half = Residue(0), Residue(pow(2, -1, Residue.P))
            for mass, r, w, h in self.world.masses():
                v = [x.a for x in self.world.velocity(r)]
                if text == "T_translation": total = total + mass[0].a * inner(v, v)
                elif w: total = total + inner([x[0].a for x in w], [x[0].a for x in h])
            return half * total
        scope = self.case.scope("kane", self.case.symbols)
        t, v = (scope(self.case.kane[key])[0] for key in ("kinetic_energy", "potential_energy"))
        known(text in ("T", "V", "L", "energy"), f"the quantity {text}")
        return {"T": t, "V": v, "L": t - v, "energy": t + v}[text]
