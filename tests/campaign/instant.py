"""Velocities of a mechanism at one state, with first derivatives in (q, t, q')."""
import numpy as np
import jets
from jets import Jet
from formula import Numbers, evaluate
from mechanism import Configuration, Unknown


def vee(matrix):
    """Vector of the skew part of a matrix, or of matrices along further axes."""
    return np.stack([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / 2


class Turning:
    """Angular velocity of a frame: `jacobian` with respect to the rates of (q, t), and the acceleration without q''."""
    def __init__(self, rotation, rates):
        r = rotation
        self.jacobian = vee(np.einsum("ijn,kj->ikn", r.g, r.v))
        rate = r.g @ rates
        second = np.einsum("ijnm,n,m->ij", r.h, rates, rates)
        self.bias = vee(second @ r.v.T + rate @ rate.T)
        self.value = self.jacobian @ rates
        slopes = np.einsum("ijnm,n,kj->ikm", r.h, rates, r.v) + np.einsum("ij,kjm->ikm", rate, r.g)
        self.slopes = vee(slopes)


class Moving:
    """Velocity of a point, as `Turning` of a frame."""
    def __init__(self, point, rates):
        self.jacobian = point.g
        self.value = point.g @ rates
        self.slopes = point.h @ rates
        self.bias = self.slopes @ rates


class Instant(Configuration):
    """A configuration with rates q'; numbers of the velocity level have slopes in (q, t, q')."""
    def __init__(self, mechanism, q, rates, t=0.0, parameters=None, inputs=None):
        super().__init__(mechanism, q, t, parameters)
        self.n = self.size - 1
        self.rates = np.array([rates[name] for name in mechanism.coordinates] + [1.0])
        self.turnings, self.movings, self.inputs = {}, {}, inputs or {}
        self.velocity = VelocityScope(self)

    def turning(self, frame):
        if frame not in self.turnings:
            self.turnings[frame] = Turning(self.frame(frame), self.rates)
        return self.turnings[frame]

    def moving(self, point):
        if point not in self.movings:
            self.movings[point] = Moving(self.point(point), self.rates)
        return self.movings[point]

    def jet(self, motion):
        """A velocity as a vector with slopes in (q, t, q')."""
        return Jet(motion.value, np.concatenate([motion.slopes, motion.jacobian[:, :self.n]], axis=1))

    def lower(self, number):
        """A number of the configuration with slopes in (q, t, q')."""
        return Jet(number.v, np.concatenate([number.g, np.zeros(number.g.shape[:-1] + (self.n,))], axis=-1))

    def material(self, body, place):
        """Velocity of the material of a body at a place, with slopes in (q, t, q')."""
        if body == self.m.inertial or body is None or body == "ground":
            return Jet(np.zeros(3), np.zeros((3, 2 * self.n + 1)))
        arm = self.lower(place - self.centre(body))
        return self.jet(self.moving(self.m.centre_of(body))) + jets.cross(self.jet(self.turning(
            self.m.frame_of(body))), arm) if body in self.m.bodies else self.jet(self.moving(self.m.centre_of(body)))

    def material_jacobian(self, body, place):
        """Slopes of the velocity of the material at a place (a vector) with respect to the rates of (q, t)."""
        motion = self.moving(self.m.centre_of(body)).jacobian
        if body not in self.m.bodies:
            return motion
        arm = place - self.centre(body).v
        return motion + np.cross(self.turning(self.m.frame_of(body)).jacobian.T, arm).T

    def number(self, text):
        """Value of a formula of the velocity level."""
        value = evaluate(text, self.velocity)
        return float(value.v) if isinstance(value, Jet) else float(value)

    def numbers(self, texts):
        return np.array([self.number(text) for text in texts])

    def speed(self, name):
        """A generalized speed with slopes in (q, t, q')."""
        return self.velocity[name]

    def rate_of(self, number, accelerations):
        """Time derivative of a number of the velocity level, at given q''."""
        n = self.n
        return float(number.g[:n + 1] @ self.rates + number.g[n + 1:] @ accelerations)


class VelocityScope(Numbers):
    """Names of formulas of the velocity level."""
    def __init__(self, instant):
        super().__init__()
        self.i = instant

    def __missing__(self, name):
        self[name] = value = self.find(name)
        return value

    def find(self, name):
        i, m = self.i, self.i.m
        if name.endswith("'") and name[:-1] in m.coordinates:
            k = m.coordinates.index(name[:-1])
            return Jet.variable(i.rates[k], i.size + k, 2 * i.n + 1, False)
        if name in m.coordinates or name == "t":
            return i.lower(i.scope[name])
        if name in m.speeds:
            return self.speed(m.speeds[name])
        if name in i.expressions:
            entry = i.expressions[name]
            return evaluate(entry["value"] if isinstance(entry, dict) else entry, self)
        if name in i.scope:
            value = i.scope[name]
            return i.lower(value) if isinstance(value, Jet) else value
        if name in m.data.get("inputs", {}):
            value = i.inputs.get(name, m.data["inputs"][name].get("value", 0))
            return evaluate(value, self)
        raise Unknown(f"name {name}")

    def speed(self, definition):
        if isinstance(definition, str):
            return evaluate(definition, self)
        joint, k = definition
        i = self.i
        first = {"ball": 0, "free": 3}.get(joint.kind, 99)
        if k < first:
            return self[joint.coordinates[k] + "'"]
        relative = i.jet(i.turning(i.m.frame_of(joint.body)))
        if joint.to:
            relative = relative - i.jet(i.turning(i.m.frame_of(joint.to)))
        return (i.lower(i.frame(i.m.frame_of(joint.body)))[:, k - first] * relative).sum()

    def component(self, kind, argument, frame, axis):
        i, m = self.i, self.i.m
        direction = i.lower(i.frame(frame))[:, axis - 1]
        if kind == "p":
            return (direction * i.lower(i.point(argument))).sum()
        if kind == "omega":
            return (direction * i.jet(i.turning(m.frame_of(argument) if argument in m.bodies else argument))).sum()
        if kind != "v":
            raise Unknown(kind)
        if " of " in argument:
            argument = ", ".join(reversed(argument.split(" of ")))
        if "," in argument:
            body, point = (part.strip() for part in argument.split(","))
            return (direction * i.material(body, i.point(point))).sum()
        return (direction * i.jet(i.moving(argument))).sum()

    def distance(self, a, b):
        return self.i.lower(self.i.scope.distance(a, b))

    min = staticmethod(lambda *xs: min(xs, key=lambda x: x.v if isinstance(x, Jet) else x))
    max = staticmethod(lambda *xs: max(xs, key=lambda x: x.v if isinstance(x, Jet) else x))
