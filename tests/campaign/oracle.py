"""Equations of motion in all rates q', with multipliers, at one state.

M q'' + h = Q + Aᵀ λ and A q'' + γ = 0, from positions alone: velocities and accelerations are their derivatives. M
is the mass matrix of all bodies in the coordinates of the file, so no choice of speeds and no elimination enters.
"""
import numpy as np
import loads
from formula import evaluate, has_velocity, names
from instant import Instant
from mechanism import Unknown

PAIRS = {1: (2, 3), 2: (3, 1), 3: (1, 2)}


def inertia(i, name, body):
    """Central inertia of a body along the axes of the inertial frame."""
    entry = body.get("inertia", 0)
    frame = i.m.frame_of(name)
    if not isinstance(entry, dict):
        return float(i.constant(entry)) * np.eye(3)
    r = i.frame(entry.get("frame", frame)).v
    tensor = np.diag([float(i.constant(a)) for a in entry["diagonal"]])
    xy, yz, zx = (float(i.constant(a)) for a in entry.get("products", [0, 0, 0]))
    tensor += np.array([[0, xy, zx], [xy, 0, yz], [zx, yz, 0]])
    if "about_point" in entry:
        arm = r.T @ (i.centre(name).v - i.point(entry["about_point"]).v)
        tensor -= float(i.constant(body["mass"])) * ((arm @ arm) * np.eye(3) - np.outer(arm, arm))
    return r @ tensor @ r.T


class Row:
    """A constraint: its name, its slopes along q'', the rest of its second derivative, and what it leaves open."""
    def __init__(self, name, slopes, rest, residual, position=None, gradient=None):
        self.name, self.slopes, self.rest, self.residual = name, slopes, rest, residual
        self.position, self.gradient = position, gradient


def position_row(i, name, number):
    """Row of an equation number = 0 between coordinates."""
    rates = i.rates
    rest, residual = float(rates @ number.h @ rates), float(number.g @ rates)
    return Row(name, number.g[:i.n], rest, residual, float(number.v), number.g)


def velocity_row(i, name, number):
    """Row of an equation number = 0 between velocities."""
    return Row(name, number.g[i.n + 1:], float(number.g[:i.n + 1] @ i.rates), float(number.v))


def closure(i, joint):
    """Rows of a joint that closes a loop."""
    kind = joint.kind
    axes, own = i.joint_axes(joint), i.joint_axes(joint, "body_turned", joint.body)
    gap = axes.T @ (i.place_on(joint.body, joint.entry.get("body_at")) - i.place_on(joint.to, joint.entry.get("at")))
    relative = axes.T @ own
    if kind in ("pin", "ball", "universal", "weld"):
        shifts = [1, 2, 3]
    elif kind in ("slider", "cylinder"):
        shifts = list(PAIRS[joint.axis])
    elif kind == "planar":
        shifts = [joint.axis]
    else:
        raise Unknown(f"closing {kind}")
    for k in shifts:
        yield position_row(i, f"{joint.name}_{k}", gap[k - 1])
    if kind in ("pin", "cylinder", "planar"):
        turns = [(b, joint.axis) for b in PAIRS[joint.axis]]
    elif kind == "universal":
        first, second = joint.entry.get("axes", [1, 2])
        turns = [(first, second)]
    else:
        turns = [(1, 2), (2, 3), (3, 1)] if kind in ("slider", "weld") else []
    for a, b in turns:
        yield position_row(i, f"{joint.name}_turn{b}{a}", relative[a - 1, b - 1])


def norms(i):
    """Rows of the norms of Euler parameters."""
    groups = [e["euler_parameters"] for e in i.m.frames.values() if "euler_parameters" in e]
    groups += [j.coordinates[-4:] for j in i.m.joints.values() if j.euler and not j.closes]
    for group in groups:
        total = sum((i.scope[e] * i.scope[e] for e in group[1:]), i.scope[group[0]] * i.scope[group[0]])
        yield position_row(i, "norm", total - 1)


