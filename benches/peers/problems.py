"""What all are asked: the disk, and a cart with a chain of n links, as model files, parameters and states.

A state is the coordinates, then their rates. Spread states are a low-discrepancy sequence about a start: the additive recurrence
of the generalized golden ratio (M. Roberts, 2018), the same doubles on every machine.
"""

import math
import struct
import tomllib

import build

SCENE = build.ROOT / "models/disk/scenes/report-10s.toml"
FOLDER = build.PLACE / "problems"
# How far from its start each number of a state is spread, to either side, when right-hand sides are called.
WIDTH = 1.0
# The same for whole runs of the disk: each angle and each rate, so that every one passes as near to the flat disk as the report's.
RUN_WIDTHS = [0.5, 0.01, 0.5, 1.0, 1.0, 0.005, 0.02, 0.01, 0.2, 0.05]


def chain(links):
    """The name of the problem with so many links."""
    return f"chain_{links}"


def links(problem):
    return int(problem.removeprefix("chain_")) if problem.startswith("chain_") else None


def model_text(problem):
    n = links(problem)
    return chain_text(n) if n else (build.ROOT / "models/disk/model.toml").read_text()


def chain_text(n):
    """The model of models/cart_pendulum_3 with n links: point masses, angles from upright, a force on the cart."""
    tables = {
        "parameters": [f'm{i} = {{ unit = "kg", positive = true }}' for i in range(n + 1)]
        + [f'l{i} = {{ unit = "m", positive = true }}' for i in range(n)]
        + ['g = { unit = "m/s^2", positive = true }', 'F = { unit = "N" }'],
        "coordinates": ['q0 = { unit = "m" }'] + [f'q{i} = {{ unit = "rad" }}' for i in range(1, n + 1)],
        "speeds": [f'u{i} = "q{i}\'"' for i in range(n + 1)],
        "inertial": ['frame = "N"', 'origin = "O"'],
        "frames": [f'B{i} = {{ from = "N", axis = 3, angle = "q{i}" }}' for i in range(1, n + 1)],
        "points": ['P0 = { from = "O", frame = "N", position = ["q0", 0, 0] }']
        + [f'P{i} = {{ from = "P{i - 1}", frame = "B{i}", position = [0, "l{i - 1}", 0] }}' for i in range(1, n + 1)],
        "particles": [f'bob{i} = {{ point = "P{i}", mass = "m{i}" }}' for i in range(n + 1)],
        "gravity": ['frame = "N"', 'acceleration = [0, "-g", 0]'],
        "forces.drive": ['on = "bob0"', 'frame = "N"', 'vector = ["F", 0, 0]'],
        "reactions.rail": ['on = "bob0"', 'frame = "N"', "direction = [0, 1, 0]"],
    }
    for i in range(1, n + 1):
        thrust = [f'on = "bob{i}"', f'against = "bob{i - 1}"', f'frame = "B{i}"', "direction = [0, 1, 0]"]
        tables[f"reactions.T{i}"] = thrust
    head = f'name = "Cart with a chain of {n} links"\nsource = "SymPy physics/mechanics/models.py, n_link_pendulum_on_cart"\n'
    return head + "".join(f"\n[{name}]\n" + "\n".join(lines) + "\n" for name, lines in tables.items())


def parameters(problem):
    """In the order of the model file."""
    if n := links(problem):
        masses = [1 + 0.5 * math.sin(i) for i in range(n + 1)]
        lengths = [0.5 + 0.2 * math.cos(i) for i in range(n)]
        return [*masses, *lengths, 9.81, 2.75]
    return [scene()["parameters"][name] for name in ("M", "R", "g")]


def start(problem):
    if n := links(problem):
        return [0.0] + [0.3 + 0.9 * math.sin(2 * i) for i in range(n)] + [0.1] + [math.cos(3 * i) for i in range(n)]
    names = [f"q{i}" for i in range(1, 6)]
    start = scene()["start"]
    return [number(start[name]) for name in names + [f"{name}'" for name in names]]


def scene():
    scene = tomllib.loads(SCENE.read_text())
    if scene["span"] != [0, 10]:
        raise SystemExit("the scene no longer runs from 0 to 10 s, as the workers do")
    return scene


def number(value):
    """A number of a scene, or one in degrees."""
    return math.radians(float(value.removesuffix("*deg"))) if isinstance(value, str) else value


def spread(about, widths, count):
    """`count` states about one, the first being that one."""
    ratio = 2.0
    for _ in range(100):
        ratio = (1 + ratio) ** (1 / (len(about) + 1))
    strides = [ratio ** -(i + 1) for i in range(len(about))]
    shifted = lambda k, i: 2 * ((0.5 + k * strides[i]) % 1.0) - 1  # 0 for k = 0
    return [[x + widths[i] * shifted(k, i) for i, x in enumerate(about)] for k in range(count)]


def write(problem, count=128):
    """The model file and a file of states, for workers: the parameters in a line, then a line for each state."""
    folder = FOLDER / problem
    folder.mkdir(parents=True, exist_ok=True)
    about = start(problem)
    lines = [parameters(problem), *spread(about, [WIDTH] * len(about), count)]
    build.write_text(folder / "states", "".join(" ".join(map(repr, line)) + "\n" for line in lines))
    build.write_text(folder / "model.toml", model_text(problem))
    return folder


def write_starts(count):
    """Starts of whole runs of the disk, as doubles one after the other."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / f"starts-{count}"
    numbers = [x for state in spread(start("disk"), RUN_WIDTHS, count) for x in state]
    path.write_bytes(struct.pack(f"={len(numbers)}d", *numbers))
    return path
