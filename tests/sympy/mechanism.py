"""The mechanism of a model: its frames, points and bodies with their motion, and what acts on them."""

import re
from dataclasses import dataclass

from sympy import Symbol, cancel
from sympy.physics.mechanics import (
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    Vector,
    inertia,
    inertia_of_point_mass,
    msubs,
)

from grammar import WAVES, Unsupported, expression
from low_level import turn_matrix


@dataclass
class Body:
    """A rigid body or particle; `basis` is the frame its components are stated in."""

    name: str
    part: object
    point: Point
    frame: ReferenceFrame | None
    basis: ReferenceFrame


@dataclass
class Load:
    """A force through the mass centre of `target` (a body) and a moment on it, or a moment on a frame."""

    target: object
    force: Vector
    moment: Vector


def short(vector, frame):
    """A vector whose components are quotients of polynomials, cancelled; others as they are."""
    components = vector.to_matrix(frame)
    if components.has(*WAVES) or components.is_zero_matrix:
        return vector
    return sum((cancel(part) * axis for part, axis in zip(components, (frame.x, frame.y, frame.z))), Vector(0))


class LoadNames(dict):
    """What formulas of loads and motion constraints may name: what all may, and components of velocities."""

    def __init__(self, mechanism):
        super().__init__(mechanism.names)
        self.mechanism = mechanism

    def __missing__(self, word):
        if "@" not in word:
            raise KeyError(word)
        kind, *of, frame, axis = re.findall(r"\w+", word)
        if len(of) == 3:
            of = [of[2], of[0]]
        reading = {"omega": self.mechanism.turning, "p": self.mechanism.position}.get(kind, self.mechanism.velocity)
        vector = reading(*of)
        basis = self.mechanism.get(self.mechanism.frames, frame)
        if axis not in ("1", "2", "3"):
            raise Unsupported(f"component {axis} of a velocity")
        return vector.dot((basis.x, basis.y, basis.z)[int(axis) - 1])


