"""Mechanisms of any length: planar links with point masses, their angles from one frame or from the link before, and arms with full
inertias, made as benches/models/arm6.toml is.

A problem is FAMILY_LENGTH; in all of them the coordinates are angles and the speeds their rates. `links` says the same as tables, for
tools that make their models of these.
"""

import math

FAMILIES = {
    "absolute": "planar links, angles from one frame",
    "relative": "planar links, angles from the link before",
    "arm": "arms, full inertias",
}
# The axes of an arm's joints, again from the beginning after six.
AXES = (3, 2, 2, 1, 2, 1)


def split(problem):
    """The family and the length of a problem."""
    family, length = problem.split("_")
    return family, int(length)


def values(problem):
    """The parameters by name, in the order of the model file."""
    family, n = split(problem)
    numbers = {"g": 9.81}
    for i in range(1, n + 1):
        if family != "arm":
            numbers |= {f"m{i}": 1 + 0.5 * math.sin(i), f"l{i}": 0.5 + 0.2 * math.cos(i)}
            continue
        numbers[f"m{i}"] = 1 + 0.1 * i
        numbers |= {f"c{axis}{i}": 0.05 * (i % 7) + 0.01 * k for k, axis in enumerate("xyz")}
        numbers |= {f"l{axis}{i}": 0.2 + 0.03 * (i % 7) + 0.02 * k for k, axis in enumerate("xyz")}
        numbers |= {f"I{axis}{axis}{i}": 0.3 + 0.01 * i + 0.02 * k for k, axis in enumerate("xyz")}
        numbers |= {f"I{pair}{i}": 0.01 + 0.001 * i + 0.002 * k for k, pair in enumerate(("xy", "yz", "zx"))}
    return numbers


def start(problem):
    """Angles, then rates."""
    _, n = split(problem)
    return [0.3 + 0.9 * math.sin(2 * i) for i in range(n)] + [math.cos(3 * i) for i in range(n)]


def model_text(problem):
    family, n = split(problem)
    each = range(1, n + 1)
    is_arm = family == "arm"
    before = lambda i: f"A{i - 1}" if i > 1 else "N"
    frame = lambda i: before(i) if family != "absolute" else "N"
    axis = lambda i: AXES[(i - 1) % len(AXES)] if is_arm else 3
    tables = {
        "parameters": [parameter(name, value) for name, value in values(problem).items()],
        "coordinates": [f'q{i} = {{ unit = "rad" }}' for i in each],
        "speeds": [f"u{i} = \"q{i}'\"" for i in each],
        "inertial": ['frame = "N"', 'origin = "O"'],
        "frames": [f'A{i} = {{ from = "{frame(i)}", axis = {axis(i)}, angle = "q{i}" }}' for i in each],
        "points": [line for i in each for line in points(is_arm, i, before(i))],
    }
    if is_arm:
        tables["bodies"] = [body(i) for i in each]
    else:
        tables["particles"] = [f'bob{i} = {{ point = "P{i}", mass = "m{i}" }}' for i in each]
    tables["gravity"] = ['frame = "N"', f'acceleration = {[0, 0, "-g"] if is_arm else [0, "-g", 0]}'.replace("'", '"')]
    head = f'name = "{FAMILIES[family].capitalize()}, {n}"\n'
    return head + "".join(f"\n[{name}]\n" + "\n".join(lines) + "\n" for name, lines in tables.items())


def parameter(name, value):
    units = {"g": "m/s^2", "m": "kg", "I": "kg*m^2"}
    positive = ", positive = true" if not (name[0] == "I" and name[1] != name[2]) and name[0] not in "c" else ""
    return f'{name} = {{ unit = "{units.get(name[0], "m")}", value = {value!r}{positive} }}'


def points(is_arm, i, before):
    last = f"P{i - 1}" if i > 1 else "O"
    if not is_arm:
        yield f'P{i} = {{ from = "{last}", frame = "A{i}", position = [0, "-l{i}", 0] }}'
        return
    yield f'P{i} = {{ from = "{last}", frame = "{before}", position = ["lx{i}", "ly{i}", "lz{i}"] }}'
    yield f'C{i} = {{ from = "P{i}", frame = "A{i}", position = ["cx{i}", "cy{i}", "cz{i}"] }}'


def body(i):
    inertia = f'frame = "A{i}", diagonal = ["Ixx{i}", "Iyy{i}", "Izz{i}"], products = ["Ixy{i}", "Iyz{i}", "Izx{i}"]'
    return f'link{i} = {{ frame = "A{i}", centre = "C{i}", mass = "m{i}", inertia = {{ {inertia} }} }}'


def links(problem, p):
    """A row for each link, its numbers from the parameters `p` by name: the axis of its joint, the place of the joint on the link before,
    mass, mass centre, and the inertia about that, xx yy zz xy yz zx; then the acceleration that gravity gives."""
    family, n = split(problem)
    rows = []
    for i in range(1, n + 1):
        if family == "arm":
            place, centre = ([p[f"{letter}{axis}{i}"] for axis in "xyz"] for letter in "lc")
            inertia = [p[f"I{pair}{i}"] for pair in ("xx", "yy", "zz", "xy", "yz", "zx")]
            rows.append((AXES[(i - 1) % len(AXES)], place, p[f"m{i}"], centre, inertia))
        else:
            place = [0, -p[f"l{i - 1}"], 0] if i > 1 else [0, 0, 0]
            rows.append((3, place, p[f"m{i}"], [0, -p[f"l{i}"], 0], [0] * 6))
    return rows, [0, 0, -p["g"]] if family == "arm" else [0, -p["g"], 0]
