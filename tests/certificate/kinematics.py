"""Checks that the equations of a certificate are those of its model file, with a kinematics of its own.

    kinematics.py FILE…

Positions come from rotation matrices, velocities and accelerations from differentiation, and Kane's rows from the laws
of Newton and Euler with virtual power. Exit status 1 if anything is wrong. Parts of a model that this program does not
know are printed as `not checked: …`, and nothing that depends on them counts as checked.
"""
import re, sys
from check import check_prime, read, read_certificate
from claims import Case
from fractions import Fraction
from formula import NextPoint, Refused, Residue, Residues, Scope, add, mul, need, parse, tree

KEYS = {name: set(keys.split()) for name, keys in {
    "frames": "from axis angle sequence angles euler_parameters", "points": "from frame position",
    "bodies": "frame centre mass inertia", "particles": "point mass", "torques": "on against frame vector",
    "forces": "on at against against_at frame vector",
    "springs": "on at against against_at stiffness free_length damping",
    "joints": "kind body to at centre axis axes coordinates speeds sequence body_at"}.items()}
OTHERS = set("""name source schema parameters expressions inertial gravity coordinates speeds reactions domain
                constraints rolling notation inputs potentials assembly figure view""".split())


class NotChecked(Exception): pass


def known(holds, what):
    if not holds: raise NotChecked(what)


def sum_of(a, b, sign=1): return tree("+", (a, tree("*", (tree("n", Fraction(sign)), b))))
def half(a): return tree("/", a, tree("n", Fraction(2)))


WRITTEN = {  # Functions of model files that the formulas of derivations do not contain.
    "min": lambda a, b: half(sum_of(sum_of(a, b), tree("abs", sum_of(a, b, -1)), -1)),
    "max": lambda a, b: half(sum_of(sum_of(a, b), tree("abs", sum_of(a, b, -1)))),
    "atan2": lambda y, x: sum_of(zero := tree("n", Fraction(0)), tree("atan", tree("/", y, sum_of(x, tree(
        "sqrt", sum_of(tree("^", x, 2), tree("^", y, 2)))))), 2),
    "cot": lambda a: tree("/", tree("cos", a), tree("sin", a)), "ln": lambda a: tree("log", a),
    "sec": lambda a: tree("^", tree("cos", a), -1), "csc": lambda a: tree("^", tree("sin", a), -1)}
KNOWN = set("sin cos tan sqrt abs sign log exp atan tanh sinh cosh asin acos".split())


class ModelScope(Scope):
    """Values of formulas in a model file. They may contain more functions and half exponents."""
    def function(self, f, *e):
        if f in WRITTEN: return self.value(WRITTEN[f](*e))
        known(f in KNOWN and not ("atan" in repr(e) and f in ("sin", "cos")), f"the function {f}")
        return super().function(f, *e)


class Jet:
    """Residue with its slope along one direction: along the motion, or along a generalized speed."""
    __slots__ = ("a", "b")
    def __init__(self, a, b): self.a, self.b = a, b
    def __add__(self, o): return Jet(self.a + o.a, self.b + o.b)
    def __sub__(self, o): return Jet(self.a - o.a, self.b - o.b)
    def __mul__(self, o): return Jet(self.a * o.a, self.a * o.b + self.b * o.a)
    def inverse(self, factor=None):
        i = self.a.inverse()
        return Jet(i, Residue(0) - self.b * i * i)


class Jets:
    """Values at the point of `base`, with slopes along the direction in which the symbols have the given slopes."""
    def __init__(self, base, slopes): self.base, self.slopes, self.angles = base, slopes, {}
    def number(self, a): return Jet(self.base.number(a), Residue(0))
    def symbol(self, name): return Jet(self.base.symbol(name), self.slopes.get(name, Residue(0)))
    def circle(self, angle): return tuple(Jet(x, Residue(0)) for x in self.base.circle(angle))
    def root(self, x, is_number=False):
        r = self.base.root(x.a, is_number)
        return self.along(Jet(r, x.b), lambda: (Jet(r + r, x.b)).inverse(), x)
    def name(self, x, tree): return self.base.name(x.a, tree)
    def opaque(self, f, x): return Jet(self.base.opaque(f, x.a), Residue(0))
    def along(self, y, slope, x): return Jet(y.a, slope().a * x.b)


def dot(a, b):
    total = mul(a[0], b[0])
    for x, y in zip(a[1:], b[1:], strict=True): total = add(total, mul(x, y))
    return total