class Mechanism:
    """Frames, points and bodies with their motion.

    With `in_speeds` all velocities are written in q and u, else in q and q'. Accelerations are then in q, u
    and u'. The positions are the same.
    """

    def __init__(self, model, in_speeds):
        self.model = model
        self.names = model.names_u if in_speeds else model.names_q
        self.rates = model.rates if in_speeds else {}
        inertial = model.section("inertial")
        self.inertial = ReferenceFrame(inertial["frame"])
        self.origin = Point(inertial["origin"])
        self.frames = {inertial["frame"]: self.inertial}
        self.points = {inertial["origin"]: self.origin}
        self.position_names = model.names_q
        self.place_all("frames", self.frames, self.place_frame)
        self.place_all("points", self.points, self.place_point)
        self.set_motion()
        self.bodies = {name: self.rigid_body(name, entry) for name, entry in model.section("bodies").items()}
        self.bodies |= {name: self.particle(name, entry) for name, entry in model.section("particles").items()}
        self.set_potential()

    def place_all(self, section, known, place):
        """Entries may stand in any order: place those whose parent is known until none is left."""
        waiting = dict(self.model.section(section))
        while waiting:
            ready = [name for name, entry in waiting.items() if entry["from"] in known]
            if not ready:
                raise Unsupported(f"[{section}]: no path from the inertial one to {', '.join(waiting)}")
            for name in ready:
                known[name] = place(name, waiting.pop(name))

    def place_frame(self, name, entry):
        parent = self.frames[entry["from"]]
        frame = ReferenceFrame(name)
        if "axis" not in entry:
            frame.orient_explicit(parent, turn_matrix(entry, self.position_names))
            frame.set_ang_vel(parent, short(frame.ang_vel_in(parent), frame))
            return frame
        if entry["axis"] not in (1, 2, 3):
            raise Unsupported(f"axis {entry['axis']} of frame `{name}`")
        axis = (parent.x, parent.y, parent.z)[entry["axis"] - 1]
        frame.orient_axis(parent, axis, expression(entry["angle"], self.position_names))
        return frame

    def place_point(self, name, entry):
        position = self.vector(entry["frame"], entry["position"], self.position_names)
        return self.points[entry["from"]].locatenew(name, position)

    def vector(self, frame, components, names=None):
        if len(components) != 3:
            raise Unsupported(f"a vector has three components, not {len(components)}")
        values = [expression(c, names or self.names) for c in components]
        basis = self.get(self.frames, frame)
        return sum((value * e for value, e in zip(values, (basis.x, basis.y, basis.z))), Vector(0))

    @staticmethod
    def get(table, name):
        if name not in table:
            raise Unsupported(f"`{name}` is not declared")
        return table[name]

    def set_motion(self):
        """Velocities and accelerations in the inertial frame, in terms of the speeds if those are wanted."""
        inertial = self.inertial
        frames = [frame for frame in self.frames.values() if frame is not inertial]
        spins = [(frame, short(msubs(frame.ang_vel_in(inertial), self.rates), frame)) for frame in frames]
        velocities = [(p, msubs(p.pos_from(self.origin).dt(inertial), self.rates)) for p in self.points.values()]
        for frame, spin in spins:
            frame.set_ang_vel(inertial, spin)
        for frame, spin in spins:
            frame.set_ang_acc(inertial, msubs(spin.dt(inertial), self.rates))
        for point, velocity in velocities:
            point.set_vel(inertial, velocity)
            point.set_acc(inertial, msubs(velocity.dt(inertial), self.rates))

    def velocity(self, *of):
        """Of a point, or of the material of a body that is at a point, in the inertial frame."""
        point = self.get(self.points, of[-1])
        if len(of) == 1:
            return point.vel(self.inertial)
        body = self.get(self.bodies, of[0])
        if body.frame is None:
            return body.point.vel(self.inertial)
        arm = point.pos_from(body.point)
        return body.point.vel(self.inertial) + body.frame.ang_vel_in(self.inertial).cross(arm)

    def position(self, name):
        return self.get(self.points, name).pos_from(self.origin)

    def turning(self, name):
        """The angular velocity of a body or a frame."""
        frame = self.bodies[name].frame if name in self.bodies else self.get(self.frames, name)
        return frame.ang_vel_in(self.inertial)

    def motion_constraints(self):
        """Name and left side of each equation between velocities, and of each component of a slip."""
        names = LoadNames(self)
        stated = [(name, expression(a, names) - expression(b, names)) for name, (a, b) in self.model.motion.items()]
        for name, entry in self.model.section("rolling").items():
            point = entry["at"]
            slip = self.velocity(entry["body"], point)
            if "against" in entry:
                slip -= self.velocity(entry["against"], point)
            basis = self.get(self.frames, entry["frame"]) if "frame" in entry else self.inertial
            stated += [(f"{name}_{i + 1}", slip.dot(axis)) for i, axis in enumerate((basis.x, basis.y, basis.z))]
        return stated

    def rigid_body(self, name, entry):
        frame, centre = self.get(self.frames, entry["frame"]), self.get(self.points, entry["centre"])
        mass = expression(entry["mass"], self.names)
        stated = entry["inertia"]
        basis = self.get(self.frames, stated.get("frame", entry["frame"]))
        diagonal, products = stated["diagonal"], stated.get("products", [0, 0, 0])
        dyadic = inertia(basis, *(expression(value, self.names) for value in (*diagonal, *products)))
        if "about_point" in stated:
            arm = self.get(self.points, stated["about_point"]).pos_from(centre).express(basis)
            dyadic -= inertia_of_point_mass(mass, arm, basis)
        part = RigidBody(name, centre, frame, mass, (dyadic, centre))
        return Body(name, part, centre, frame, basis)

    def particle(self, name, entry):
        point = self.get(self.points, entry["point"])
        part = Particle(name, point, expression(entry["mass"], self.names))
        return Body(name, part, point, None, self.inertial)

    def gravity(self):
        """The vector of free fall."""
        entry = self.model.section("gravity")
        return self.vector(entry["frame"], entry["acceleration"]) if entry else Vector(0)

    def set_potential(self):
        """V = -sum of m g.r, less its value at `zero_at` if that is given."""
        for body in self.bodies.values():
            v = -body.part.mass * self.gravity().dot(body.point.pos_from(self.origin))
            if self.model.zero_at is not None:
                v -= v.subs(self.model.zero_at)
            body.part.potential_energy = v

    @property
    def parts(self):
        return [body.part for body in self.bodies.values()]

    # What acts on the bodies.

    def weights(self):
        return [Load(body, body.part.mass * self.gravity(), Vector(0)) for body in self.bodies.values()]

    def applied(self):
        """The loads of [forces] and [torques]."""
        kinds = ((self.force, "forces"), (self.torque, "torques"))
        entries = ((act, entry) for act, section in kinds for entry in self.model.section(section).values())
        names = LoadNames(self)
        loads = sum((act(entry, self.vector(entry["frame"], entry["vector"], names)) for act, entry in entries), [])
        loads += sum((self.spring(entry) for entry in self.model.section("springs").values()), [])
        return loads + sum((self.potential(entry["value"], names) for entry in self.model.section("potentials").values()), [])

    def reactions(self):
        """The name of each reaction, with the loads it exerts."""
        loads = {}
        for name, entry in self.model.section("reactions").items():
            symbol = Symbol(name, real=True)
            vector = symbol * self.vector(entry["frame"], entry["direction"])
            kind = entry.get("kind", "force")
            if kind not in ("force", "torque"):
                raise Unsupported(f"kind `{kind}` of reaction `{name}`")
            loads[symbol] = self.force(entry, vector) if kind == "force" else self.torque(entry, vector)
        return loads

    def force(self, entry, vector):
        """A force on a body at one of its points, and the opposite one on `against` (at the same point)."""
        on = self.get(self.bodies, entry["on"])
        at = self.get(self.points, entry["at"]) if "at" in entry else on.point
        loads = [self.force_at(on, at, vector)]
        if "against" in entry:
            against = self.get(self.bodies, entry["against"])
            there = against.point if against.frame is None else at
            there = self.get(self.points, entry["against_at"]) if "against_at" in entry else there
            loads.append(self.force_at(against, there, -vector))
        return loads

    def spring(self, entry):
        """A pull along the way between two points, the other of which is on a body or on the ground."""
        stiffness, free, damping = (expression(entry.get(key, 0), self.names) for key in ("stiffness", "free_length", "damping"))
        on = self.get(self.bodies, entry["on"])
        at = self.get(self.points, entry["at"]) if "at" in entry else on.point
        if "against" in entry and "against_at" not in entry:
            to = self.get(self.bodies, entry["against"]).point
        else:
            to = self.get(self.points, entry["against_at"])
        way = to.pos_from(at)
        length = way.magnitude()
        rate = (to.vel(self.inertial) - at.vel(self.inertial)).dot(way) / length
        pull = (stiffness * (length - free) + damping * rate) / length * way
        loads = [self.force_at(on, at, pull)]
        if "against" in entry:
            loads.append(self.force_at(self.get(self.bodies, entry["against"]), to, -pull))
        return loads

    def potential(self, formula, names):
        """The slope of an energy along each coordinate, as a force on what moves along an axis at the coordinate's rate."""
        energy, axis, loads = expression(formula, names), self.inertial.x, []
        for q in self.model.coordinates:
            name = q.func.__name__
            if name == "t" or energy.diff(q) == 0:
                continue
            point = Point(f"along {name}")
            point.set_vel(self.inertial, self.names[f"{name}'"] * axis)
            loads.append(Load(Body(name, None, point, None, self.inertial), -energy.diff(q) * axis, Vector(0)))
        return loads

    @staticmethod
    def force_at(body, at, vector):
        """What a force at a point does to a body: the same through the mass centre, and its moment there."""
        moment = Vector(0) if body.frame is None else at.pos_from(body.point).cross(vector)
        return Load(body, vector, moment)

    def torque(self, entry, vector):
        loads = []
        for key, moment in (("on", vector), ("against", -vector)):
            name = entry.get(key)
            if name is None or self.frames.get(name) is self.inertial:
                continue
            target = self.bodies.get(name) or self.get(self.frames, name)
            loads.append(Load(target, Vector(0), moment))
        return loads

    @staticmethod
    def pairs(loads):
        """Loads as SymPy's methods take them: (point, force) and (frame, torque)."""
        pairs = []
        for load in loads:
            if isinstance(load.target, ReferenceFrame):
                pairs.append((load.target, load.moment))
                continue
            pairs.append((load.target.point, load.force))
            if load.target.frame is not None:
                pairs.append((load.target.frame, load.moment))
        return [(target, vector) for target, vector in pairs if vector != 0]
