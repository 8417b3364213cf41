"""What saves typing in a model file (docs/model.md), written out: repetition, named expressions, units of numbers, joints and
sequences of turns. What is left has frames by one turn each, points, coordinates and speeds alone."""

import re
from fractions import Fraction

from sympy import Matrix, Quaternion, Symbol, expand, radsimp, sqrt, trigsimp
from sympy.matrices import rot_ccw_axis1, rot_ccw_axis2, rot_ccw_axis3
from sympy.physics.mechanics import ReferenceFrame, dynamicsymbols

from grammar import Unsupported, expression, text

PROSE = ("name", "source", "about", "unit", "kind", "fixed", "sequence")
SCALES = {
    "mm": ("m", "1/1000"), "cm": ("m", "1/100"), "km": ("m", "1000"), "g": ("kg", "1/1000"), "t": ("kg", "1000"),
    "ms": ("s", "1/1000"), "min": ("s", "60"), "h": ("s", "3600"), "kN": ("N", "1000"), "kJ": ("J", "1000"),
    "kW": ("W", "1000"), "kPa": ("Pa", "1000"), "MPa": ("Pa", "1000000"), "deg": ("rad", "pi/180"),
    "rev": ("rad", "2*pi"), "rpm": ("1/s", "pi/30"),
}  # fmt: skip
NUMBER = re.compile(r"\s*(.*[\d.)])\s+([A-Za-z][\w*/^]*)\s*$", re.DOTALL)


def low_level(tables):
    """The tables of a file without what saves typing."""
    tables = repeated(tables)
    named = {}
    for name, value in tables.pop("expressions", {}).items():
        value = value["value"] if isinstance(value, dict) else value
        named[name] = f"({put_names(str(value), named)})"
    for name, entry in tables.pop("inputs", {}).items():
        value = str(entry.get("value", 0))
        if re.search(r"[A-Za-z]", value):
            named[name] = f"({put_names(value, named)})"
        else:
            tables.setdefault("parameters", {})[name] = {"unit": entry["unit"], "value": value}
    tables = {key: with_names(value, named) for key, value in tables.items() if key not in PROSE} | {
        key: value for key, value in tables.items() if key in PROSE
    }
    if "parameters" in tables:
        tables["parameters"] = {name: parameter(entry) for name, entry in tables["parameters"].items()}
    closing = write_joints(tables)
    write_sequences(tables)
    write_norms(tables)
    write_closing(tables, closing)
    write_positions(tables)
    write_friction(tables)
    write_potentials(tables)
    write_planar(tables)
    return tables


# Repetition


def repeated(tables):
    counts = tables.get("counts", {})
    return {key: write_out(value, counts, key) for key, value in tables.items() if key != "counts"}


def write_out(value, numbers, key=""):
    if isinstance(value, str):
        return value if key in PROSE else re.sub(r"\{([^}]*)\}", lambda found: whole(found[1], numbers), value)
    if isinstance(value, list):
        return [write_out(item, numbers) for item in value]
    if isinstance(value, dict):
        result = {}
        for key, item in value.items():
            for name, inner in keys(key, numbers):
                result[name] = write_out(item, inner, key)
        return result
    return value


def keys(key, numbers):
    """Each name that a key stands for, with its indices."""
    found = re.search(r"\{([^}]*)\}", key)
    if not found:
        return [(key, numbers)]
    before, after = key[: found.start()], key[found.end() :]
    ranged = re.fullmatch(r"\s*(\w+) in (.*)\.\.(.*)", found[1])
    if not ranged:
        return keys(before + whole(found[1], numbers) + after, numbers)
    index, first, last = ranged.groups()
    span = range(int(whole(first, numbers)), int(whole(last, numbers)) + 1)
    return [entry for i in span for entry in keys(f"{before}{i}{after}", numbers | {index: i})]


def whole(formula, numbers):
    value = expression(formula, numbers)
    if not getattr(value, "is_integer", isinstance(value, int)):
        raise Unsupported(f"`{{{formula}}}` is not a whole number")
    return str(value)


