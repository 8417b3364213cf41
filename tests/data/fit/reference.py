"""Data and reference values of the fits: by SciPy, from formulas that are written here by hand.

Run it in this folder: `python reference.py`. It needs NumPy and SciPy.
"""
import json

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

G = 9.81


def table(name, heads, columns):
    """Writes columns of numbers as CSV."""
    with open(name, "w") as file:
        file.write(",".join(heads) + "\n")
        for row in zip(*columns):
            file.write(",".join(repr(float(x)) for x in row) + "\n")


def swing(random):
    """A pendulum with drag (m = 1 kg): length, drag and first angle from 120 measured angles."""
    t = np.linspace(0, 6, 121)[1:]

    def motion(x):
        length, drag, start = x
        rates = lambda t, y: [y[1], -G / length * np.sin(y[0]) - drag * y[1]]
        return solve_ivp(rates, (0, 6), [start, 0], t_eval=t, rtol=1e-11, atol=1e-12).y[0]

    angle = motion([0.75, 0.3, 1.2]) + 0.02 * random.standard_normal(t.size)
    table("swing.csv", ["t", "theta"], [t, angle])
    found = least_squares(lambda x: motion(x) - angle, [0.8, 0.2, 1.1], xtol=1e-13, ftol=1e-13, gtol=1e-13,
                          x_scale=[1, 1, 1], diff_step=1e-5)
    variance = 2 * found.cost / (t.size - 3)
    errors = np.sqrt(variance * np.diag(np.linalg.inv(found.jac.T @ found.jac)))
    return {"names": ["l", "c", "theta"], "values": list(found.x), "errors": list(errors)}


def arm(random):
    """Two links in a plane: four base parameters and a damping from 400 measured states and torques."""
    t = np.linspace(0, 8, 400)
    q, u, a = [np.zeros((2, t.size)) for _ in range(3)]
    for joint in range(2):
        for k in range(1, 5):
            w, size, phase = 0.9 * k, 0.8 / k, 1.3 * joint + 0.7 * k
            q[joint] += size * np.sin(w * t + phase)
            u[joint] += size * w * np.cos(w * t + phase)
            a[joint] -= size * w * w * np.sin(w * t + phase)
    length = 0.5
    c, s = np.cos(q[1]), np.sin(q[1])
    both = 2 * a[0] + a[1]
    spin = 2 * u[0] * u[1] + u[1] ** 2
    # Izz_upper + L1^2 m_fore, Izz_fore, mx_fore, my_fore, d1
    rows = np.zeros((2, t.size, 5))
    rows[0] = np.stack([a[0], a[0] + a[1], length * (c * both - s * spin), -length * (s * both + c * spin), u[0]], -1)
    zero = np.zeros(t.size)
    rows[1] = np.stack([zero, a[0] + a[1], length * (c * a[0] + s * u[0] ** 2), length * (c * u[0] ** 2 - s * a[0]),
                        zero], -1)
    true = np.array([0.1 + 2 * 0.04 + 0.25, 0.05 + 0.09, 0.3, 0.0, 0.4])
    torque = rows @ true + np.array([0.05, 0.02])[:, None] * random.standard_normal((2, t.size))
    heads = ["t", "q1", "q2", "u1", "u2", "u1'", "u2'", "tau1", "tau2"]
    table("arm.csv", heads, [t, *q, *u, *a, *torque])
    noise = np.ones(2)
    freedom = 1 - 5 / (2 * t.size)
    for _ in range(30):
        matrix = np.concatenate([rows[k] / noise[k] for k in range(2)])
        side = np.concatenate([torque[k] / noise[k] for k in range(2)])
        values = np.linalg.lstsq(matrix, side, rcond=None)[0]
        noise = np.array([np.sqrt(np.mean((torque[k] - rows[k] @ values) ** 2) / freedom) for k in range(2)])
    errors = np.sqrt(np.diag(np.linalg.inv(matrix.T @ matrix)))
    names = ["Izz_upper + L1^2*m_fore", "Izz_fore", "mx_fore", "my_fore", "d1"]
    return {"names": names, "values": list(values), "errors": list(errors)}


if __name__ == "__main__":
    random = np.random.default_rng(51)
    with open("reference.json", "w") as file:
        json.dump({"swing": swing(random), "arm": arm(random)}, file, indent=1)
        file.write("\n")
