"""Random closed loops: chains of bodies in a plane or in space whose last body a joint ties to another one."""
import math
import numpy as np
from draft import Draft
from mechanism import Configuration, Mechanism
from trees import body, joint

PLANE_KINDS = ["pin", "pin", "pin", "slider"]


def chain(d, kinds, to=None, plane=False):
    """Bodies in a row; their names."""
    names = []
    for k, kind in enumerate(kinds):
        name = body(d)
        if plane:
            d.sections["bodies"][name]["inertia"] = d.positive("J", "kg*m^2", 0.02, 0.3)
        entry = joint(d, name, to, kind, planar=plane)
        if plane:
            entry["axis"] = 3 if kind == "pin" else d.random.choice([1, 2])
            length = f"{max(d.number(0.3, 1.2), 0.2)} m"
            entry["at"] = [length, 0, 0] if to else [f"{d.number(-0.3, 0.3)} m", f"{d.number(-0.3, 0.3)} m", 0]
            entry["centre"] = [f"{max(d.number(0.1, 0.5), 0.1)} m", d.random.choice([0, "0.1 m"]), 0]
        to = name
        names.append(name)
    return names


def close(d, end, other, kind, plane=False):
    """A joint between two bodies that is closed at the start of the draft, up to rounded numbers."""
    place = [0.4, 0.0, 0.0] if plane else [round(d.random.uniform(-0.6, 0.6), 2) for _ in range(3)]
    m = Mechanism(d.text())
    c = Configuration(m, {q: v[0] for q, v in d.start.items()})
    spot = c.joint_point(m.joint_of[end]).v + c.body_frame(end).v @ np.array(place)
    entry = {"kind": kind, "body": end, "body_at": [f"{v} m" if v else 0 for v in place]}
    base, axes = np.zeros(3), np.eye(3)
    if other:
        entry["to"] = other
        base, axes = c.joint_point(m.joint_of[other]).v, c.body_frame(other).v
    at = [round(float(v), 6) for v in axes.T @ (spot - base)]
    entry["at"] = [f"{v} m" if abs(v) > 1e-12 else 0 for v in at]
    if kind in ("pin", "cylinder", "planar", "slider"):
        entry["axis"] = 3 if plane and kind == "pin" else d.random.choice([1, 2] if plane else [1, 2, 3])
    if not plane and kind not in ("ball",):
        r = c.body_frame(end).v.T @ axes
        angles = [math.atan2(-r[1, 2], r[2, 2]), math.asin(max(-1, min(1, r[0, 2]))), math.atan2(-r[0, 1], r[0, 0])]
        entry["body_turned"] = {"sequence": "123", "angles": [repr(round(a, 6)) for a in angles]}
    d.sections["joints"][d.name("L_")] = entry
    d.tags.add(f"loop by {kind}")


def assembly(d):
    """The pose near which the loops are closed, rounded."""
    d.sections["assembly"] = {q: round(v[0], 2) for q, v in d.start.items()}


def plane_loop(random, hostile=False):
    """One or two loops of pins and sliders in a plane."""
    d = Draft(random, "Random plane loop", hostile)
    d.constrained = True
    count = random.choice([3, 3, 3, 4])
    kinds = ["pin"] + [random.choice(PLANE_KINDS) for _ in range(count - 1)]
    names = chain(d, kinds, plane=True)
    close(d, names[-1], None, "pin", plane=True)
    if random.random() < 0.2:
        more = chain(d, ["pin", "pin"], to=names[0], plane=True)
        close(d, more[-1], names[-1], "pin", plane=True)
    if random.random() < 0.7:
        assembly(d)
    g = d.parameter("g", "m/s^2", 9.81, True)
    d.gravity = [0, f"-{g}", 0]
    return d


def stated_loop(random, hostile=False):
    """A loop by equations between coordinates or between positions of points."""
    d = Draft(random, "Random stated loop", hostile)
    d.constrained = True
    names = chain(d, ["pin", "pin", "pin"], plane=True)
    m = Mechanism(d.text())
    c = Configuration(m, {q: v[0] for q, v in d.start.items()})
    end = names[-1]
    spot = c.joint_point(m.joint_of[end]).v + c.body_frame(end).v @ np.array([0.5, 0, 0])
    s = d.sections
    s["points"]["Q_end"] = {"from": list(s["joints"])[-1], "frame": s["bodies"][end]["frame"],
                            "position": ["0.5 m", 0, 0]}
    s["points"]["Q_pin"] = {"from": "O", "frame": "N", "position": [f"{round(float(v), 5)} m" for v in spot[:2]] + [0]}
    kind = random.random()
    if kind < 0.5:
        for k, name in ((1, "loop_x"), (2, "loop_y")):
            s["constraints"][name] = f"p(Q_end) @ N [{k}] = p(Q_pin) @ N [{k}]"
    elif kind < 0.75:
        x = s["points"]["Q_pin"]["position"][1].split()[0]
        h = d.parameter("h", "m", float(x))
        s["constraints"]["rail"] = f"p(Q_end) @ N [2] = {h}"
    else:
        # A rod without mass between two points.
        rod = d.parameter("rod", "m", round(float(np.hypot(*(spot[:2] - np.array([3.0, 1.0])))), 5))
        s["points"]["Q_pin"]["position"] = ["3 m", "1 m", 0]
        s["constraints"]["rod"] = f"distance(Q_end, Q_pin) = {rod}" if random.random() < 0.4 else \
            f"(p(Q_end) @ N [1] - p(Q_pin) @ N [1])^2 + (p(Q_end) @ N [2] - p(Q_pin) @ N [2])^2 = {rod}^2"
    d.tags.add("stated loop")
    g = d.parameter("g", "m/s^2", 9.81, True)
    d.gravity = [0, f"-{g}", 0]
    return d


def space_loop(random, hostile=False):
    """A loop in space, with one to three freedoms."""
    d = Draft(random, "Random loop in space", hostile)
    d.constrained = True
    closing, leaves = random.choice([("ball", 3), ("ball", 3), ("cylinder", 4), ("universal", 4), ("planar", 3)])
    kinds, freedom = [], 0
    worth = {"pin": 1, "slider": 1, "universal": 2, "cylinder": 2, "ball": 3}
    while freedom < leaves + 1:
        kinds.append(random.choice(["pin", "pin", "universal", "ball", "cylinder", "slider"][:6 if len(kinds) else 3]))
        freedom += worth[kinds[-1]]
    names = chain(d, kinds)
    close(d, names[-1], None, closing)
    assembly(d)
    d.fall()
    return d