# Named expressions and units


def put_names(formula, named):
    return re.sub(r"[A-Za-z]\w*", lambda word: named.get(word[0], word[0]), formula)


def with_names(value, named, key=""):
    if isinstance(value, str):
        return value if key in PROSE else without_unit(put_names(value, named))
    if isinstance(value, list):
        return [with_names(item, named) for item in value]
    if isinstance(value, dict):
        return {key: with_names(item, named, key) for key, item in value.items()}
    return value


def without_unit(formula):
    """`90 deg` as a formula."""
    found = NUMBER.match(formula)
    if not found:
        return formula
    factors = [(word, SCALES.get(word, ("", "1"))[1]) for word in re.findall(r"[A-Za-z]+", found[2])]
    scale = found[2]
    for word, factor in factors:
        scale = re.sub(rf"\b{word}\b", f"({factor})", scale)
    return f"({found[1]})*{scale}"


def parameter(entry):
    """Values are no part of equations: `l = "0.5 m"` is the symbol alone."""
    return entry if isinstance(entry, dict) else {"unit": "", "value": entry}


# Joints

KINDS = {
    "pin": lambda axes: [("turn", axes[0])],
    "slider": lambda axes: [("way", axes[0])],
    "cylinder": lambda axes: [("turn", axes[0]), ("way", axes[0])],
    "screw": lambda axes: [("screw", axes[0])],
    "universal": lambda axes: [("turn", axis) for axis in axes],
    "ball": lambda axes: [("turn", axis) for axis in axes],
    "planar": lambda axes: [("way", axes[0] % 3 + 1), ("way", (axes[0] + 1) % 3 + 1), ("turn", axes[0])],
    "weld": lambda axes: [],
    "free": lambda axes: [("way", 1), ("way", 2), ("way", 3)] + [("turn", axis) for axis in axes],
}
EULER = [("parameter", None)] * 4


def write_joints(tables):
    """Frames, points, coordinates and speeds of what carries; returned is what closes loops."""
    joints = tables.pop("joints", {})
    if not joints:
        return []
    inertial = tables["inertial"]
    sections = {name: tables.setdefault(name, {}) for name in ("coordinates", "speeds", "frames", "points")}
    bodies, carrier = tables.get("bodies", {}), {}
    stated = {"frames": set(sections["frames"]), "points": set(sections["points"])}
    for name, body in bodies.items():
        body.setdefault("frame", f"{name}_frame")
        body.setdefault("centre", f"{name}_centre")
    closing, bases = [], {}
    for name, joint in joints.items():
        closes = joint["body"] in carrier or bodies[joint["body"]]["frame"] in stated["frames"]
        closing += [name] * closes
        carrier.setdefault(joint["body"], name)
    for name, joint in joints.items():
        body, below = bodies[joint["body"]], bodies.get(joint.get("to", ""))
        frame = below["frame"] if below else inertial["frame"]
        home = inertial["origin"] if not below else carrier.get(joint["to"], below["centre"])
        base = frame
        along = [("towards", joint["axis"])] if isinstance(joint.get("axis"), list) else []
        if "turned" in joint or along:
            base = f"{name}_base"
            before = joint.get("turned", {"sequence": "", "angles": []})
            sections["frames"][base] = {"from": frame, "turns": simple_turns(before) + along}
        at = joint.get("at", [0, 0, 0])
        start, at = (at, [0, 0, 0]) if isinstance(at, str) else (home, at)
        if name in closing:
            bases[name] = base, f"{name}_closed_base" if "body_turned" in joint else body["frame"]
            sections["points"][name] = {"from": start, "frame": frame, "position": at}
            if "body_turned" in joint:
                sections["frames"][f"{name}_closed_base"] = {"from": body["frame"], **joint["body_turned"]}
            at = joint.get("body_at", [0, 0, 0])
            start, at = (at, [0, 0, 0]) if isinstance(at, str) else (carrier[joint["body"]], at)
            sections["points"][f"{name}_closed"] = {"from": start, "frame": body["frame"], "position": at}
            continue
        if joint.get("sequence") == "euler":
            axes = []
        elif along:
            axes = [3]
        elif joint["kind"] in ("universal", "ball", "free"):
            default = [1, 2] if joint["kind"] == "universal" else "123"
            axes = [int(axis) for axis in joint.get("axes", joint.get("sequence", default))]
        else:
            axes = [joint.get("axis", 3)]
        freedoms = KINDS[joint["kind"]](axes) + EULER * (joint.get("sequence") == "euler")
        one = len(freedoms) == 1
        names = joint.get("coordinates", [f"q_{name}" + ("" if one else f"_{at + 1}") for at in range(len(freedoms))])
        way, turns = ["0", "0", "0"], []
        for q, (what, axis) in zip(names, freedoms):
            sections["coordinates"][q] = {"unit": "m" if what == "way" else "rad"}
            if what == "way":
                way[axis - 1] = q
            if what == "screw":
                way[axis - 1] = f"({joint['lead']})*{q}/(2*pi)"
            if what in ("turn", "screw"):
                turns.append((axis, q))
        if len(axes) == 0 and "sequence" in joint:
            turns = [("euler", names[-4:])]
        write_speeds(sections["speeds"], name, joint, names, turns)
        back = [("back", vector) for _, vector in along]
        sections["frames"][body["frame"]] = {"from": base, "turns": (turns or [(3, "0")]) + back}
        on = f"{name}_on"
        sections["points"][on] = {"from": start, "frame": frame, "position": at}
        sections["points"][name] = {"from": on, "frame": base, "position": way}
        if body["centre"] not in stated["points"]:
            sections["points"][body["centre"]] = {
                "from": name,
                "frame": body["frame"],
                "position": joint.get("centre", [0, 0, 0]),
            }


    return [(name, joints[name], bases[name]) for name in closing]


