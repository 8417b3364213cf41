"""Scenes with contacts whose motion has a closed form: bounces, walls, sliding, and slip that turns into rolling."""
import math, os
from mechanisms import write
from verdict import Outcome

PARTICLE = """name = "Particle"

[parameters]
m = {{ unit = "kg", value = {m} }}
g = {{ unit = "m/s^2", value = {g} }}

[coordinates]
x = {{ unit = "m" }}
z = {{ unit = "m" }}

[speeds]
u = "x'"
w = "{speed}"

[inertial]
frame = "N"
origin = "O"

[points]
P = {{ from = "O", frame = "N", position = ["x", 0, "z"] }}

[particles]
p = {{ point = "P", mass = "m" }}

[gravity]
frame = "N"
acceleration = [{gx}, 0, "-g"]
"""

DISC = """name = "Disc in a plane"

[parameters]
m = {{ unit = "kg", value = {m} }}
g = {{ unit = "m/s^2", value = {g} }}
R = {{ unit = "m", value = {R} }}
J = {{ unit = "kg*m^2", value = {J} }}

[coordinates]
x = {{ unit = "m" }}
z = {{ unit = "m" }}
q = {{ unit = "rad" }}

[speeds]
u = "x'"
w = "z'"
o = "q'"

[inertial]
frame = "N"
origin = "O"

[frames]
B = {{ from = "N", axis = 2, angle = "q" }}

[points]
C = {{ from = "O", frame = "N", position = ["x", 0, "z"] }}
K = {{ from = "C", frame = "N", position = [0, 0, "-R"] }}

[bodies]
disc = {{ frame = "B", centre = "C", mass = "m", inertia = {{ diagonal = ["J/2", "J", "J/2"] }} }}

[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"""


class Scene:
    """A scene with contacts: texts, and the truth as (printed name, value) and instants of impacts."""
    def __init__(self, model, start, span, contacts, truth, instants=None, losses=None):
        self.model, self.start, self.span, self.contacts = model, start, span, contacts
        self.truth, self.instants, self.losses = truth, instants, losses


def value(r, low, high):
    return round(r.uniform(low, high), 3)


def bouncing(r):
    """A particle that bounces on a floor while it moves sideways; without friction."""
    m, g, e = value(r, 0.2, 3), value(r, 3, 15), r.choice([1.0, 0.9, 0.7, 0.5, 0.0])
    x, z, u, w, end = value(r, -1, 1), value(r, 0.3, 2), value(r, -2, 2), value(r, -1, 2), value(r, 0.5, 2.5)
    t, height, speed, instants, losses = 0.0, z, w, [], []
    while True:
        flight = (speed + math.sqrt(speed * speed + 2 * g * height)) / g
        if t + flight > end or len(instants) > 40:
            break
        t += flight
        down = g * flight - speed
        instants.append(t)
        losses.append(m * down * down * (1 - e * e) / 2)
        height, speed = 0.0, e * down
        if speed == 0:
            break
    if len(instants) > 40 or any(abs(end - i) < 1e-3 for i in instants):
        return None
    left = end - t
    rest = bool(instants) and e == 0
    z_end = 0.0 if rest else height + speed * left - g * left * left / 2
    w_end = 0.0 if rest else speed - g * left
    return Scene(PARTICLE.format(m=m, g=g, gx=0, speed="z'"), dict(x=x, z=z, u=u, w=w), end,
                 {"floor": {"gap": "p(P) @ N [3]", "restitution": e}},
                 {"x": x + u * end, "z": z_end, "u": u, "w": w_end}, instants, losses)


