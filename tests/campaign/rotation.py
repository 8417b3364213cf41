"""Rotation matrices of the model file's frames; columns are the turned axes in the axes of the frame `from`."""
import numpy as np
from jets import Jet, stack, function


def about(axis, angle):
    """A turn about axis 1, 2 or 3, or about a vector of numbers (Rodrigues' formula)."""
    if isinstance(axis, int):
        direction = np.eye(3)[axis - 1]
    else:
        direction = np.asarray(axis, float) / np.linalg.norm(np.asarray(axis, float))
    x, y, z = direction
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if not isinstance(angle, Jet):
        return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * (skew @ skew)
    # The entry with both factors 0 is exactly constant.
    sine, cosine = function("sin", angle), function("cos", angle)
    rows = [stack([skew[i, j] * sine + (skew @ skew)[i, j] * (1 - cosine) + float(i == j) for j in range(3)])
            for i in range(3)]
    return stack(rows)


def sequence(digits, angles, space=False):
    """Turns one after the other about axes of the turned frame, or with `space` about fixed axes."""
    total = None
    for digit, angle in zip(digits, angles, strict=True):
        turn = about(int(digit), angle)
        total = turn if total is None else product(turn, total) if space else product(total, turn)
    return total


def euler(parameters):
    """The matrix of Euler parameters, divided by the sum of their squares."""
    a, b, c, d = parameters
    n = a * a + b * b + c * c + d * d
    rows = [[a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d]]
    return stack([stack([entry / n for entry in row]) for row in rows])


def product(a, b):
    """Product of matrices, of which each may be constant."""
    if isinstance(b, Jet) and not isinstance(a, Jet):
        return b.constant(a) @ b
    return a @ b
