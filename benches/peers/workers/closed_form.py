"""The closed form of disk_form.h for heyoka."""

import heyoka as hy


def equations(R, g):
    """The closed form; R and g are numbers, which the compiler may use: as constants they are an advantage."""
    q1, q2, q3, q4, q5, r1, r2, r3, r4, r5 = hy.make_vars("q1", "q2", "q3", "q4", "q5", "r1", "r2", "r3", "r4", "r5")
    s1, c1, s2, c2 = hy.sin(q1), hy.cos(q1), hy.sin(q2), hy.cos(q2)
    a1 = -2.0 * r2 * r3 / c2
    a2 = (4.0 * (g / R) * s2 + c2 * (r1 * (r1 * s2 + 2.0 * r3) - 4.0 * r2 * r2 * s2)) / (1.0 + 4.0 * s2 * s2)
    turn, carry = s2 * a1, c2 * r1 * r2
    radial = R * (s2 * (r1 * r1 + r2 * r2) - c2 * a2)
    across = R * (turn + 2.0 * carry)
    return [
        (q1, r1), (q2, r2), (q3, r3), (q4, r4), (q5, r5),
        (r1, a1), (r2, a2), (r3, -(turn + carry)), (r4, c1 * across - s1 * radial), (r5, c1 * radial + s1 * across),
    ]  # fmt: skip


def general(R, g, share):
    """The same for any axial moment of inertia, which is `share` times M R^2."""
    q1, q2, q3, q4, q5, r1, r2, r3, r4, r5 = hy.make_vars("q1", "q2", "q3", "q4", "q5", "r1", "r2", "r3", "r4", "r5")
    s1, c1, s2, c2 = hy.sin(q1), hy.cos(q1), hy.sin(q2), hy.cos(q2)
    spin = 4.0 * share * (r1 * s2 + r3)
    a1 = r2 * (2.0 * r1 * s2 - spin) / c2
    a2 = (4.0 * s2 * (g / R - c2 * r2 * r2) + c2 * r1 * (spin - r1 * s2)) / (1.0 + 4.0 * s2 * s2)
    turn, carry = s2 * a1, c2 * r1 * r2
    radial = R * (s2 * (r1 * r1 + r2 * r2) - c2 * a2)
    across = R * (turn + 2.0 * carry)
    return [
        (q1, r1), (q2, r2), (q3, r3), (q4, r4), (q5, r5),
        (r1, a1), (r2, a2), (r3, -(turn + carry)), (r4, c1 * across - s1 * radial), (r5, c1 * radial + s1 * across),
    ]  # fmt: skip