def stated(i):
    """Rows of the section `constraints`."""
    for name, entry in i.m.data.get("constraints", {}).items():
        left, right = (entry["equation"] if isinstance(entry, dict) else entry).split("=")
        words = names(left) | names(right)
        if has_velocity(left + right) or any("'" in w or w in i.m.speeds for w in words):
            yield velocity_row(i, name, evaluate(left, i.velocity) - evaluate(right, i.velocity) + i.lower(i.time) * 0)
        else:
            yield position_row(i, name, evaluate(left, i.scope) - evaluate(right, i.scope) + i.time * 0)


def rolling(i):
    for name, entry in i.m.data.get("rolling", {}).items():
        place = i.point(entry["at"])
        slip = i.material(entry["body"], place) - i.material(entry.get("against"), place)
        for k in range(3):
            yield velocity_row(i, f"{name}_{k + 1}", slip[k])


class Equations:
    """The equations of a mechanism at one state, and their solution."""
    def __init__(self, i):
        self.i, n = i, i.n
        self.mass, self.h, self.kinetic = np.zeros((n, n)), np.zeros(n), 0.0
        for name, body in [*i.m.bodies.items(), *i.m.particles.items()]:
            self.add(name, body)
        self.wrenches = loads.applied(i)
        forces = sum((w.generalized(i) for w in self.wrenches), np.zeros(n + 1))
        potential = loads.potential(i)
        self.power = float(forces @ i.rates - potential.g @ i.rates)
        self.q = (forces - potential.g)[:n]
        rows = [*stated(i), *norms(i), *rolling(i)]
        for joint in i.m.joints.values():
            if joint.closes:
                rows += closure(i, joint)
        self.rows = rows
        self.a = np.array([row.slopes for row in rows]).reshape(len(rows), n)
        self.gamma = np.array([row.rest for row in rows])

    def add(self, name, body):
        i, n = self.i, self.i.n
        m, motion = float(i.constant(body.get("mass", 0))), i.moving(i.m.centre_of(name))
        j = motion.jacobian[:, :n]
        self.mass += m * j.T @ j
        self.h += m * j.T @ motion.bias
        self.kinetic += m * motion.value @ motion.value / 2
        if name not in i.m.bodies:
            return
        if "added_mass" in body:
            self.add_fluid(name, body["added_mass"])
        turning, tensor = i.turning(i.m.frame_of(name)), inertia(i, name, body)
        j, w = turning.jacobian[:, :n], turning.value
        self.mass += j.T @ tensor @ j
        self.h += j.T @ (tensor @ turning.bias + np.cross(w, tensor @ w))
        self.kinetic += w @ tensor @ w / 2

    def add_fluid(self, name, entry):
        """Fluid that moves with a body: the energy ½ νᵀ M ν, with Kirchhoff's equations in the body's axes."""
        i, n = self.i, self.i.n
        if "diagonal" in entry:
            matrix = np.diag([float(i.constant(a)) for a in entry["diagonal"]])
        else:
            matrix = np.array([[float(i.constant(a)) for a in row] for row in entry["matrix"]])
        r = i.body_frame(name).v
        turning = i.turning(i.m.frame_of(name))
        moving = i.moving(entry["about_point"]) if "about_point" in entry else i.moving(i.m.centre_of(name))
        j = np.concatenate([r.T @ moving.jacobian, r.T @ turning.jacobian])[:, :n]
        v, w = r.T @ moving.value, r.T @ turning.value
        rest = np.concatenate([r.T @ moving.bias - np.cross(w, v), r.T @ turning.bias])
        nu = np.concatenate([v, w])
        p, h = (matrix @ nu)[:3], (matrix @ nu)[3:]
        self.mass += j.T @ matrix @ j
        self.h += j.T @ (matrix @ rest + np.concatenate([np.cross(w, p), np.cross(w, h) + np.cross(v, p)]))
        self.kinetic += nu @ matrix @ nu / 2

    def solve(self):
        """q'' and the condition of the solution; multipliers of dependent constraints are the shortest ones."""
        n = self.i.n
        # Motions that the constraints permit: an orthonormal basis, by singular values of unit rows.
        lengths = np.linalg.norm(self.a, axis=1)
        kept = lengths > 1e-14 * max(1.0, lengths.max(initial=0))
        a, gamma = self.a[kept] / lengths[kept, None], self.gamma[kept] / lengths[kept]
        if len(a):
            u, s, vt = np.linalg.svd(a)
            self.rank = rank = int((s > 1e-9 * s[0]).sum())
            self.smallest = s[rank - 1] / s[0]
            self.gap = s[rank] / s[0] if rank < len(s) else 0.0
            self.free = vt[rank:].T
            special = -vt[:rank].T @ ((u.T[:rank] @ gamma) / s[:rank])
            self.unmet = np.linalg.norm(a @ special + gamma) / (1 + np.linalg.norm(gamma))
        else:
            self.rank, self.smallest, self.gap, self.unmet = 0, 1.0, 0.0, 0.0
            self.free, special = np.eye(n), np.zeros(n)
        reduced = self.free.T @ self.mass @ self.free
        right = self.free.T @ (self.q - self.h - self.mass @ special)
        if len(right):
            scale = np.sqrt(np.maximum(np.diag(reduced), 1e-300))
            self.condition = np.linalg.cond(reduced / np.outer(scale, scale)) / self.smallest
            self.eigenvalues = np.linalg.eigvalsh(reduced / np.outer(scale, scale))
            free = np.linalg.solve(reduced / np.outer(scale, scale), right / scale) / scale
            self.accelerations = special + self.free @ free
        else:
            self.condition, self.eigenvalues, self.accelerations = 1 / self.smallest, np.ones(1), special
        return self.accelerations

    def drives(self):
        """Power of the drives and of the constraints that depend on time: dT/dt less the power of all loads."""
        i, n, total = self.i, self.i.n, 0.0
        for name, body in [*i.m.bodies.items(), *i.m.particles.items()]:
            if "added_mass" in body:
                return None
            motion = i.moving(i.m.centre_of(name))
            a = motion.jacobian[:, :n] @ self.accelerations + motion.bias
            total += float(i.constant(body.get("mass", 0))) * float(a @ motion.value)
            if name in i.m.bodies:
                turning, tensor = i.turning(i.m.frame_of(name)), inertia(i, name, body)
                alpha = turning.jacobian[:, :n] @ self.accelerations + turning.bias
                total += float(turning.value @ tensor @ alpha)
        return total - self.power