def times(m, v): return [dot(row, v) for row in m]
def plus(a, b): return [add(x, y) for x, y in zip(a, b, strict=True)]
def transposed(m): return [list(row) for row in zip(*m)]
def product(m, n): return transposed([times(m, column) for column in transposed(n)])
def inner(a, b): return sum((x * y for x, y in zip(a[1:], b[1:])), a[0] * b[0])
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class World:
    """Frames and points of a model, as pairs (value, rate) in the axes of the inertial frame."""
    def __init__(self, model, scope):
        self.model, self.scope, self.memo, self.one, self.zero = model, scope, {}, scope.number(1), scope.number(0)
        self.inertial, self.origin = model["inertial"]["frame"], model["inertial"]["origin"]
        self.bodies, self.placed, self.loops = model.get("bodies", {}), {}, []
        for name, joint in model.get("joints", {}).items():
            body = joint["body"]
            if body in self.placed or {"centre", "frame"} <= set(self.bodies[body]): self.loops.append(name)
            else: self.placed[body] = name
        self.frames_of_joints = {self.frame_name(body): body for body in self.placed}
        self.points_of_joints = {name: (body, "joint") for body, name in self.placed.items()}
        self.points_of_joints |= {self.bodies[b].get("centre", b + "_centre"): (b, "centre") for b in self.placed}

    def formula(self, text):
        """Value of a formula, which may contain components of positions, velocities and angular velocities."""
        text, names = str(text), self.scope.symbols
        def component(m):
            kind, of, frame, axis = m.groups()
            x = self.spin(self.axes(of) if of in self.bodies else self.frame(of)) if kind == "omega" else self.point(of)
            x = [(a, None) for a in x if kind == "omega"] or [(a, None) for a in self.velocity(x) if kind == "v"] or x
            return names.setdefault(f"component{len(names)}", times(transposed(self.frame(frame)), x)[int(axis) - 1])
        pattern = r"\b(p|v|omega)\((\w+)\) @ (\w+) \[([123])\]"
        for m in re.finditer(pattern, text):
            component(m)
            text = text.replace(m[0], list(names)[-1])
        def with_root(m):
            halves = int(m[2] or 2 * int(m[3] or 0) + 1)
            return f"({m[1]}^{halves // 2}*sqrt({m[1]}))"
        text = re.sub(r"((?<![\w.])\w+|(?<!\w)\([^()]*\))\^(?:\((\d+)/2\)|(\d*)\.5)", with_root, text)
        try: return self.scope(parse(text))
        except Refused as why: raise NotChecked(str(why)) from None
    def vector(self, values): return [self.formula(v) for v in values]
    def frame_name(self, body): return self.bodies[body].get("frame", body + "_frame")
    def once(self, key, make):
        if key not in self.memo:
            self.memo[key] = None
            self.memo[key] = make()
        known(self.memo[key] is not None, f"{key} is defined in a circle")
        return self.memo[key]

    def unit(self): return [[self.one if i == k else self.zero for k in range(3)] for i in range(3)]
    def turn(self, axis, angle):
        """Matrix of a turn about axis 1, 2 or 3."""
        if isinstance(axis, list):
            tilt = self.tilt(axis)
            return product(tilt, product(self.turn(3, angle), transposed(tilt)))
        m, (c, s) = self.unit(), (self.formula(f"{f}({angle})") for f in ("cos", "sin"))
        i, k = axis % 3, (axis + 1) % 3
        m[i][i], m[k][k], m[i][k], m[k][i] = c, c, mul(self.scope.number(-1), s), s
        return m
    def tilt(self, vector):
        """The smallest turn that takes axis 3 into the direction of a vector."""
        v = self.vector(vector)
        i = self.scope.domain.root(dot(v, v)[0], all(str(c).lstrip("-").isdigit() for c in vector)).inverse()
        x, y, z = ((c[0] * i, None) for c in v)
        n = ((self.one[0] + z[0]).inverse(), None)
        minus = lambda a: mul(self.scope.number(-1), a)
        k = [[mul(mul(a, b), minus(n)) for b in (x, y)] for a in (x, y)]
        return [[add(self.one, k[0][0]), k[0][1], x], [k[1][0], add(self.one, k[1][1]), y], [minus(x), minus(y), z]]
    def euler(self, names):
        """Matrix of Euler parameters, divided by the sum of their squares."""
        e0, e1, e2, e3 = e = self.vector(names)
        two, minus = self.scope.number(2), self.scope.number(-1)
        n = dot(e, e)
        i = n[0].inverse()
        inverse = i, self.scope.number(-1)[0] * i * i * n[1] if n[1] else None
        w = [[self.zero, mul(minus, e3), e2], [e3, self.zero, mul(minus, e1)], [mul(minus, e2), e1, self.zero]]
        ww = product(w, w)
        factor, unit = mul(two, inverse), self.unit()
        return [[add(unit[r][k], mul(factor, add(mul(e0, w[r][k]), ww[r][k]))) for k in range(3)] for r in range(3)]
    def turns(self, sequence, angles):
        if sequence == "euler": return self.euler(angles)
        m = self.unit()
        for axis, angle in zip(sequence, angles, strict=True): m = product(m, self.turn(int(axis), angle))
        return m

    def frame(self, name):
        if name == self.inertial: return self.unit()
        if name in self.frames_of_joints: return self.place(self.frames_of_joints[name])[0]
        joint = self.model.get("joints", {}).get(name.removesuffix("_base"))
        if joint and isinstance(joint.get("axis"), list):
            return product(self.axes(joint["to"]) if "to" in joint else self.unit(), self.tilt(joint["axis"]))
        f = self.model.get("frames", {}).get(name)
        known(f is not None, f"the frame {name}")
        def make():
            if "euler_parameters" in f: m = self.euler(f["euler_parameters"])
            elif "sequence" in f: m = self.turns(f["sequence"], f["angles"])
            else: m = self.turn(f["axis"], f["angle"])
            return product(self.frame(f["from"]), m)
        return self.once("frame " + name, make)

    def point(self, name):
        if name == self.origin: return [self.zero] * 3
        if name in self.points_of_joints:
            body, which = self.points_of_joints[name]
            return self.place(body)[1 if which == "joint" else 2]
        p = self.model.get("points", {}).get(name)
        known(p is not None, f"the point {name}")
        make = lambda: plus(self.point(p["from"]), times(self.frame(p["frame"]), self.vector(p["position"])))
        return self.once("point " + name, make)

    def place(self, body):
        """Axes of a body that a joint places, the joint's point, and the mass centre."""
        return self.once("body " + body, lambda: self.make_place(body, self.placed[body]))

    def coordinates(self, name):
        """Number of coordinates of a joint, of those of its turns, and their names."""
        j = self.model["joints"][name]
        turns = 4 if j.get("sequence") == "euler" else 3
        count = {"pin": 1, "slider": 1, "cylinder": 2, "universal": 2, "planar": 3, "weld": 0, "ball": turns,
                 "free": 3 + turns}.get(j["kind"])
        known(count is not None, f"a joint of the kind {j['kind']}")
        return count, turns, j.get("coordinates", [f"q_{name}" + f"_{k + 1}" * (count > 1) for k in range(count)])

    def make_place(self, body, name):
        j = self.model["joints"][name]
        kind, to = j["kind"], j.get("to")
        count, turns, q = self.coordinates(name)
        m = self.frame(self.frame_name(to)) if to else self.unit()
        anchor = [self.zero] * 3 if not to else self.place(to)[1] if to in self.placed else self.centre(to)
        at = j.get("at", [0, 0, 0])
        r = self.point(at) if isinstance(at, str) else plus(anchor, times(m, self.vector(at)))
        sequence, axis, e = j.get("sequence", "123"), j.get("axis", 3), transposed(m)
        known(isinstance(axis, int) or kind == "pin", f"a {kind} along a vector")
        planar = [axis % 3 + 1, (axis + 1) % 3 + 1] if kind == "planar" else []
        directions = {"slider": [axis], "planar": planar, "free": [1, 2, 3]}.get(kind, [])
        shifts = [(axis, q[1])] if kind == "cylinder" else zip(directions, q)
        for k, x in shifts: r = plus(r, [mul(self.formula(x), c) for c in e[k - 1]])
        if kind in ("pin", "cylinder"): m = product(m, self.turn(axis, q[0]))
        elif kind == "planar": m = product(m, self.turn(axis, q[2]))
        elif kind == "universal": m = product(m, self.turns("".join(map(str, j.get("axes", [1, 2]))), q))
        elif kind in ("ball", "free"): m = product(m, self.turns(sequence, q[count - turns:]))
        return m, r, plus(r, times(m, self.vector(j.get("centre", [0, 0, 0]))))

    def centre(self, body):
        return self.place(body)[2] if body in self.placed else self.point(self.bodies[body]["centre"])
    def axes(self, body): return self.frame(self.frame_name(body))

    def spin(self, m):
        """Angular velocity of axes: ω × = Ṁ Mᵀ."""
        rate = [[(x[1] or self.zero[0], None) for x in row] for row in m]
        w = product(rate, [[(x[0], None) for x in row] for row in transposed(m)])
        return [w[2][1][0], w[0][2][0], w[1][0][0]]

    def angular_momentum(self, body):
        """Angular velocity of a body, and its angular momentum about the mass centre."""
        inertia, w = self.bodies[body].get("inertia", 0), [(x, None) for x in self.spin(self.axes(body))]
        if not isinstance(inertia, dict): return w, [mul(self.formula(inertia), x) for x in w]
        known(set(inertia) <= {"diagonal", "products", "frame", "about_point"}, f"the inertia of {body}")
        (x, y, z), (xy, yz, zx) = self.vector(inertia["diagonal"]), self.vector(inertia.get("products", [0, 0, 0]))
        m = self.frame(inertia["frame"]) if "frame" in inertia else self.axes(body)
        h = times(m, times([[x, xy, zx], [xy, y, yz], [zx, yz, z]], times(transposed(m), w)))
        if "about_point" in inertia:  # Steiner: less m d × (ω × d), with d from the mass centre.
            d = [p[0] - c[0] for p, c in zip(self.point(inertia["about_point"]), self.centre(body))]
            less = cross(d, cross([a[0] for a in w], d))
            h = [(a[0] - self.formula(self.bodies[body]["mass"])[0] * b, None) for a, b in zip(h, less)]
        return w, h

    def end(self, load, body_key, point_key, otherwise=None):
        """Point of a load, and the velocity of the material there. `otherwise` is the point if the load names none."""
        body = load.get(body_key)
        if body in self.bodies:
            centre = self.centre(body)
            r = self.point(load[point_key]) if point_key in load else otherwise or centre
            arm = [x[0] - y[0] for x, y in zip(r, centre)]
            return r, [v + w for v, w in zip(self.velocity(centre), cross(self.spin(self.axes(body)), arm))]
        particle = self.model.get("particles", {}).get(body)
        named = load.get(point_key) or particle and particle["point"]
        r = self.point(named) if named else otherwise
        return r, self.velocity(r) if body else [self.zero[0]] * 3
    def velocity(self, r): return [x[1] or self.zero[0] for x in r]

    def masses(self):
        """Mass, point, angular velocity and angular momentum of every body and particle."""
        for p in self.model.get("particles", {}).values():
            yield self.formula(p["mass"]), self.point(p["point"]), None, None
        for name, body in self.bodies.items():
            yield self.formula(body.get("mass", 0)), self.centre(name), *self.angular_momentum(name)

    def loads(self):
        """Every force or torque with the velocity or angular velocity along which it works."""
        g = self.model.get("gravity")
        for mass, r, _, _ in self.masses() if g else ():
            weight = [mul(mass, x) for x in self.vector(g["acceleration"])]
            yield [x[0] for x in times(self.frame(g["frame"]), weight)], self.velocity(r)
        for f in self.model.get("forces", {}).values():
            force = [x[0] for x in times(self.frame(f["frame"]), self.vector(f["vector"]))]
            place, velocity = self.end(f, "on", "at")
            yield force, velocity
            if "against" in f:
                yield [self.zero[0] - x for x in force], self.end(f, "against", "against_at", place)[1]
        for t in self.model.get("torques", {}).values():
            torque = [x[0] for x in times(self.frame(t["frame"]), self.vector(t["vector"]))]
            for body, sign in ((t["on"], 1), (t.get("against"), -1)):
                if body is None or body == self.inertial: continue
                w = self.spin(self.axes(body) if body in self.bodies else self.frame(body))
                yield [self.scope.number(sign)[0] * x for x in torque], w
        for s in self.model.get("springs", {}).values():
            (p, v), (q, w) = self.end(s, "on", "at"), self.end(s, "against", "against_at")
            d, rate = [y[0] - x[0] for x, y in zip(p, q)], [y - x for x, y in zip(v, w)]
            length = self.scope.domain.root(inner(d, d))
            i = length.inverse()
            k, free, c = (self.formula(s.get(key, 0))[0] for key in ("stiffness", "free_length", "damping"))
            pull = [x * i * (k * (length - free) + c * inner(d, rate) * i) for x in d]
            yield pull, v
            yield [self.zero[0] - x for x in pull], w
        for p in self.model.get("potentials", {}).values():
            value = str(p["value"] if isinstance(p, dict) else p)
            known("@" not in value and "distance" not in value, "a potential of positions or distances")
            yield [self.scope.number(-1)[0]], [self.formula(value)[1] or self.zero[0]]