class Places:
    """Where frames and points are: rotation matrices and places in the inertial frame, by formulas of the coordinates."""

    def __init__(self, tables):
        inertial = tables["inertial"]
        self.tables = tables
        self.names = {q: Symbol(q) for section in ("parameters", "coordinates") for q in tables.get(section, {})}
        self.turned, self.placed = {inertial["frame"]: Matrix.eye(3)}, {inertial["origin"]: Matrix([0, 0, 0])}

    def turn(self, frame):
        if frame not in self.turned:
            entry = self.tables["frames"][frame]
            self.turned[frame] = self.turn(entry["from"]) * turn_matrix(entry, self.names)
        return self.turned[frame]

    def parting(self, first, second):
        """The nearest frame from which both are turned."""
        above = [first]
        while above[-1] in self.tables["frames"]:
            above.append(self.tables["frames"][above[-1]]["from"])
        while second not in above:
            second = self.tables["frames"][second]["from"]
        return second

    def place(self, point):
        if point not in self.placed:
            entry = self.tables["points"][point]
            way = Matrix([expression(str(formula), self.names) for formula in entry["position"]])
            self.placed[point] = self.place(entry["from"]) + self.turn(entry["frame"]) * way
        return self.placed[point]


def write_positions(tables):
    """Components of places in constraints, `p(Q) @ N [3]`, as formulas."""
    places = Places(tables)

    def formula(found):
        point, frame, axis = found.groups()
        return f"({text((places.turn(frame).T * places.place(point))[int(axis) - 1])})"

    for name, entry in tables.get("constraints", {}).items():
        equation = re.sub(r"\bp\((\w+)\) @ (\w+) \[([123])\]", formula, entry["equation"])
        tables["constraints"][name] = entry | {"equation": equation}


