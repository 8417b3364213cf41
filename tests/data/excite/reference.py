"""Information in the motion `motion.csv` of the arm `../fit/arm.toml`: by NumPy, from formulas that are written by hand.

Run it in this folder: `python reference.py`. It needs NumPy. The motion was written by

    tripos excite ../fit/arm.toml --limit q1=-1.2:1.2 --limit q2=-1.5:1.5 --limit u1=3 --limit "q1''=12" \
        --limit "q2''=12" --write motion.csv
"""
import csv
import json

import numpy as np


def regressor(q, u, a, length):
    """Regressor of Izz_upper + L1^2 m_fore, Izz_fore, mx_fore, my_fore, d1: two rows for each instant."""
    c, s = np.cos(q[1]), np.sin(q[1])
    both = 2 * a[0] + a[1]
    spin = 2 * u[0] * u[1] + u[1] ** 2
    zero = np.zeros(c.size)
    first = [a[0], a[0] + a[1], length * (c * both - s * spin), -length * (s * both + c * spin), u[0]]
    second = [zero, a[0] + a[1], length * (c * a[0] + s * u[0] ** 2), length * (c * u[0] ** 2 - s * a[0]), zero]
    return np.concatenate([np.stack(first, -1), np.stack(second, -1)])


if __name__ == "__main__":
    with open("motion.csv") as file:
        rows = list(csv.DictReader(file))
    column = lambda name: np.array([float(row[name]) for row in rows])
    pair = lambda form: [column(form.format(joint)) for joint in (1, 2)]
    w = regressor(pair("q{}"), pair("u{}"), pair("u{}'"), 0.5)
    lengths = np.linalg.norm(w, axis=0)
    sign, log_determinant = np.linalg.slogdet((w / lengths).T @ (w / lengths))
    assert sign == 1
    found = {
        "log_determinant": log_determinant + 2 * np.sum(np.log(lengths)),
        "condition": np.linalg.cond(w / lengths),
        "errors": list(np.sqrt(np.diag(np.linalg.inv(w.T @ w)))),
    }
    with open("reference.json", "w") as file:
        json.dump(found, file, indent=1)
        file.write("\n")
