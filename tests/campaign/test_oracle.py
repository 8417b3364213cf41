"""Tests of the oracle against motions and accelerations that textbooks state. Plain asserts; runs in a few seconds."""
import math, os, sys
import numpy as np
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import expressions
import random
from formula import evaluate, Numbers, quantity
from jets import Jet, DERIVATIVES, function
from mechanism import Mechanism
from motion import Motion
from notation import Notation
from oracle import closed, equations, permitted
from reactions import Reactions
from rewriting import equal_form
from verdict import upper_bound

HEAD = '''
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
'''
PENDULUM = '''name = "Pendulum"
[parameters]
m = { unit = "kg", value = 2 }
l = { unit = "m", value = 1.5 }
J = { unit = "kg*m^2", value = 0.3 }
g = { unit = "m/s^2", value = 9.81 }
''' + HEAD + '''
[bodies]
rod = { frame = "B", centre = "C", mass = "m", inertia = { diagonal = ["J", "J/2", "J"] } }
[joints]
pin = { kind = "pin", body = "rod", centre = [0, "-l", 0], coordinates = ["q"], speeds = ["u"] }
'''
DOUBLE = '''name = "Double pendulum"
[parameters]
m1 = { unit = "kg", value = 1.3 }
m2 = { unit = "kg", value = 0.7 }
l1 = { unit = "m", value = 0.9 }
l2 = { unit = "m", value = 0.6 }
g = { unit = "m/s^2", value = 9.81 }
[coordinates]
a = { unit = "rad" }
b = { unit = "rad" }
[speeds]
u1 = "a'"
u2 = "b' - a'"
''' + HEAD + '''
[frames]
A = { from = "N", axis = 3, angle = "a" }
B = { from = "N", axis = 3, angle = "b" }
[points]
P = { from = "O", frame = "A", position = [0, "-l1", 0] }
Q = { from = "P", frame = "B", position = [0, "-l2", 0] }
[particles]
p = { point = "P", mass = "m1" }
q = { point = "Q", mass = "m2" }
'''
TOP = '''name = "Body about a fixed point"
[parameters]
A = { unit = "kg*m^2", value = 0.4 }
C = { unit = "kg*m^2", value = 0.25 }
m = { unit = "kg", value = 1.1 }
l = { unit = "m", value = 0.5 }
g = { unit = "m/s^2", value = 9.81 }
''' + HEAD.replace('[0, "-g", 0]', '[0, 0, "-g"]') + '''
[bodies]
top = { frame = "B", centre = "S", mass = "m", inertia = { diagonal = ["A", "A", "C"] } }
[joints.tip]
kind = "ball"
body = "top"
sequence = "313"
centre = [0, 0, "l"]
coordinates = ["psi", "theta", "phi"]
speeds = ["w1", "w2", "w3"]
'''
SPINNER = TOP.replace('"A", "A", "C"', '"A", "2*A", "C"').replace('"313"', '"euler"').replace(
    'centre = [0, 0, "l"]\n', "").replace('"psi", "theta", "phi"', '"e0", "e1", "e2", "e3"')
MODELS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "models")
with open(os.path.join(MODELS, "rolling_disc", "model.toml")) as file:
    DISC = file.read()
CRANK = '''name = "Slider-crank"
[parameters]
r = { unit = "m", value = 0.2 }
l = { unit = "m", value = 0.7 }
g = { unit = "m/s^2", value = 9.81 }
w = { unit = "rad/s", value = 3 }
''' + HEAD + '''
[bodies]
crank = { mass = "1 kg", inertia = "0.01 kg*m^2", frame = "A", centre = "Ac" }
rod = { mass = "2 kg", inertia = "0.08 kg*m^2", frame = "B", centre = "Bc" }
piston = { mass = "3 kg", inertia = "0.02 kg*m^2", frame = "P", centre = "Pc" }
[joints]
O1 = { kind = "pin", body = "crank", coordinates = ["q1"], centre = ["r/2", 0, 0] }
O2 = { kind = "pin", body = "rod", to = "crank", at = ["r", 0, 0], coordinates = ["q2"], centre = ["l/2", 0, 0] }
O3 = { kind = "slider", body = "piston", axis = 1, coordinates = ["x"], speeds = ["u3"] }
O4 = { kind = "pin", body = "rod", to = "piston", body_at = ["l", 0, 0] }
[constraints]
motor = "q1 = w*t"
'''


