"""Random trees of bodies, by joints or by frames and points."""
from draft import Draft

KINDS = ["pin"] * 5 + ["slider"] * 2 + ["cylinder", "screw", "universal", "universal", "ball", "ball", "planar", "free"]
ANGLES = ["pi/2", "pi/3", "-pi/4", "pi", "0.3", "1.1", "-0.7"]


def orientation(r):
    digits = "".join(r.sample("123", r.choice([1, 2])))
    return {"sequence": digits, "angles": [r.choice(ANGLES) for _ in digits]}


def joint(d, body, to, kind, planar=False):
    """A joint of a body, with its coordinates, speeds and start."""
    r = d.random
    entry = {"kind": kind, "body": body}
    if to:
        entry["to"] = to
    if not planar:
        if r.random() < 0.7:
            entry["at"] = d.lengths()
        if r.random() < 0.4:
            entry["turned"] = orientation(r)
            d.tags.add("turned")
        if r.random() < 0.8:
            entry["centre"] = d.lengths(0.6)
    if kind in ("pin", "slider", "cylinder", "screw", "planar") and not planar:
        entry["axis"] = r.choice([1, 2, 3])
        if kind in ("pin", "slider", "cylinder", "screw") and r.random() < 0.15:
            entry["axis"] = r.choice([[1, 0, 2], [1, 1, 1], [0, -1, 3], [2, -1, 2]])
            d.tags.add("oblique axis")
    if kind == "screw":
        entry["lead"] = d.parameter("h", "m", d.number(0.05, 0.5) or 0.1)
    if kind == "universal" and r.random() < 0.5:
        entry["axes"] = r.sample([1, 2, 3], 2)
    shifts = {"slider": 1, "planar": 2, "free": 3, "cylinder": 1}.get(kind, 0)
    turns = {"pin": 1, "cylinder": 1, "screw": 1, "universal": 2, "ball": 3, "planar": 1, "free": 3}.get(kind, 0)
    euler = kind in ("ball", "free") and r.random() < 0.4
    if kind in ("ball", "free"):
        # Different axes in a row.
        entry["sequence"] = "euler" if euler else r.choice(["123", "313", "321", "132", "212", "231"])
        d.tags.add("euler parameters" if euler else "sequence")
    coordinates = []
    order = ["turn", "shift"] if kind == "cylinder" else ["shift"] * shifts + ["turn"] * turns
    for k in order[:shifts] if euler else order:
        name = d.name("x" if k == "shift" else "q")
        coordinates.append(name)
        low, high = (-0.8, 0.8) if k == "shift" else (-1.3, 1.3)
        d.start[name] = (r.uniform(low, high), r.uniform(-1.5, 1.5))
    if kind in ("ball", "free") and not euler and entry["sequence"][0] == entry["sequence"][2]:
        name = coordinates[shifts + 1]
        d.start[name] = (r.uniform(0.4, 1.3), r.uniform(-1, 1))
    if euler:
        values = [1 + r.random(), *(r.uniform(-1, 1) for _ in range(3))]
        size = sum(v * v for v in values) ** 0.5
        for v in values:
            name = d.name("e")
            coordinates.append(name)
            d.start[name] = (v / size, r.uniform(-0.6, 0.6))
    entry["coordinates"] = coordinates
    entry["speeds"] = [d.name("u") for _ in range(shifts + turns)] if kind != "screw" else [d.name("u")]
    if kind == "weld":
        del entry["coordinates"], entry["speeds"]
    elif not d.constrained and kind not in ("ball", "free") and r.random() < 0.35:
        own_speeds(d, entry, coordinates)
    d.sections["joints"][d.name("J_")] = entry
    return entry


def own_speeds(d, entry, coordinates):
    """Speeds of the file's own instead of the rates: sums, factors of coordinates, earlier rates."""
    r = d.random
    names, entry["speeds"] = entry["speeds"], []
    d.tags.add("own speeds")
    for name, q in zip(names, coordinates):
        form = f"{q}'"
        unit = "x" if q.startswith("x") else "q"
        earlier = [c for c in d.start if c.startswith(unit) and c not in coordinates]
        angles = [c for c in d.start if c.startswith("q")]
        if earlier and r.random() < 0.5:
            form += r.choice([" + ", " - "]) + r.choice(["", "2*"]) + r.choice(earlier) + "'"
        if angles and r.random() < 0.4:
            form = f"({form})*{r.choice(['(2 + cos(%s))', '(3 - sin(%s))'])}" % r.choice(angles)
        elif r.random() < 0.3:
            form = f"-({form})"
        d.sections["speeds"][name] = form


def body(d, frame=None):
    """A body; its name."""
    name = d.name("b")
    entry = {"frame": frame or f"F{name}", "mass": d.mass(), "inertia": d.inertia()}
    d.sections["bodies"][name] = entry
    return name


def joint_tree(random, hostile=False, size=None, kinds=KINDS, constrained=False, literals=True):
    """A tree of bodies by joints."""
    d = Draft(random, "Random tree", hostile)
    d.constrained, d.literals = constrained, literals
    bodies = []
    for _ in range(size or random.choice([1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 6])):
        name = body(d)
        d.sections["bodies"][name]["centre"] = f"C{name}"
        to = random.choice([None, *bodies, *bodies]) if bodies else None
        kind = random.choice(kinds)
        if kind == "free" and (to or len(bodies) > 1) or kind in ("ball", "planar") and len(d.start) > 5:
            kind = "pin"
        joint(d, name, to, kind)
        bodies.append(name)
        if random.random() < 0.06:
            fluid(d, name)
    if hostile and random.random() < 0.5:
        zero = random.choice(list(d.start))
        if not zero.startswith("e"):
            d.start[zero] = (random.choice([0.0, 1e-9, 3.14159265, 1.5707963]), d.start[zero][1])
            d.tags.add("special pose")
    d.fall()
    return d


