"""Mechanisms of model files by CasADi, `mechanisms_casadi.py multipliers|projected FOLDER`: a worker of run.py.

`multipliers`: M q'' + A' lambda = f and A q'' = b, with M the Hessian of T and f from the slopes of T and V. `projected`: partial velocities of
bodies, sum m J'J, then what the independent speeds see, W'M W, where W solves the constraints for the dependent ones. Both in SX, velocities in
the frame of each body, common subexpressions shared.
"""

import math
import sys
import time
from pathlib import Path

import casadi as ca
import numpy as np
from model_tables import Tables, component, value

CLOSED = 1e-9


def cross(a, b):
    return ca.cross(a, b)


def turned(axis, angle):
    """What takes components in the frame before to those in the turned one."""
    s, c = ca.sin(angle), ca.cos(angle)
    j, k = axis % 3, (axis + 1) % 3
    matrix = ca.SX.eye(3)
    matrix[j, j] = matrix[k, k] = c
    matrix[j, k], matrix[k, j] = s, -s
    return matrix


def inertia_matrix(entries):
    xx, yy, zz, xy, yz, zx = entries
    return ca.vertcat(ca.horzcat(xx, xy, zx), ca.horzcat(xy, yy, yz), ca.horzcat(zx, yz, zz))


def vector(components):
    return ca.sparsify(ca.vertcat(*(ca.SX(x) for x in components)))


class Mechanism:
    """Symbols and motion of a file's frames, points and bodies."""

    def __init__(self, path):
        self.tables = tables = Tables(path)
        self.q, self.v = (ca.SX.sym(name, len(tables.coordinates)) for name in ("q", "v"))
        self.p = ca.SX.sym("p", len(tables.parameters))
        names = dict(zip(tables.parameters, ca.vertsplit(self.p))) | dict(zip(tables.coordinates, ca.vertsplit(self.q)))
        self.names = names | {"sin": ca.sin, "cos": ca.cos, "sqrt": ca.sqrt, "pi": math.pi}
        self.turns, self.spins = {tables.ground: None}, {tables.ground: ca.SX(3, 1)}
        for name, (parent, axis, formula) in tables.frames.items():
            angle = ca.SX(self.value(formula))
            self.turns[name] = turned(axis, angle)
            along = ca.SX(3, 1)
            along[axis - 1] = self.rate(angle)
            self.spins[name] = self.turns[name] @ self.spins[parent] + ca.sparsify(along)
        # By point: where it is, and a frame with the components of its velocity.
        self.places, self.speeds = {tables.origin: ca.SX(3, 1)}, {tables.origin: (tables.ground, ca.SX(3, 1))}
        waiting = dict(tables.points)
        while waiting:
            for name in [name for name, (base, *_) in waiting.items() if base in self.places]:
                self.place(name, *waiting.pop(name))
        self.bodies = [self.body(*one) for one in tables.bodies.values()]

    def value(self, formula):
        return value(formula, self.names)

    def rate(self, term):
        return ca.sparsify(ca.jtimes(term, self.q, self.v))

    def place(self, name, base, frame, position):
        arm = vector(map(self.value, position))
        self.places[name] = self.places[base] + self.to_ground(arm, frame)
        of, speed = self.speeds[base]
        self.speeds[name] = frame, self.seen(speed, of, frame) + cross(self.spins[frame], arm) + self.rate(arm)

    def path(self, frame):
        """The frame, the one before it, and so on down to the ground."""
        found = [frame]
        while found[-1] != self.tables.ground:
            found.append(self.tables.frames[found[-1]][0])
        return found

    def seen(self, components, of, frame):
        """Components in one frame as those in another, by the turns between these alone."""
        there = self.path(frame)
        for down in self.path(of):
            if down in there:
                break
            components = self.turns[down].T @ components
        for up in reversed(there[: there.index(down)]):
            components = self.turns[up] @ components
        return components

    def to_ground(self, components, frame):
        return self.seen(components, frame, self.tables.ground)

    def body(self, frame, centre, mass, basis, entries):
        """Mass, velocity of the mass centre, spin and inertia in the basis of the latter, height's frame."""
        spin = self.seen(self.spins[frame], frame, basis)
        of, speed = self.speeds[centre]
        inertia = ca.sparsify(ca.SX(inertia_matrix([self.value(entry) for entry in entries])))
        return self.value(mass), of, speed, self.places[centre], basis, spin, inertia

    def gravity(self):
        return vector(map(self.value, self.tables.gravity))

    def potential_of_springs(self):
        energy = 0
        for one in self.tables.springs:
            length = ca.norm_2(self.places[one["at"]] - self.places[one["against_at"]])
            energy += self.value(one["stiffness"]) * (length - self.value(one["free_length"])) ** 2 / 2
        return energy

    def driven(self):
        """Generalized forces of torques that are stated on the ground."""
        force = ca.SX(self.q.numel(), 1)
        for on, moment in self.tables.torques:
            frame = self.tables.bodies[on][0]
            force += ca.jacobian(self.to_ground(self.spins[frame], frame), self.v).T @ vector(map(self.value, moment))
        return force

    def loops(self):
        """What is zero where the mechanism is closed."""
        open_by = []
        for left, right in self.tables.equations:
            if found := component(left):
                open_by.append(self.places[found[0]][found[1]] - self.value(right.strip()))
            else:
                open_by.append(self.value(left.strip()) - self.value(right.strip()))
        for one, other in self.tables.closed:
            open_by += ca.vertsplit((self.places[one] - self.places[other])[:2])
        return ca.vertcat(*open_by) if open_by else ca.SX(0, 1)

    def slips(self):
        """What is zero in motion: two of the velocities where a wheel touches; the third is the rate of a loop, or none."""
        found = []
        for name, at, frame in self.tables.rolling:
            home, centre, *_ = self.tables.bodies[name]
            of, speed = self.speeds[centre]
            base, basis, position = self.tables.points[centre]
            near = base == at
            if not near:
                _, basis, position = self.tables.points[at]
            arm = vector(map(self.value, position)) * (-1 if near else 1)
            spin = self.seen(self.spins[home], home, basis)
            slip = self.seen(speed, of, frame) + self.seen(cross(spin, arm), basis, frame)
            found += [slip[0], slip[1]]
        return ca.vertcat(*found) if found else ca.SX(0, 1)

    def constraints(self):
        """A and b of A q'' = b."""
        A = ca.vertcat(ca.jacobian(self.loops(), self.q), ca.jacobian(self.slips(), self.v))
        return A, -self.rate(A @ self.v)