def near(a, b, tolerance=1e-11):
    assert abs(a - b) <= tolerance * (1 + abs(b)), (a, b)


def test_jets():
    """Slopes of every function against differences."""
    for name in DERIVATIVES:
        x = Jet.variable(0.3, 0, 1, True)
        y, h = function(name, x), 1e-5
        f = [float(DERIVATIVES[name](0.3 + k * h)[0]) for k in (-1, 0, 1)]
        near(float(y.g[0]), (f[2] - f[0]) / (2 * h), 1e-7)
        near(float(y.h[0, 0]), (f[2] - 2 * f[1] + f[0]) / h**2, 1e-4)


def test_formulas():
    scope = Numbers({"a": 2.0, "b": 3.0})
    assert evaluate("-a^2 + 2^3^2/b*a", scope) == -4 + 512 / 3 * 2
    near(quantity("7.8 g/cm^3", scope), 7800.0)
    near(quantity("90 deg", scope), math.pi / 2)
    near(evaluate("1.5e-3*b - 2E+1", scope), 0.0045 - 20)


def test_pendulum():
    m = Mechanism(PENDULUM)
    eq = equations(m, {"q": 0.7}, {"q": 1.2})
    near(eq.accelerations[0], -2 * 9.81 * 1.5 * math.sin(0.7) / (0.3 + 2 * 1.5**2))
    near(eq.kinetic, (0.3 + 2 * 1.5**2) * 1.2**2 / 2)
    # Force of the pin along n2: m (g + acceleration of the middle).
    a, w = eq.accelerations[0], 1.2
    force = 2 * (9.81 + 1.5 * (a * math.sin(0.7) + w * w * math.cos(0.7)))
    near(Reactions(eq).component("force", None, "rod", 1), force)
    assert Reactions(eq).component("torque", None, "rod", 2) < 1e-9


def test_double_pendulum():
    """The accelerations of two particles on rods by the textbook's two equations."""
    m1, m2, l1, l2, g, a, b, p, q = 1.3, 0.7, 0.9, 0.6, 9.81, 0.4, -0.8, 1.1, -2.3
    c, s = math.cos(a - b), math.sin(a - b)
    mass = np.array([[(m1 + m2) * l1**2, m2 * l1 * l2 * c], [m2 * l1 * l2 * c, m2 * l2**2]])
    right = np.array([-m2 * l1 * l2 * s * q**2 - (m1 + m2) * g * l1 * math.sin(a),
                      m2 * l1 * l2 * s * p**2 - m2 * g * l2 * math.sin(b)])
    eq = equations(Mechanism(DOUBLE), {"a": a, "b": b}, {"a": p, "b": q})
    for mine, book in zip(eq.accelerations, np.linalg.solve(mass, right)):
        near(mine, book)
    near(eq.i.rate_of(eq.i.speed("u2"), eq.accelerations), eq.accelerations[1] - eq.accelerations[0])


def test_rolling_disc():
    """Kane and Levinson's three equations of the rolling disc, in the speeds of the model."""
    m = Mechanism(DISC)
    q = {"q1": 0.3, "q2": 0.5, "q3": 0.2, "x": 0.1, "y": -0.4}
    rates = permitted(m, q, {"q1": 0.9, "q2": -0.6, "q3": 2.0, "x": 0.0, "y": 0.0})
    eq = equations(m, q, rates)
    assert eq.rank == 2
    u1, u2, u3 = (float(eq.i.speed(u).v) for u in ("u1", "u2", "u3"))
    r, g, t = 0.31, 9.81, math.tan(0.5)
    book = [4 * g * math.sin(0.5) / (5 * r) + u3 * (6 * u2 - u3 * t) / 5, -2 * u1 * u3 / 3, u1 * (u3 * t - 2 * u2)]
    for u, value in zip(("u1", "u2", "u3"), book):
        near(eq.i.rate_of(eq.i.speed(u), eq.accelerations), value)