def fluid(d, name):
    """Added mass of a body."""
    moved = [d.parameter("X", "kg", d.number(0.2, 2) or 0.5) for _ in range(3)]
    turned = [d.parameter("K", "kg*m^2", d.number(0.05, 0.4) or 0.1) for _ in range(3)]
    d.sections["bodies"][name]["added_mass"] = {"diagonal": moved + turned}
    d.tags.add("added mass")


def placed_tree(random, hostile=False, literals=True):
    """Bodies and particles by frames and points; points may move in their frames, frames and points with time."""
    d = Draft(random, "Random frames and points", hostile)
    d.literals = literals
    r, frames, points = random, ["N"], ["O"]
    s = d.sections
    for k in range(r.choice([1, 2, 2, 3])):
        frame, parent = d.name("F"), r.choice(frames)
        kind = r.random()
        driven = r.random() < 0.12
        if kind < 0.6:
            q = coordinate(d, "q", "rad")
            angle = r.choice([q, f"-{q}", f"pi/2 - {q}", f"{q} + pi/6"])
            if driven:
                angle += " + " + drive(d, "1")
            s["frames"][frame] = {"from": parent, "axis": r.choice([1, 2, 3, 3, [1, 0, 2]]), "angle": angle}
        elif kind < 0.9:
            digits = r.choice(["12", "31", "313", "123", "213"])
            qs = [coordinate(d, "q", "rad") for _ in digits]
            if len(digits) == 3:
                d.start[qs[1]] = (r.uniform(0.3, 1.2), d.start[qs[1]][1])
            s["frames"][frame] = {"from": parent, "sequence": digits, "angles": qs}
            if r.random() < 0.3:
                s["frames"][frame]["fixed"] = "space"
                d.tags.add("space-fixed turns")
        else:
            s["frames"][frame] = {"from": parent, "axis": r.choice([1, 2, 3]), "angle": "pi/5"}
        frames.append(frame)
        point = d.name("P")
        place = [position(d) for _ in range(3)]
        if r.random() < 0.1:
            place[r.randrange(3)] = drive(d, "m")
        s["points"][point] = {"from": r.choice(points), "frame": frame, "position": place}
        points.append(point)
        if r.random() < 0.6:
            name = d.name("b")
            s["bodies"][name] = {"frame": frame, "centre": point, "mass": d.mass(), "inertia": d.inertia()}
            fixed = not any(c in str(place) for c in (*d.start, "*t"))
            if fixed and not d.hostile and s["points"][point]["from"] != "O" and r.random() < 0.4:
                moments = [d.parameter("I", "kg*m^2", round(r.uniform(20, 25), 1), True) for _ in range(3)]
                s["bodies"][name]["inertia"] = {"diagonal": moments, "about_point": s["points"][point]["from"]}
                d.tags.add("inertia about a point")
        else:
            s["particles"][d.name("p")] = {"point": point, "mass": d.positive("m", "kg", 0.3, 2)}
    if not d.start:
        coordinate(d, "x", "m")
    for name in list(d.start):
        s["speeds"][d.name("u")] = f"{name}'"
    if r.random() < 0.5:
        mix_speeds(d)
    # A coordinate that moves nothing has no inertia: a particle of its own sees to it.
    used = " ".join(str(v) for v in [*s["frames"].values(), *s["points"].values()])
    for name in d.start:
        if name not in used.replace(f"{name}0", ""):
            p = d.name("P")
            s["points"][p] = {"from": "O", "frame": "N", "position": [name, 0, 0] if name[0] == "x" else [0, 0, 0]}
            s["particles"][d.name("p")] = {"point": p, "mass": d.positive("m", "kg", 0.5, 2)}
    d.fall()
    return d


def coordinate(d, letter, unit):
    name = d.name(letter)
    d.sections["coordinates"][name] = {"unit": unit}
    d.start[name] = (d.random.uniform(-1.2, 1.2), d.random.uniform(-1.5, 1.5))
    return name


def position(d):
    """A component of a position that may contain a coordinate."""
    r = d.random
    if r.random() < 0.2:
        x = coordinate(d, "x", "m")
        return r.choice([x, f"-{x}", f"{x}/2"])
    return d.length()


def drive(d, unit):
    """A formula of the time."""
    a = d.parameter("A", unit, d.number(0.1, 0.5) or 0.2)
    w = d.parameter("w", "rad/s", d.number(1, 4))
    d.tags.add("drive")
    return d.random.choice([f"{a}*sin({w}*t)", f"{a}*{w}*t", f"{a}*cos({w}*t)"])


def mix_speeds(d):
    """Speeds that are combinations of rates."""
    r, speeds = d.random, d.sections["speeds"]
    names = list(speeds)
    angles = [c for c in d.start if c[0] == "q"]
    d.tags.add("own speeds")
    for k, u in enumerate(names):
        form, q = speeds[u], speeds[u][:-1]
        others = [c for c in list(d.start)[:k] if c[0] == q[0]]
        if others and r.random() < 0.5:
            form += f" + {r.choice(['', '2*'])}{r.choice(others)}'"
            if angles and r.random() < 0.5:
                form += f"*{r.choice(['sin', 'cos'])}({r.choice(angles)})"
        if angles and r.random() < 0.3:
            form = f"({form})*(2 + cos({r.choice(angles)}))"
        speeds[u] = form