def write_closing(tables, closing):
    """The equations of joints that close loops, by components in the frame of the joint."""
    places = Places(tables)
    for name, joint, (base, frame) in closing:
        kind, axis = joint["kind"], joint.get("axis", 3) - 1
        across = [(axis + 1) % 3, (axis + 2) % 3]
        first, second = (each - 1 for each in joint.get("axes", [1, 2]))
        ways, right = {
            "pin": ([0, 1, 2], [(axis, i) for i in across]),
            "ball": ([0, 1, 2], []),
            "universal": ([0, 1, 2], [(second, first)]),
            "slider": (across, [(0, 1), (1, 2), (2, 0)]),
            "cylinder": (across, [(axis, i) for i in across]),
            "planar": ([axis], [(axis, i) for i in across]),
            "weld": ([0, 1, 2], [(0, 1), (1, 2), (2, 0)]),
        }[kind]
        ground = tables["inertial"]["frame"]
        told = ground if len(ways) == 3 and places.parting(base, frame) == ground else base
        way = places.turn(told).T * (places.place(f"{name}_closed") - places.place(name))
        cosines = places.turn(frame).T * places.turn(base)
        equations = {f"{name}_{i + 1}": way[i] for i in ways}
        equations |= {f"{name}_turn{of + 1}{along + 1}": cosines[of, along] for of, along in right}
        for called, equation in equations.items():
            equation = trigsimp(expand(equation))
            if equation != 0:
                tables.setdefault("constraints", {})[called] = {"equation": f"{text(equation)} = 0"}


def write_speeds(section, name, joint, names, turns):
    """Rates, but components of the angular velocity relative to what carries for three turns."""
    by_parameters = joint.get("sequence") == "euler"
    default = [f"u{q[1:]}" if q.startswith("q") else f"u_{q}" for q in names]
    if by_parameters:
        default = [f"u_{name}_{at + 1}" for at in range(len(names) - 1)]
    speeds = joint.get("speeds", default)
    if not speeds:
        return
    formulas = [f"{q}'" for q in names]
    if by_parameters:
        # Twice the conjugate of a quaternion times its rate, over its square.
        whole, rate = Quaternion(*(Symbol(q) for q in names[-4:])), Quaternion(*(Symbol(f"{q}'") for q in names[-4:]))
        spin = whole.conjugate() * rate
        length = sum(Symbol(q) ** 2 for q in names[-4:])
        formulas[-4:] = [text(2 * part / length) for part in (spin.b, spin.c, spin.d)]
    elif joint["kind"] in ("ball", "free"):
        angles = dynamicsymbols([q for _, q in turns])
        below, frame = ReferenceFrame("below"), ReferenceFrame("frame")
        frame.orient_body_fixed(below, angles, "".join(str(axis) for axis, _ in turns))
        formulas[-3:] = [text(e) for e in frame.ang_vel_in(below).to_matrix(frame)]
    section |= dict(zip(speeds, formulas))


def simple_turns(entry):
    """(axis, angle) of each turn of a sequence, in the order in which they lead to the frame."""
    turns = [(int(axis), angle) for axis, angle in zip(entry["sequence"], entry["angles"], strict=True)]
    return turns[::-1] if entry.get("fixed") == "space" else turns


def direction(components, names):
    vector = Matrix([expression(str(component), names) for component in components])
    return vector / sqrt(vector.dot(vector))


def turn_matrix(entry, names):
    """The matrix that takes components in a frame to those in the frame from which it is turned."""
    if "euler_parameters" in entry:
        return Quaternion(*(expression(str(q), names) for q in entry["euler_parameters"])).to_rotation_matrix()
    for key in ("towards", "back"):
        if key in entry:
            vector = direction(entry[key], names)
            if vector[2] == -1:
                return Matrix.diag(1, -1, -1)
            # Half a turn about the axis, then half a turn about what halves the way to the vector.
            between = vector + Matrix([0, 0, 1])
            half = 2 * between * between.T / between.dot(between) - Matrix.eye(3)
            matrix = (half * Matrix.diag(-1, -1, 1)).applyfunc(radsimp)
            return matrix.T if key == "back" else matrix
    about = (rot_ccw_axis1, rot_ccw_axis2, rot_ccw_axis3)[entry["axis"] - 1]
    return about(expression(str(entry["angle"]), names))