def check_model(text):
    """Checks one certificate; returns the parts that were checked and those that were not."""
    c = read_certificate(text)
    Residue.P, model = check_prime(int(c["prime"]), c["witness"], c["statement"]), c["model"]
    positive = {n for n, p in model["parameters"].items() if isinstance(p, dict) and p.get("positive")}
    for section, entries in model.items():
        known(section in KEYS or section in OTHERS, f"the section {section}")
        for name, entry in entries.items() if section in KEYS else []:
            unknown = set(entry) - KEYS[section] - {"about", "figure", "shape"}
            known(not unknown, f"{section}.{name}: {', '.join(unknown)}")
    count, others, Scope.PARTS = 0, set(), 1
    for at in range(5000):
        base = Residues(f"{c['statement']} model {at}".encode(), positive, are_signed=False)
        try: found = check_at(c, model, Case(c, base))
        except NextPoint as root:
            others |= set(root.args)
            continue
        count += 1
        if count == 64 or not set(base.roots.values()) - others: return found  # As in check.py, for √x² = |x|.
    raise NotChecked("roots that exist at too few points")


def named_terms(model, coordinates):
    """Expressions, inputs that are formulas, and coordinates that a constraint `name = formula` gives."""
    for name, e in model.get("expressions", {}).items(): yield name, e["value"] if isinstance(e, dict) else e
    for name, e in model.get("inputs", {}).items():
        if isinstance(e.get("value"), str): yield name, e["value"]
    for e in model.get("constraints", {}).values():
        name, _, value = map(str.strip, (e["equation"] if isinstance(e, dict) else e).partition("="))
        if name in model.get("coordinates", {}) and name not in coordinates: yield name, value


