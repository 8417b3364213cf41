"""Arms as the tables that other programs make their models of, read from model files: a chain of turns and places, each body on its
own frame."""

import math
import tomllib

import build

MODELS = build.ROOT / "benches/models"


def model(name):
    return tomllib.loads((MODELS / f"{name}.toml").read_text())


def joints(name):
    """(gravity, a row for each joint: axis, place and rotation on the link before, mass, mass centre, inertia) in numbers."""
    file = model(name)
    values = {key: one["value"] for key, one in file["parameters"].items()}
    rows, points, ground = [], file["points"], file["inertial"]["frame"]
    # The frame of the body that each frame is fixed on, and its axes there as columns.
    homes = {ground: (ground, identity())}
    for frame, turn in file["frames"].items():
        home, fixed = homes[turn["from"]]
        if turn["angle"] not in file["coordinates"]:
            homes[frame] = (home, times(fixed, rotation(turn["axis"], number(turn["angle"], {"pi": math.pi}))))
            continue
        body = next(one for one in file["bodies"].values() if one["frame"] == frame)
        centre = points[body["centre"]]
        place = points[centre["from"]]["position"]
        inertia = body["inertia"]
        entries = [*inertia["diagonal"], *inertia["products"]]
        rows.append(
            [turn["axis"], *(number(x, values) for x in place), *(x for row in fixed for x in row), number(body["mass"], values)]
            + [number(x, values) for x in [*centre["position"], *entries]]
        )
        homes[frame] = (frame, identity())
    return [number(x, values) for x in file["gravity"]["acceleration"]], rows


def number(formula, values):
    """A number, a name, its negative, or a half of it: no more is needed here."""
    if not isinstance(formula, str):
        return float(formula)
    sign, word = (-1.0, formula[1:]) if formula.startswith("-") else (1.0, formula)
    name, _, divisor = word.partition("/")
    return sign * values[name] / float(divisor or 1)


def parameters(name):
    return [one["value"] for one in model(name)["parameters"].values()]


def identity():
    return [[float(i == j) for j in range(3)] for i in range(3)]


def rotation(axis, angle):
    """The axes of the turned frame as columns."""
    s, c = round(math.sin(angle), 15), round(math.cos(angle), 15)
    j, k = axis % 3, (axis + 1) % 3
    matrix = identity()
    matrix[j][j] = matrix[k][k] = c
    matrix[j][k], matrix[k][j] = -s, s
    return matrix


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