def test_gyroscope():
    """Steady precession of a symmetric top, and Euler's equations with Euler parameters."""
    m = Mechanism(TOP)
    A, C, l, g, mass = 0.4 + 1.1 * 0.25, 0.25, 0.5, 9.81, 1.1
    theta, spin = 0.6, 20.0
    # A cos θ Ω² − C n Ω + m g l = 0 with the spin n about the axis of the top.
    omega = min(np.roots([A * math.cos(theta), -C * spin, mass * g * l]).real, key=abs)
    rates = {"psi": omega, "theta": 0.0, "phi": spin - omega * math.cos(theta)}
    eq = equations(m, {"psi": 0.2, "theta": theta, "phi": 0.4}, rates)
    assert np.abs(eq.accelerations).max() < 1e-11
    m = Mechanism(SPINNER)
    q = {"e0": 0.5, "e1": -0.5, "e2": 0.1, "e3": math.sqrt(0.49)}
    rates = permitted(m, q, {"e0": 0.3, "e1": 0.2, "e2": -0.4, "e3": 0.1})
    eq = equations(m, q, rates)
    w = [float(eq.i.speed(f"w{k}").v) for k in (1, 2, 3)]
    I = [0.4, 0.8, 0.25]
    for k in range(3):
        a, b = (k + 1) % 3, (k + 2) % 3
        near(eq.i.rate_of(eq.i.speed(f"w{k + 1}"), eq.accelerations), (I[a] - I[b]) * w[a] * w[b] / I[k])


def test_driven_loop():
    """The piston of a slider-crank with a given crank: x = r cos wt + √(l² − r² sin² wt)."""
    m = Mechanism(CRANK)
    t, r, l, w = 0.4, 0.2, 0.7, 3.0
    q = closed(m, {"q1": w * t, "q2": -1.5, "x": 0.7}, t)
    x = lambda t: r * math.cos(w * t) + math.sqrt(l**2 - (r * math.sin(w * t))**2)
    near(q["x"], x(t))
    rates = permitted(m, q, {"q1": 0.0, "q2": 0.0, "x": 0.0}, t)
    h = 1e-4
    near(rates["x"], (x(t + h) - x(t - h)) / (2 * h), 1e-7)
    eq = equations(m, q, rates, t)
    near(eq.accelerations[m.coordinates.index("x")], (x(t + h) - 2 * x(t) + x(t - h)) / h**2, 1e-6)
    assert len(eq.rows) == 6 and eq.rank == 3      # three more equations of the closing pin lie across the plane


def test_motion():
    """A pendulum of small amplitude after a quarter of its period, and its crossing of the vertical."""
    m = Mechanism(PENDULUM)
    k = math.sin(0.5 / 2)
    a, b = 1.0, math.sqrt(1 - k * k)
    while abs(a - b) > 1e-15:
        a, b = (a + b) / 2, math.sqrt(a * b)
    quarter = math.pi / (2 * a) / math.sqrt(2 * 9.81 * 1.5 / (0.3 + 2 * 1.5**2))
    motion = Motion(m, {"q": 0.5}, {"q": 0.0}, (0.0, quarter))
    assert abs(motion.q["q"]) < 1e-11 and motion.error.max() < 1e-9
    motion = Motion(m, {"q": 0.5}, {"q": 0.0}, (0.0, 1.5 * quarter))
    (t, slope), = motion.crossings(lambda t: motion.fine.sol(t)[0], (0.0, 1.5 * quarter))
    assert abs(t - quarter) < 1e-9 and slope < 0


def test_expressions():
    """Rewriting keeps values; texts in Python have the values of their trees."""
    r = random.Random(1)
    scope = {"m1": 1.3, "q1": 0.4, "q2": -0.9, "q1'": 1.7, "l1": 0.8}
    tree = expressions.read("m1*l1^2*q1'^2*(3*cos(q1 - q2)^2 - 1)/6 - l1*tan(q2)*sin(q1)^2/(2 + cos(q1))")
    book = 1.3 * 0.64 * 1.7**2 * (3 * math.cos(1.3)**2 - 1) / 6
    book -= 0.8 * math.tan(-0.9) * math.sin(0.4)**2 / (2 + math.cos(0.4))
    near(expressions.value(tree, scope), book)
    for _ in range(300):
        other = equal_form(r, tree, 5, list(scope))
        near(expressions.value(other, scope), book)
        notation = Notation("python", r, [])
        text = notation.text(other)
        names = {notation.name(n): v for n, v in scope.items()}
        near(eval(text, {"np": np, **names}), book)


def test_bound():
    near(upper_bound(0, 300), 1 - 0.05 ** (1 / 300))
    assert 0.02 < upper_bound(1, 200) < 0.025


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print(f"{name[5:]}: right")