def walls(r):
    """A particle between two walls, without gravity along its way."""
    m, g, e = value(r, 0.2, 3), 0.0, r.choice([1.0, 0.8, 0.6])
    a, b, u, end = value(r, -2, -0.5), value(r, 0.5, 2), value(r, 2, 6), value(r, 0.5, 2.5)
    x, speed, t, instants, losses = 0.0, u * r.choice([1, -1]), 0.0, [], []
    u = speed
    while True:
        flight = ((b if speed > 0 else a) - x) / speed
        if t + flight > end:
            break
        t, x = t + flight, b if speed > 0 else a
        instants.append(t)
        losses.append(m * speed * speed * (1 - e * e) / 2)
        speed = -e * speed
    if any(abs(end - i) < 1e-3 for i in instants):
        return None
    w = value(r, -1, 1)
    return Scene(PARTICLE.format(m=m, g=g, gx=0, speed="z'"), dict(x=0.0, z=0.5, u=u, w=w), end,
                 {"left": {"gap": f"p(P) @ N [1] - ({a})", "restitution": e},
                  "right": {"gap": f"{b} - p(P) @ N [1]", "restitution": e}},
                 {"x": x + speed * (end - t), "u": speed, "z": 0.5 + w * end}, instants, losses)


def sliding(r):
    """A block on a floor with Coulomb friction and a sideways field: it slips, then sticks or slips back."""
    m, g, mu = value(r, 0.2, 3), value(r, 5, 12), value(r, 0.1, 0.6)
    field = r.choice([0.0, value(r, 0.0, 5)])
    u, end = value(r, 0.5, 4) * r.choice([1, -1]), value(r, 0.5, 2.5)
    s = math.copysign(1, u)
    a = field - s * mu * g
    stop = -u / a if a * s < 0 else math.inf
    if abs(stop - end) < 1e-2 or abs(field - mu * g) < 0.05:
        return None
    if stop > end:
        x, v = u * end + a * end * end / 2, u + a * end
    else:
        x, v = u * stop + a * stop * stop / 2, 0.0
        if field > mu * g:
            left, a = end - stop, field - mu * g
            x, v = x + a * left * left / 2, a * left
    return Scene(PARTICLE.format(m=m, g=g, gx=f'"{field} m/s^2"', speed="z'"), dict(x=0.0, z=0.0, u=u, w=0.0), end,
                 {"floor": {"gap": "p(P) @ N [3]", "restitution": 0, "friction": mu, "along": "v(P) @ N [1]"}},
                 {"x": x, "u": v, "z": 0.0})


def rolling(r):
    """A disc that is thrown along a floor, slips and then rolls."""
    m, g, radius, mu = value(r, 0.2, 3), value(r, 5, 12), value(r, 0.1, 0.8), value(r, 0.05, 0.5)
    J = round(m * radius**2 * r.choice([0.5, 0.4, 1.0, r.uniform(0.2, 1)]), 6) or 1e-6
    u, o, end = value(r, -3, 3), value(r, -4, 4), value(r, 0.3, 2.0)
    # The material at the contact moves with u − o R: a turn about axis 2 moves the lowest point along −axis 1.
    slip = u - o * radius
    s = math.copysign(1, slip)
    a, alpha = -s * mu * g, s * mu * m * g * radius / J
    stop = abs(slip) / (mu * g * (1 + m * radius**2 / J))
    if abs(slip) < 0.05 or abs(stop - end) < 1e-2:
        return None
    t = min(stop, end)
    x, q, v, w = u * t + a * t * t / 2, o * t + alpha * t * t / 2, u + a * t, o + alpha * t
    x, q = x + v * (end - t), q + w * (end - t)
    return Scene(DISC.format(m=m, g=g, R=radius, J=J), dict(x=0.0, z=radius, q=0.0, u=u, w=0.0, o=o), end,
                 {"floor": {"gap": "p(C) @ N [3] - R", "restitution": 0, "friction": mu,
                            "along": "v(disc, K) @ N [1]"}},
                 {"x": x, "q": q, "u": v, "o": w})