def multipliers(m):
    q, v, g = m.q, m.v, m.gravity()
    kinetic, potential = 0, m.potential_of_springs()
    for mass, _, speed, place, _, spin, inertia in m.bodies:
        kinetic += mass * ca.dot(speed, speed) / 2 + ca.dot(spin, inertia @ spin) / 2
        potential -= mass * ca.dot(g, place)
    M, momenta = ca.hessian(kinetic, v)
    f = ca.gradient(kinetic - potential, q) - ca.jtimes(momenta, q, v) + m.driven()
    A, b = m.constraints()
    return [ca.triu(M), f, A, b]


def virtual_power(m):
    """M and f of all coordinates, from partial velocities."""
    n, g = m.q.numel(), m.gravity()
    M, f = ca.SX(n, n), m.driven() - ca.gradient(ca.SX(m.potential_of_springs()), m.q)
    for mass, frame, speed, _, basis, spin, inertia in m.bodies:
        J, S = ca.jacobian(speed, m.v), ca.jacobian(spin, m.v)
        M += mass * (J.T @ J) + S.T @ (inertia @ S)
        slowed = m.seen(g, m.tables.ground, frame) - m.rate(speed) - cross(m.spins[frame], speed)
        f += mass * (J.T @ slowed) - S.T @ (inertia @ m.rate(spin) + cross(m.spins[basis], inertia @ spin))
    return M, f


def projected(m):
    M, f = virtual_power(m)
    A, b = m.constraints()
    names = m.tables.coordinates
    free = [names.index(name) for name in m.tables.independent]
    tied = [at for at in range(len(names)) if at not in free]
    W, k = ca.SX(len(names), len(free)), ca.SX(len(names), 1)
    W[free, :] = ca.SX.eye(len(free))
    if tied:
        solved = ca.solve(A[:, tied], ca.horzcat(-A[:, free], b))
        W[tied, :], k[tied] = solved[:, : len(free)], solved[:, -1]
    return [ca.triu(W.T @ (M @ W)), W.T @ (f - M @ k)], [W, k]


def derived(tool, path):
    m = Mechanism(path)
    inputs = [m.q, m.v, m.p]
    if tool == "multipliers":
        outputs, more = multipliers(m), []
    else:
        outputs, more = projected(m)
    return m, ca.Function("equations", inputs, outputs, {"cse": True}), (inputs, outputs + more)


def count(function):
    ids = [function.instruction_id(k) for k in range(function.n_instructions())]
    calls = sum(i in (ca.OP_SIN, ca.OP_COS, ca.OP_SQRT) for i in ids)
    return len(ids) - sum(i in (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST) for i in ids) - calls, calls


def accelerations(tool, m, function, state):
    q, v, p = state
    A, b = m.constraints()
    left = ca.Function("left", [m.q, m.v, m.p], [m.loops(), A @ m.v])
    if any(abs(x) > CLOSED for part in left(q, v, p) for x in part.full().ravel()):
        sys.exit("the state breaks the constraints")
    M, f, *rest = (x.full() for x in function(q, v, p))
    M = M + M.T - np.diag(np.diag(M))
    if tool == "projected":
        W, k = rest
        return (W @ np.linalg.solve(M, f) + k).ravel()
    A, b = rest
    whole = np.block([[M, A.T], [A, np.zeros((len(b), len(b)))]])
    return np.linalg.solve(whole, np.vstack([f, b])).ravel()[: len(q)]


def main():
    tool, folder = sys.argv[1], Path(sys.argv[2])
    for line in sys.stdin:
        match line.split():
            case ["derive", problem, repeats]:
                begin = time.perf_counter()
                for _ in range(int(repeats)):
                    m, function, whole = derived(tool, folder / problem / "model.toml")
                answer = [(time.perf_counter() - begin) / int(repeats)]
            case ["count"]:
                answer = count(function)
            case ["solve"]:
                p, y = [[float(x) for x in line.split()] for line in (folder / problem / "states").open()][:2]
                n = len(y) // 2
                answer = accelerations(tool, m, ca.Function("whole", *whole), (y[:n], y[n:], p))
            case _:
                sys.exit(f"not understood: {line.strip()}")
        print(*(repr(float(x)) for x in answer), flush=True)


main()
