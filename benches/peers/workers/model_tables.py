"""Model files as other tools take them: each frame by one turn, each point by a way in a frame, bodies, loads and constraints, with formulas
as text that Python evaluates once `^` is `**`.

Known here is what the mechanisms of sections/mechanisms.py are made of: pins about the third axis stand for frames and points, as
docs/model.md says. Whatever else a file says is refused.
"""

import re
import tomllib

SECTIONS = "name source parameters coordinates speeds inertial frames points bodies joints gravity constraints rolling springs torques reactions"


class Tables:
    def __init__(self, path):
        file = tomllib.loads(path.read_text())
        if unknown := [key for key in file if key not in SECTIONS.split()]:
            raise SystemExit(f"{path}: `{unknown[0]}` is not known here")
        self.parameters = list(file["parameters"])
        self.coordinates = list(file.get("coordinates", {}))
        self.independent = [formula.removesuffix("'") for formula in file.get("speeds", {}).values()]
        self.ground, self.origin = file["inertial"]["frame"], file["inertial"]["origin"]
        self.frames = {name: (one["from"], one["axis"], one["angle"]) for name, one in file.get("frames", {}).items()}
        self.points = {name: way(one) for name, one in file["points"].items() if one["from"] == self.origin}
        self.bodies, self.closed, later = {}, [], {name: one for name, one in file["points"].items() if name not in self.points}
        joints = dict(file.get("joints", {}))
        bodies = dict(repeated(file["bodies"]))
        for name, joint in joints.items():
            self.pin(name, joint, bodies)
        self.points |= {name: way(one) for name, one in later.items()}
        self.bodies = {name: body(one) for name, one in bodies.items()}
        gravity = file.get("gravity", {"frame": self.ground, "acceleration": [0, 0, 0]})
        self.gravity = gravity["acceleration"]
        self.equations = [one["equation"].split("=") for one in file.get("constraints", {}).values()]
        self.rolling = [(one["body"], one["at"], one["frame"]) for one in file.get("rolling", {}).values()]
        self.springs = list(file.get("springs", {}).values())
        self.closes = bool(self.equations or self.closed or self.rolling)
        self.torques = [(one["on"], one["vector"]) for one in file.get("torques", {}).values()]

    def pin(self, name, joint, bodies):
        """The frame and the points of a joint that carries a body; or what closes a loop, as two points that have one place."""
        if joint["kind"] != "pin" or joint.get("axis", 3) != 3:
            raise SystemExit(f"joint `{name}`: only pins about the third axis are known here")
        one, carrier = bodies[joint["body"]], bodies.get(joint.get("to"))
        frame, home = (carrier["frame"], carrier["pin"]) if carrier else (self.ground, self.origin)
        at = joint.get("at", [0, 0, 0])
        on = at if isinstance(at, str) else f"{name}_on"
        if on != at:
            self.points[on] = (home, frame, at)
        if "pin" in one:
            self.points[f"{name}_body"] = (one["pin"], one["frame"], joint["body_at"])
            self.closed.append((on, f"{name}_body"))
            return
        (q,) = joint["coordinates"]
        self.coordinates.append(q)
        self.independent += [] if joint.get("speeds") == [] else [q]
        one |= {"frame": f"{joint['body']}_frame", "centre": f"{name}_centre", "pin": name}
        self.frames[one["frame"]] = (frame, 3, q)
        self.points[name] = (on, frame, [0, 0, 0])
        self.points[one["centre"]] = (name, one["frame"], joint["centre"])

def repeated(bodies):
    """`"K{i in 1..7}"` as seven."""
    for name, one in bodies.items():
        found = re.fullmatch(r"(.*)\{(\w+) in (\d+)\.\.(\d+)\}", name)
        if not found:
            yield name, dict(one)
            continue
        for k in range(int(found[3]), int(found[4]) + 1):
            yield f"{found[1]}{k}", {key: value.replace(f"{{{found[2]}}}", str(k)) for key, value in one.items()}


def way(one):
    return one["from"], one["frame"], one["position"]


def body(one):
    """Frame, mass centre, mass, the frame of the inertia and its entries xx yy zz xy yz zx; one moment is that about the third axis."""
    inertia = one["inertia"]
    if not isinstance(inertia, dict):
        return one["frame"], one["centre"], one["mass"], one["frame"], [0, 0, inertia, 0, 0, 0]
    entries = [*inertia["diagonal"], *inertia.get("products", [0, 0, 0])]
    return one["frame"], one["centre"], one["mass"], inertia.get("frame", one["frame"]), entries


def value(formula, names):
    """A formula as a term of a tool, or a number."""
    return eval(formula.replace("^", "**"), {"__builtins__": {}}, names) if isinstance(formula, str) else formula


def component(formula):
    """(point, axis) of `p(POINT) @ FRAME [AXIS]`, or None."""
    found = re.fullmatch(r"\s*p\((\w+)\) @ \w+ \[([123])\]\s*", formula)
    return (found[1], int(found[2]) - 1) if found else None