def check_at(c, model, case):
    symbols, done, left = case.symbols, [], []
    try: named = {name: parse(str(value)) for name, value in named_terms(model, case.coordinates)}
    except Refused as why: raise NotChecked(str(why)) from None
    def world(slopes):
        jets = Jets(case.domain, slopes)
        jet = lambda name: Jet(symbols[name][0], slopes.get(name, Residue(0)))
        values = {name: (jet(name), None) for name in symbols}
        values |= {q: (jet(q), jet(q + "'")) for q in case.coordinates}
        return World(model, ModelScope(jets, values, named))
    moving = world({name: value[1] for name, value in symbols.items() if value[1] is not None})
    partial_rates = [{q + "'": x for q, x in zip(case.coordinates, w)} for w in case.w]
    along = [world({s: Residue(1), **rates}) for s, rates in zip(case.speeds, partial_rates)]
    missing = [q for q in model.get("coordinates", {}) if q not in case.coordinates and q not in named]
    of_joints = [q for j in model.get("joints", {}).values() for q in j.get("coordinates", [])]
    missing += [q for q in of_joints if q not in case.coordinates]
    known(not missing, f"the coordinate {', '.join(missing)}, which a loop eliminates")
    same = lambda x, y, what: done.append(what) if x.v == y.v else need(False, f"{what}: differs from the model")
    zero, kane = Residue(0), case.scope("kane", symbols)
    masses, loads = list(moving.masses()), list(moving.loads())
    energy = zero
    for mass, r, w, h in masses:
        v = moving.velocity(r)
        energy = energy + (mass[0] * inner(v, v)).a + (inner([x[0] for x in w], [x[0] for x in h]).a if w else zero)
    same(energy, kane(case.kane["kinetic_energy"])[0] * Residue(2), "kinetic energy")
    power = sum((inner(f, v).a for f, v in loads), zero)
    of_potential = kane(case.kane["potential_energy"])[1] or zero
    same(kane(case.kane["power"])[0] - of_potential, power, "potential energy and power of the loads")
    matrix, force = case.system("kane", kane)
    for name, other, row, b in zip(case.speeds, along, matrix, force):
        total = zero
        for (mass, r, w, h), (_, s, o, _) in zip(masses, other.masses()):
            a, partial = [x.b for x in moving.velocity(r)], [x.b for x in other.velocity(s)]
            total = total + mass[0].a * inner(a, partial)
            if w: total = total + inner([x[0].b for x in h], [x[0].b for x in o])
        for (f, _), (_, v) in zip(loads, other.loads()): total = total - inner([x.a for x in f], [x.b for x in v])
        same(case.dot(row, case.free) - b, total, f"equation of {name}")
    check_speeds(model, case, moving, same, left)
    check_constraints(model, case, moving, named, same, left)
    return done, left