def equations(mechanism, q, rates, t=0.0, parameters=None, inputs=None):
    """Solved equations at one state; `q` and `rates` are dictionaries by coordinate."""
    result = Equations(Instant(mechanism, q, rates, t, parameters, inputs))
    result.solve()
    return result


def closed(mechanism, q, t=0.0, parameters=None, steps=40):
    """Coordinates with closed loops near `q`, by Newton's method with shortest corrections."""
    q = dict(q)
    for _ in range(steps):
        eq = Equations(Instant(mechanism, q, dict.fromkeys(mechanism.coordinates, 0.0), t, parameters))
        rows = [row for row in eq.rows if row.position is not None]
        if not rows:
            return q
        value = np.array([row.position for row in rows])
        slopes = np.array([row.gradient[:-1] for row in rows])
        change = np.linalg.lstsq(slopes, -value, rcond=1e-10)[0]
        for name, d in zip(mechanism.coordinates, change):
            q[name] += float(d)
        if np.abs(change).max() < 1e-15:
            break
    return q if np.abs(value).max() < 1e-12 else None


def permitted(mechanism, q, rates, t=0.0, parameters=None):
    """The rates nearest to `rates` that satisfy all constraints."""
    eq = Equations(Instant(mechanism, q, rates, t, parameters))
    value = np.array([row.residual for row in eq.rows])
    if not len(value):
        return dict(rates)
    change = np.linalg.lstsq(eq.a, -value, rcond=1e-10)[0]
    result = {name: rates[name] + float(d) for name, d in zip(mechanism.coordinates, change)}
    # Once more, for the last digits.
    eq = Equations(Instant(mechanism, q, result, t, parameters))
    value = np.array([row.residual for row in eq.rows])
    change = np.linalg.lstsq(eq.a, -value, rcond=1e-10)[0]
    return {name: result[name] + float(d) for name, d in zip(mechanism.coordinates, change)}
