"""Random loads on a draft: springs, dampers, forces, torques, friction, inputs, potentials."""


def parts(d):
    s = d.sections
    return list(s["bodies"]), list(s["particles"])


def frame_of(d, name):
    return d.sections["bodies"][name]["frame"]


def any_frame(d):
    return d.random.choice(["N", "N", *(b["frame"] for b in d.sections["bodies"].values())])


def coefficient(d, unit, low=0.5, high=20):
    return d.positive("k", unit, low, high)


def spring(d):
    """A spring with damping between two points of bodies or of the ground."""
    r, (bodies, particles) = d.random, parts(d)
    ends = r.sample([*bodies, *particles, None], 2) if len(bodies) + len(particles) else []
    if ends[0] is None:
        ends.reverse()
    entry = {"on": ends[0], "stiffness": coefficient(d, "N/m", 2, 30)}
    if r.random() < 0.7:
        entry["free_length"] = d.positive("l", "m", 0.2, 1)
    if r.random() < 0.5:
        entry["damping"] = coefficient(d, "N*s/m", 0.1, 2)
    if ends[0] in bodies:
        entry["at"] = body_point(d, ends[0])
    if ends[1] is None:
        entry["against_at"] = ground_point(d)
    else:
        entry["against"] = ends[1]
        if ends[1] in bodies:
            entry["against_at"] = body_point(d, ends[1])
    d.sections["springs"][d.name("S")] = entry
    d.tags.add("spring")


def centre_of(d, name):
    return d.sections["bodies"][name].get("centre", f"{name}_centre")


def body_point(d, name):
    """A point fixed in a body, off its centre."""
    point = d.name("A_")
    place = [d.metres(d.number(-0.6, 0.6) or 0.1) for _ in range(3)]
    d.sections["points"][point] = {"from": centre_of(d, name), "frame": frame_of(d, name), "position": place}
    return point


def ground_point(d):
    point = d.name("G_")
    place = [d.metres(d.number(-2, 2) or 0.5) for _ in range(3)]
    d.sections["points"][point] = {"from": "O", "frame": "N", "position": place}
    return point


def force(d):
    """A force: constant, in an input, of the time, of a coordinate, or drag."""
    r, (bodies, particles) = d.random, parts(d)
    on = r.choice(bodies + particles)
    entry = {"on": on, "frame": any_frame(d)}
    if on in bodies and r.random() < 0.6:
        entry["at"] = body_point(d, on)
    vector = [0, 0, 0]
    for axis in r.sample(range(3), r.choice([1, 1, 2])):
        vector[axis] = force_formula(d, entry, axis, on in bodies)
    others = [b for b in bodies + particles if b != on]
    if others and on in bodies and r.random() < 0.3:
        entry["against"] = r.choice(others)
        if entry["against"] in bodies and r.random() < 0.5:
            entry["against_at"] = body_point(d, entry["against"])
        elif entry["against"] in particles:
            del entry["against"]
    entry["vector"] = vector
    d.sections["forces"][d.name("W")] = entry
    d.tags.add("force")


def force_formula(d, entry, axis, is_body):
    r = d.random
    kind = r.random()
    if kind < 0.25:
        return d.parameter("f", "N", d.number(-4, 4) or 1)
    if kind < 0.4:
        name = d.name("in")
        value = r.choice([2, "sin(t)", "3*cos(2*t)", 0.5])
        d.sections["inputs"][name] = {"unit": "N", "value": value}
        d.tags.add("input")
        return name
    if kind < 0.55:
        f, w = d.parameter("f", "N", d.number(0.5, 4) or 1), d.parameter("w", "rad/s", d.number(1, 5))
        d.tags.add("time")
        return f"{f}*sin({w}*t)"
    shifts = [c for c in d.start if c[0] == "x"]
    if kind < 0.75 and shifts:
        return f"-{coefficient(d, 'N/m')}*{r.choice(shifts)}"
    c = coefficient(d, "N*s/m", 0.1, 2)
    frame = entry["frame"]
    point = entry.get("at") or (centre_of(d, entry["on"]) if is_body else
                                d.sections["particles"][entry["on"]]["point"])
    if is_body:
        return f"-{c}*v({entry['on']}, {point}) @ {frame} [{axis + 1}]"
    return f"-{c}*v({point}) @ {frame} [{axis + 1}]"


