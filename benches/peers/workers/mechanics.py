"""The two mechanisms as each algebra tool takes them best: M(q) q'' = f(q, q').

Of `n` coordinates and `m` parameters: the disk has 3, a chain more. CasADi takes both by Lagrange's equations; symengine, SymPy and
SymForce the chain by the virtual power of its masses (Kane's form), which is twice as fast for them and as short.
"""


def of_casadi(n, m, share=0.5):
    """(q, v, p, M, f) as SX: Hessians and directional derivatives of the energies."""
    import casadi as ca

    q, v, p = (ca.SX.sym(name, count) for name, count in zip("qvp", (n, n, m)))
    qs, vs, ps = (ca.vertsplit(x) for x in (q, v, p))
    if m == 3:
        kinetic, potential = disk_energies(ca, qs, vs, ps, lambda x: ca.jtimes(x, q, v), share)
    else:
        kinetic, potential = chain_energies(ca, qs, vs, ps)
    M, momenta = ca.hessian(kinetic, v)
    f = ca.gradient(kinetic - potential, q) - ca.jtimes(momenta, q, v)
    if m != 3:
        f[0] += ps[-1]
    return q, v, p, M, f


def of_symbols(tool, n, m):
    """(q, v, p, M, f) as lists, by a module with symbols that can be differentiated."""
    q, v, p = ([tool.Symbol(f"{name}{i}") for i in range(k)] for name, k in zip("qvp", (n, n, m)))
    diff = lambda expression, symbol: expression.diff(symbol) if expression != 0 else 0
    if m == 3:
        derivative = lambda x: sum(diff(x, a) * b for a, b in zip(q, v))
        energies = disk_energies(tool, q, v, p, derivative)
        return q, v, p, *lagrange(*energies, q, v, diff)
    return q, v, p, *virtual_power(tool, q, v, p, diff)


def disk_energies(tool, q, v, p, derivative, share=None):
    """T and V; `derivative(x)` is the time derivative of x(q), `share` the axial moment of inertia over M R^2, a half if none."""
    M, R, g = p
    s1, c1, s2, c2 = tool.sin(q[0]), tool.cos(q[0]), tool.sin(q[1]), tool.cos(q[1])
    # The mass centre is above and beside the contact point (q4, q5).
    centre = (q[3] - R * s1 * s2, q[4] + R * c1 * s2, R * c2)
    velocity = [derivative(x) for x in centre]
    axial = (v[0] * s2 + v[2]) ** 2
    turning = (v[1] ** 2 + (v[0] * c2) ** 2) / 4 + (axial / 2 if share is None else share * axial)
    return M / 2 * sum(x**2 for x in velocity) + M * R**2 / 2 * turning, M * g * centre[2]


def chain_parts(p):
    """Masses, lengths, g and the force of a chain's parameters."""
    n = (len(p) - 3) // 2
    return p[: n + 1], p[n + 1 : -2], p[-2], p[-1]


def chain_energies(tool, q, v, p):
    masses, lengths, g, _ = chain_parts(p)
    vx, vy, height = v[0], 0, 0
    kinetic, potential = masses[0] * vx**2 / 2, 0
    for mass, length, angle, rate in zip(masses[1:], lengths, q[1:], v[1:]):
        s, c = tool.sin(angle), tool.cos(angle)
        vx, vy, height = vx - length * c * rate, vy - length * s * rate, height + length * c
        kinetic += mass * (vx * vx + vy * vy) / 2
        potential += mass * g * height
    return kinetic, potential


def chain_positions(tool, q, p):
    """(x, y) of each mass."""
    _, lengths, _, _ = chain_parts(p)
    x, y = [q[0]], [0]
    for length, angle in zip(lengths, q[1:]):
        x.append(x[-1] - length * tool.sin(angle))
        y.append(y[-1] + length * tool.cos(angle))
    return x, y


def lagrange(kinetic, potential, q, v, diff):
    """Lagrange's equations; `diff(expression, symbol)`."""
    n = len(q)
    momenta = [diff(kinetic, x) for x in v]
    M = [[None] * n for _ in q]
    for i in range(n):
        for j in range(i, n):
            M[i][j] = M[j][i] = diff(momenta[i], v[j])
    lagrangian = kinetic - potential
    f = [diff(lagrangian, q[i]) - sum(diff(momenta[i], q[j]) * v[j] for j in range(n)) for i in range(n)]
    return M, f


def virtual_power(tool, q, v, p, diff):
    """The chain: M = sum m J'J, f = sum J'(F - m (J' v)), where mass k moves with the first k + 1 coordinates only."""
    masses, _, g, force = chain_parts(p)
    n = len(q)
    M, f = [[0] * n for _ in q], [0] * n
    for k, (mass, x, y) in enumerate(zip(masses, *chain_positions(tool, q, p))):
        jx, jy = ([diff(r, q[j]) for j in range(k + 1)] for r in (x, y))
        vx, vy = (sum(row[j] * v[j] for j in range(k + 1)) for row in (jx, jy))
        ax, ay = (sum(diff(r, q[j]) * v[j] for j in range(k + 1)) for r in (vx, vy))
        for i in range(k + 1):
            f[i] -= mass * (jx[i] * ax + jy[i] * (ay + g))
            for j in range(i, k + 1):
                M[i][j] += mass * (jx[i] * jx[j] + jy[i] * jy[j])
    for i in range(n):
        for j in range(i):
            M[i][j] = M[j][i]
    f[0] += force
    return M, f
