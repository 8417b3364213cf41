"""Random mechanisms with constraints between velocities, gears and prescribed motions."""
from draft import Draft
from trees import body, joint, joint_tree


def disc(random, hostile=False, literals=True):
    """A disc that rolls on a plane, with other mechanisms on it now and then."""
    d = Draft(random, "Random rolling disc", hostile)
    d.literals = literals
    d.constrained = True
    s, r = d.sections, random
    d.counts = {"q": 3, "x": 1, "u": 3}
    for name, unit, value in (("x1", "m", 0.3), ("y1", "m", -0.2), ("q1", "rad", 0.5), ("q2", "rad", 0.4),
                              ("q3", "rad", 0.7)):
        s["coordinates"][name] = {"unit": unit}
        d.start[name] = (value + r.uniform(-0.3, 0.3), r.uniform(-1.5, 1.5))
    radius = d.positive("R", "m", 0.2, 0.6)
    m = d.positive("m", "kg", 0.5, 3)
    s["frames"] |= {"Y": {"from": "N", "axis": 3, "angle": "q1"}, "L": {"from": "Y", "axis": 1, "angle": "q2"},
                    "D": {"from": "L", "axis": 2, "angle": "q3"}}
    s["points"] |= {"C": {"from": "O", "frame": "N", "position": ["x1", "y1", 0]},
                    "Ds": {"from": "C", "frame": "L", "position": [0, 0, radius]}}
    s["bodies"]["disc"] = {"frame": "D", "centre": "Ds", "mass": m, "inertia": {
        "frame": "L", "diagonal": [f"{m}*{radius}^2/4", f"{m}*{radius}^2/2", f"{m}*{radius}^2/4"]}}
    s["speeds"] |= r.choice([
        {"u1": "q2'", "u2": "q3' + q1'*sin(q2)", "u3": "q1'*cos(q2)"}, {"u1": "q1'", "u2": "q2'", "u3": "q3'"},
        {"u1": "omega(disc) @ L [1]", "u2": "omega(disc) @ L [2]", "u3": "omega(disc) @ L [3]"},
        {"u1": "2*q1' - q2'", "u2": "q2' + q3'", "u3": "q3'*(2 + cos(q1))"}])
    s["rolling"]["ground"] = {"body": "disc", "at": "C"}
    if r.random() < 0.3:
        s["rolling"]["ground"]["frame"] = r.choice(["Y", "L", "N"])
    if r.random() < 0.4:
        name = body(d)
        joint(d, name, "disc", r.choice(["pin", "slider", "universal"]))
    d.tags.add("rolling")
    g = d.parameter("g", "m/s^2", 9.81, True)
    d.gravity = [0, 0, f"-{g}"]
    return d


def ball(random, hostile=False):
    """A ball that rolls on the ground, or on a plate that turns or slides."""
    d = Draft(random, "Random rolling ball", hostile)
    d.constrained = True
    s, r = d.sections, random
    plate = None
    if r.random() < 0.4:
        plate = body(d)
        s["bodies"][plate]["centre"] = f"C{plate}"
        entry = joint(d, plate, None, r.choice(["pin", "slider"]))
        for key in ("at", "turned"):
            entry.pop(key, None)
        entry["axis"] = 3 if entry["kind"] == "pin" else r.choice([1, 2])
    name = body(d)
    s["bodies"][name]["centre"] = f"C{name}"
    entry = joint(d, name, None, "free")
    for key in ("at", "turned", "centre"):
        entry.pop(key, None)
    radius = d.positive("R", "m", 0.2, 0.6)
    s["points"]["K"] = {"from": f"C{name}", "frame": "N", "position": [0, 0, f"-{radius}"]}
    s["rolling"]["contact"] = {"body": name, "at": "K"}
    if plate:
        s["rolling"]["contact"]["against"] = plate
    d.tags.add("rolling")
    d.fall()
    return d