def torque(d):
    """A torque on a body, against another one now and then."""
    r, (bodies, _) = d.random, parts(d)
    if not bodies:
        return
    on = r.choice(bodies)
    entry = {"on": on, "frame": any_frame(d)}
    if len(bodies) > 1 and r.random() < 0.5:
        entry["against"] = r.choice([b for b in bodies if b != on])
    vector, axis = [0, 0, 0], r.randrange(3)
    kind, turns = r.random(), [c for c in d.start if c[0] == "q"]
    if kind < 0.25 or not turns:
        vector[axis] = d.parameter("T", "N*m", d.number(-2, 2) or 0.5)
    elif kind < 0.5:
        vector[axis] = f"-{coefficient(d, 'N*m', 0.5, 5)}*{r.choice(turns)}"
    elif kind < 0.7:
        q = r.choice(turns)
        vector[axis] = f"-{coefficient(d, 'N*m*s', 0.05, 1)}*{q}' + {d.parameter('T', 'N*m', 1.5)}*sin({q})"
    elif kind < 0.85:
        vector[axis] = f"-{coefficient(d, 'N*m*s', 0.05, 1)}*omega({on}) @ {entry['frame']} [{axis + 1}]"
    else:
        name = d.name("in")
        d.sections["inputs"][name] = {"unit": "N*m", "value": r.choice([0.4, "cos(3*t)", f"-2*{r.choice(turns)}'"])}
        vector[axis] = name
        d.tags.add("input")
    entry["vector"] = vector
    d.sections["torques"][d.name("D")] = entry
    d.tags.add("torque")


def friction(d):
    r, (bodies, particles) = d.random, parts(d)
    d.tags.add("friction")
    s0 = d.parameter("s", "m/s", r.choice([0.05, 0.1, 0.3]), True)
    if bodies and r.random() < 0.4:
        w0 = d.parameter("s", "rad/s", r.choice([0.05, 0.2]), True)
        d.sections["friction"][d.name("R")] = {
            "on": r.choice(bodies), "frame": "N", "axis": r.choice([1, 2, 3]),
            "torque": d.parameter("T", "N*m", 0.3, True), "smoothing": w0}
        return
    on = r.choice(bodies + particles)
    entry = {"on": on, "coefficient": d.parameter("mu", "1", 0.3, True),
             "normal_force": d.parameter("f", "N", 2.0, True), "smoothing": s0}
    if on in bodies:
        entry["at"] = body_point(d, on)
    if r.random() < 0.5:
        entry["frame"], entry["normal"] = any_frame(d), r.choice([1, 2, 3])
    if r.random() < 0.4:
        entry["static"], entry["stribeck"] = d.parameter("mu", "1", 0.5, True), d.parameter("s", "m/s", 0.2, True)
    d.sections["friction"][d.name("R")] = entry


def potential(d):
    r = d.random
    turns = [c for c in d.start if c[0] == "q"]
    shifts = [c for c in d.start if c[0] == "x"]
    kind = r.random()
    if turns and kind < 0.5:
        a = r.choice(turns)
        k = coefficient(d, "J", 0.5, 6)
        form = r.choice([f"{k}*{a}^2/2", f"{k}*(1 - cos({a}))", f"{k}*sin({a})^2"])
        if len(turns) > 1 and r.random() < 0.5:
            form = f"{k}*({a} - {r.choice([t for t in turns if t != a])})^2/2"
    elif shifts and kind < 0.75:
        form = f"{coefficient(d, 'N/m')}*{r.choice(shifts)}^2/2"
    else:
        bodies, particles = parts(d)
        b = r.choice(bodies + particles)
        point = centre_of(d, b) if b in bodies else d.sections["particles"][b]["point"]
        form = r.choice([f"{coefficient(d, 'N/m')}*distance({point}, {ground_point(d)})^2/2",
                         f"{coefficient(d, 'N')}*p({point}) @ N [{r.choice([1, 2, 3])}]",
                         f"-{coefficient(d, 'J*m')}/distance({point}, {ground_point(d)})"])
    d.sections["potentials"][d.name("E")] = form
    d.tags.add("potential")


def name_expressions(d):
    """A factor of loads by a name under `expressions`."""
    r = d.random
    name = d.name("ex")
    turns = [c for c in d.start if c[0] == "q"]
    if not turns:
        return
    q = r.choice(turns)
    value = r.choice([f"1 + sin({q})^2", f"cos({q})", f"exp(-{q}^2)", f"sqrt(2 + cos({q}))", f"tanh({q})",
                      f"max({q}, 0.1)", f"abs({q})", f"atan({q})"])
    d.sections["expressions"][name] = value
    for section in ("forces", "torques"):
        for entry in d.sections[section].values():
            entry["vector"] = [f"({v})*{name}" if isinstance(v, str) and r.random() < 0.7 else v
                               for v in entry["vector"]]
    if not any(name in str(e) for s in ("forces", "torques") for e in d.sections[s].values()):
        del d.sections["expressions"][name]
        return
    d.tags.add("expression")


def fit(d, most=3):
    """Up to `most` random loads."""
    r = d.random
    for _ in range(r.randint(0, most)):
        r.choice([spring, spring, force, force, torque, torque, torque, friction, potential])(d)
    if r.random() < 0.15:
        name_expressions(d)
    return d