def check_speeds(model, case, world, same, left):
    """The speeds have the definitions of the model, at the rates of the coordinates that the derivation states."""
    definitions = dict(model.get("speeds", {}))
    for name, j in model.get("joints", {}).items():
        if name in world.loops: continue
        count, turns, q = world.coordinates(name)
        renamed = ["u" + x[1:] if x.startswith("q") else "u_" + x for x in q][:count - (turns == 4)]
        u = j.get("speeds", renamed)
        if j["kind"] in ("pin", "slider", "planar", "cylinder", "universal"):
            definitions |= {s: x + "'" for s, x in zip(u, q)}
        elif j["kind"] in ("ball", "free") and len(u) in (3, 6) and set(u) <= set(case.speeds):
            if j["kind"] == "free": definitions |= {s: x + "'" for s, x in zip(u[:3], q)}
            u = u[-3:]
            m, to = world.place(j["body"])[0], world.axes(j["to"]) if j.get("to") else world.unit()
            w = [(x - y, None) for x, y in zip(world.spin(m), world.spin(to))]
            for s, x in zip(u, times(transposed(m), w)): same(x[0].a, case.symbols[s][0], f"speed {s}")
            definitions |= {s: s for s in u}
    for s in case.speeds:
        if s not in definitions: left.append(f"the definition of the speed {s}")
        elif definitions[s] != s: same(world.formula(definitions[s])[0].a, case.symbols[s][0], f"speed {s}")