def write_sequences(tables):
    """A frame by several turns as a frame for each."""
    frames = {}
    for name, entry in tables.get("frames", {}).items():
        if "sequence" in entry:
            turns = simple_turns(entry)
        elif isinstance(entry.get("axis"), list):
            turns = [("towards", entry["axis"]), (3, entry["angle"]), ("back", entry["axis"])]
        elif "turns" in entry:
            turns = entry["turns"]
        else:
            frames[name] = entry
            continue
        parent = entry["from"]
        for at, (axis, angle) in enumerate(turns):
            inner = name if at + 1 == len(turns) else f"{name}_turn{at + 1}"
            key = "euler_parameters" if axis == "euler" else axis
            by = {"axis": axis, "angle": angle} if isinstance(axis, int) else {key: angle}
            frames[inner] = {"from": parent} | by
            parent = inner
    if frames:
        tables["frames"] = frames


def write_norms(tables):
    """Euler parameters have length 1."""
    for name, entry in tables.get("frames", {}).items():
        if "euler_parameters" in entry:
            squares = " + ".join(f"({q})^2" for q in entry["euler_parameters"])
            tables.setdefault("constraints", {})[f"{name}_norm"] = {"equation": f"{squares} = 1"}


def write_friction(tables):
    """Friction as forces and torques that name velocities."""
    for name, entry in tables.pop("friction", {}).items():
        on, against = entry["on"], entry.get("against")
        frame = entry.get("frame", tables["inertial"]["frame"])
        axes = [entry["axis"]] if "torque" in entry else [axis for axis in (1, 2, 3) if axis != entry.get("normal")]
        if "torque" in entry:
            velocity = lambda body, axis: f"omega({body}) @ {frame} [{axis}]"
        else:
            particle = tables.get("particles", {}).get(on)
            point = particle["point"] if particle else entry.get("at", tables.get("bodies", {}).get(on, {}).get("centre"))
            velocity = lambda body, axis: f"v({body}, {point}) @ {frame} [{axis}]"
        slip = {axis: f"({velocity(on, axis)}" + (f" - {velocity(against, axis)}" if against else "") + ")" for axis in axes}
        square = "(" + " + ".join(f"{s}^2" for s in slip.values()) + ")"
        load = f"*({entry['normal_force']})" if "normal_force" in entry else ""
        sliding = str(entry.get("torque", entry.get("coefficient")))
        resistance = f"({sliding}){load}"
        if "static" in entry:
            resistance = f"(({sliding}) + (({entry['static']}) - ({sliding}))*exp(-{square}/({entry['stribeck']})^2)){load}"
        vector = ["0", "0", "0"]
        for axis, s in slip.items():
            vector[axis - 1] = f"-{resistance}*{s}/sqrt({square} + ({entry['smoothing']})^2)"
        written = {"on": on, "frame": frame, "vector": vector} | ({"against": against} if against else {})
        if "torque" in entry:
            tables.setdefault("torques", {})[name] = written
            continue
        if not particle and "at" in entry:
            written["at"] = entry["at"]
        if against:
            written["against_at"] = point
        tables.setdefault("forces", {})[name] = written


def write_potentials(tables):
    """Potentials as tables, each with its formula."""
    for name, entry in tables.get("potentials", {}).items():
        if not isinstance(entry, dict):
            tables["potentials"][name] = {"value": entry}


def write_planar(tables):
    """One moment of inertia, about the axis that the body turns about."""
    for body in tables.get("bodies", {}).values():
        moment = body.get("inertia")
        if isinstance(moment, (str, int, Fraction)):
            axis, frame = 3, tables.get("frames", {}).get(body["frame"])
            while frame:
                if re.search(r"[A-Za-z]", str(frame.get("angle", ""))):
                    axis = frame["axis"]
                    break
                frame = tables["frames"].get(frame["from"])
            plate = [f"({moment})/2"] * 3
            plate[axis - 1] = moment
            body["inertia"] = {"diagonal": plate}