def spinning(r):
    """A disc with spin that hits a floor once: the impact sticks or slips (Newton's law, Coulomb's friction)."""
    m, g, radius, mu = value(r, 0.2, 3), value(r, 5, 12), value(r, 0.1, 0.5), value(r, 0.02, 0.8)
    e = r.choice([0.9, 0.6, 0.3])
    J = round(m * radius**2 * r.choice([0.5, 0.4, 1.0]), 6) or 1e-6
    u, o, w, height = value(r, -3, 3), value(r, -9, 9), value(r, -2, 0), value(r, 0.3, 1)
    down = math.sqrt(w * w + 2 * g * height)
    hit = (down + w) / g
    end = hit + min(0.3, 0.8 * 2 * e * down / g)
    push = m * (1 + e) * down
    slip = u - o * radius
    stick = -slip / (1 / m + radius**2 / J)
    if abs(abs(stick) - mu * push) < 1e-3:
        return None
    along = stick if abs(stick) < mu * push else -math.copysign(mu * push, slip)
    v, spin = u + along / m, o - along * radius / J
    left = end - hit
    loss = (m * (u * u + down * down) + J * o * o - m * (v * v + (e * down)**2) - J * spin * spin) / 2
    if loss < 0:
        return None
    return Scene(DISC.format(m=m, g=g, R=radius, J=J), dict(x=0.0, z=radius + height, q=0.0, u=u, w=w, o=o), end,
                 {"floor": {"gap": "p(C) @ N [3] - R", "restitution": e, "friction": mu,
                            "along": "v(disc, K) @ N [1]"}},
                 {"x": u * hit + v * left, "u": v, "o": spin, "q": o * hit + spin * left,
                  "z": radius + e * down * left - g * left**2 / 2, "w": e * down - g * left}, [hit], [loss])


def judge(random, program, folder, ask, compare, wrong):
    """A random scene of this file against its closed form."""
    scene = None
    while scene is None:
        make = random.choice([bouncing, walls, sliding, rolling, spinning])
        scene = make(random)
    r = random
    lines = ['model = "model.toml"', f"span = [0, {scene.span!r}]", "", "[start]",
             *(f"{k} = {v!r}" for k, v in scene.start.items()), ""]
    for name, entry in scene.contacts.items():
        lines += [f"[impacts.{name}]", *(f"{k} = {v!r}".replace("'", '"') for k, v in entry.items())]
        if r.random() < 0.2 and len(scene.contacts) == 1 and make is bouncing:
            lines.append('law = "poisson"')
        lines.append("")
    lines += ["[integration]", f'method = "{r.choice(["ode45", "dop853", "dopri5", "taylor", "radau5"])}"',
              f"rtol = {r.choice([1e-4, 1e-6, 1e-9])}"]
    write(os.path.join(folder, "model.toml"), scene.model)
    path = os.path.join(folder, "scene.toml")
    write(path, "\n".join(lines) + "\n")
    answer = ask(program, path)
    numbers = 0
    for name, truth in scene.truth.items():
        numbers += 1
        compare(wrong, name, answer["state"].get(name), answer["uncertainty"].get(name), truth, 1e-12, 10.0)
    if scene.instants is not None:
        printed = [i for i in answer["impacts"] if i["t"] > 0]
        if len(printed) != len(scene.instants):
            wrong.append(f"{len(printed)} impacts are printed, {len(scene.instants)} are right")
        else:
            for impact, t, loss in zip(printed, scene.instants, scene.losses):
                numbers += 2
                compare(wrong, "instant of an impact", impact["t"], impact["uncertainty"], t, 1e-12, 1.0)
                if abs(impact["loss"] - loss) > 1e-3 * (loss + 1e-9) and not answer["warnings"]:
                    wrong.append(f"loss of an impact: printed {impact['loss']!r}, right {loss!r}")
    if wrong and not answer["warnings"]:
        return Outcome("wrong", f"{make.__name__}: " + "; ".join(wrong[:3]), numbers)
    return Outcome("right", "outside its stated error, with a warning" if wrong else "", numbers)