def check_constraints(model, case, world, named, same, left):
    """The stated rates satisfy the constraints."""
    for name, e in model.get("constraints", {}).items():
        text = e["equation"] if isinstance(e, dict) else e
        is_rate = "'" in text or re.search(r"\b(v|omega)\(", text)
        try: sides = [world.formula(side) for side in text.split("=")]
        except NotChecked: left.append(f"the constraint {name}")
        else: same(*((x[0] if is_rate else x[1] or world.zero[0]).a for x in sides), f"constraint {name}")
    for name, r in model.get("rolling", {}).items():
        if "against" in r or "normal" in r: left.append(f"the rolling {name}")
        else:
            slip = [(x, None) for x in world.end({"on": r["body"], "at": r["at"]}, "on", "at")[1]]
            slip = times(transposed(world.frame(r.get("frame", world.inertial))), slip)
            for k in (0, 1): same(slip[k][0].a, Residue(0), f"rolling {name} along axis {k + 1}")
    for name in world.loops:
        j = model["joints"][name]
        def joint_at(body, at):
            m, anchor, _ = world.place(body) if body in world.placed else (world.axes(body), world.centre(body), None)
            return world.point(at) if isinstance(at, str) else plus(anchor, times(m, world.vector(at)))
        known(j["kind"] == "pin" or j["kind"] == "ball", f"a loop with a {j['kind']}")
        here, there = j.get("at", [0, 0, 0]), joint_at(j["body"], j.get("body_at", [0, 0, 0]))
        if "to" in j: here = joint_at(j["to"], here)
        else: here = world.point(here) if isinstance(here, str) else world.vector(here)
        gap = [add(x, mul(world.scope.number(-1), y)) for x, y in zip(here, there)]
        local = times(transposed(world.axes(j["to"])), gap) if "to" in j else gap
        closed = any(all((x[1] or world.zero[0]).a.v == 0 for x in g) for g in (gap, local))
        if closed: same(Residue(0), Residue(0), f"position of the loop {name}")
        if not closed or j["kind"] == "pin" and not is_planar(model): left.append(f"the loop of the joint {name}")


def is_planar(model):
    """True if all joints turn about axis 3, so that positions alone close loops."""
    return all(j["kind"] == "pin" and j.get("axis", 3) == 3 for j in model.get("joints", {}).values())


def main(argv):
    sys.setrecursionlimit(20_000)
    status = set()
    for path in argv:
        try:
            done, left = check_model(read(path))
            print(f"{path}: {len(done)} statements hold: {', '.join(done)}")
            if left: raise NotChecked("; ".join(left))
        except NotChecked as why:
            print(f"{path}: not checked: {why}")
            status.add(3)
        except (Refused, LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as why:
            print(f"{path}: refused: {why if isinstance(why, Refused) else repr(why)}")
            status.add(1)
    return min(status, default=0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