def sleigh(random, hostile=False, literals=True):
    """Bodies in a plane with blades, and trailers."""
    d = Draft(random, "Random sleigh", hostile)
    d.literals = literals
    d.constrained = True
    s, r = d.sections, random
    name = body(d)
    s["bodies"][name]["centre"] = f"C{name}"
    entry = joint(d, name, None, "planar", planar=True)
    entry["axis"] = 3
    names = [name]
    for _ in range(r.choice([0, 1, 1, 2])):
        child = body(d)
        entry = joint(d, child, names[-1], "pin", planar=True)
        entry["axis"] = 3
        entry["at"] = [d.metres(d.number(-0.8, -0.3)), 0, 0]
        entry["centre"] = [d.metres(d.number(-0.8, -0.3)), 0, 0]
        names.append(child)
    for name in r.sample(names, r.randint(1, len(names))):
        point = d.name("B_")
        frame, centre = s["bodies"][name]["frame"], s["bodies"][name].get("centre", f"{name}_centre")
        s["points"][point] = {"from": centre, "frame": frame,
                              "position": [d.metres(d.number(-0.5, 0.5) or 0.2), r.choice([0, d.metres(0.1)]), 0]}
        s["constraints"][d.name("edge")] = f"v({point}) @ {frame} [2] = 0"
    d.tags.add("blade")
    if r.random() < 0.3:
        d.fall()
    return d


def tied(random, hostile=False):
    """A tree with gears, prescribed coordinates, and constraints between velocities."""
    d = joint_tree(random, hostile, size=random.choice([2, 3, 3]),
                   kinds=["pin", "pin", "pin", "slider", "universal", "cylinder", "ball"], constrained=True)
    s, r = d.sections, random
    turns = [c for c in d.start if c[0] == "q" and single(d, c)]
    shifts = [c for c in d.start if c[0] == "x" and single(d, c)]
    kind = r.random()
    d.title = "Random ties"
    if kind < 0.25 and len(turns) > 1:
        a, b = r.sample(turns, 2)
        s["constraints"]["gear"] = f"{b} = {r.choice(['2', '-3', '3/2'])}*{a}"
        d.tags.add("gear")
    elif kind < 0.5 and (turns or shifts):
        c = r.choice(turns + shifts)
        a = d.parameter("A", "1" if c[0] == "q" else "m", d.number(0.2, 0.8) or 0.3)
        w = d.parameter("w", "rad/s", d.number(1, 4))
        s["constraints"]["drive"] = f"{c} = " + r.choice([f"{a}*sin({w}*t)", f"{a} + {a}*{w}*t", f"{a}*cos({w}*t)"])
        d.tags.add("drive")
    elif kind < 0.7 and turns:
        c = r.choice(turns)
        w = d.parameter("w", "rad/s", d.number(-2, 2) or 1)
        a = f"*{r.choice(['cos', 'sin'])}({w}*t)" if r.random() < 0.4 else ""
        s["constraints"]["motor"] = f"{c}' = {w}{a}"
        d.tags.add("drive")
    else:
        names = list(s["bodies"])
        b, f = r.choice(names), s["bodies"][names[0]]["frame"]
        c = s["bodies"][b].get("centre", f"{b}_centre")
        forms = [f"v({c}) @ {f} [{r.choice([1, 2, 3])}] = 0",
                 f"omega({b}) @ {r.choice(['N', f])} [{r.choice([1, 2, 3])}] = 0"]
        if turns and shifts:
            l = d.parameter("l", "m", 0.4)
            forms.append(f"{shifts[0]}' = {l}*{turns[0]}'*cos({turns[-1]})")
        s["constraints"]["tie"] = r.choice(forms)
        d.tags.add("velocity constraint")
    return d


def single(d, coordinate):
    """Whether a coordinate belongs to a joint whose speeds are rates."""
    return any(coordinate in j.get("coordinates", []) and j["kind"] not in ("ball", "free")
               for j in d.sections["joints"].values())
