"""A model file as this program reads it: frames, points, bodies and joints at one configuration.

Everything is in components along the axes of the inertial frame. Only `docs/model.md` was used to write this file; no
line is shared with Tripos.
"""
import tomllib
import numpy as np
import rotation
from jets import Jet, stack
from formula import Numbers, evaluate, quantity

TURNS = {"pin": 1, "slider": 0, "cylinder": 1, "screw": 1, "universal": 2, "ball": 3, "planar": 1, "free": 3, "weld": 0}
SHIFTS = {"pin": 0, "slider": 1, "cylinder": 1, "screw": 0, "universal": 0, "ball": 0, "planar": 2, "free": 3,
          "weld": 0}


class Unknown(Exception):
    """A part of a model that this program does not know."""


class Joint:
    """A joint of a model with the names of its coordinates and speeds."""
    def __init__(self, name, entry, mechanism):
        self.name, self.entry, self.kind, self.body = name, entry, entry["kind"], entry["body"]
        self.to, self.closes = entry.get("to"), entry["body"] in mechanism.placed
        self.euler = entry.get("sequence") == "euler"
        count = TURNS[self.kind] + SHIFTS[self.kind] + self.euler
        self.coordinates = entry.get("coordinates") or self.default("q", count)
        if self.closes:
            self.coordinates = []
        self.angular = self.kind in ("ball", "free")
        self.axis = entry.get("axis", 3)
        self.speeds = entry["speeds"] if "speeds" in entry else self.default_speeds()

    def default_speeds(self):
        """Names by docs/model.md: the speed of `q2` is `u2`; turns are named after the axes of the body."""
        first = {"ball": 0, "free": 3}.get(self.kind, len(self.coordinates))
        turns = range(first + 1, first + 4) if self.angular else ()
        if not self.entry.get("coordinates"):
            return [f"u{c[1:]}" for c in self.coordinates[:first]] + [f"u_{self.name}_{k}" for k in turns]
        if any(not c.startswith("q") for c in self.coordinates) or self.euler:
            raise Unknown("default names of speeds")
        return [f"u{c[1:]}" for c in self.coordinates]

    def default(self, letter, count):
        return [f"{letter}_{self.name}" + (str(i + 1) if count > 1 else "") for i in range(count)]


class Mechanism:
    """A model file."""
    def __init__(self, text):
        self.data = data = tomllib.loads(text)
        self.text = text
        if "counts" in data:
            raise Unknown("counts")
        self.inertial, self.origin = data["inertial"]["frame"], data["inertial"]["origin"]
        self.frames, self.points = data.get("frames", {}), data.get("points", {})
        self.bodies, self.particles = data.get("bodies", {}), data.get("particles", {})
        self.placed = {name for name, b in self.bodies.items() if b.get("frame") in self.frames or "frame" in b
                       and not any(j["body"] == name for j in data.get("joints", {}).values())}
        self.joints = {}
        for name, entry in data.get("joints", {}).items():
            joint = Joint(name, entry, self)
            self.joints[name] = joint
            self.placed.add(joint.body)
        self.joint_of = {j.body: j for j in self.joints.values() if not j.closes}
        self.coordinates = list(data.get("coordinates", {}))
        for joint in self.joints.values():
            self.coordinates += [c for c in joint.coordinates if c not in self.coordinates]
        self.speeds = dict(data.get("speeds", {}))
        for joint in self.joints.values():
            if not joint.closes and joint.speeds:
                self.speeds.update((s, (joint, i)) for i, s in enumerate(joint.speeds))
        self.joint_frames = {self.bodies[j.body].get("frame", f"{j.body}_frame"): j for j in self.joint_of.values()}
        self.joint_centres = {self.bodies[j.body].get("centre", f"{j.body}_centre"): j for j in self.joint_of.values()}
        self.parameters = {}

    def values(self, given=None):
        """Numbers of the parameters: defaults, replaced by those of a scene."""
        scope = Numbers()
        for name, entry in self.data.get("parameters", {}).items():
            value = entry if isinstance(entry, str) else entry.get("value")
            if given and name in given:
                value = given[name]
            if value is None:
                raise Unknown(f"no value of {name}")
            scope[name] = quantity(value, scope)
        return scope

    def frame_of(self, body):
        return self.bodies[body].get("frame", f"{body}_frame")

    def centre_of(self, body):
        return self.bodies[body].get("centre", f"{body}_centre") if body in self.bodies \
            else self.particles[body]["point"]


class Configuration:
    """Frames and points of a mechanism at given coordinates and time, with two derivatives in (q, t)."""
    def __init__(self, mechanism, q, t=0.0, parameters=None):
        self.m = mechanism
        self.size = len(mechanism.coordinates) + 1
        self.scope = ConfigurationScope(self, parameters if parameters is not None else mechanism.values())
        for i, name in enumerate(mechanism.coordinates):
            self.scope[name] = Jet.variable(q[name], i, self.size, True)
        self.scope["t"] = self.time = Jet.variable(t, self.size - 1, self.size, True)
        self.known_frames = {mechanism.inertial: self.time.constant(np.eye(3))}
        self.known_points = {mechanism.origin: self.time.constant(np.zeros(3))}
        self.expressions = mechanism.data.get("expressions", {})

    def value(self, text):
        return evaluate(text, self.scope)

    def vector(self, texts):
        return stack([self.time.lift(self.value(text)) for text in texts])

    def frame(self, name):
        """Rotation matrix: columns are the axes of the frame."""
        if name not in self.known_frames:
            self.known_frames[name] = self.time.lift(self.make_frame(name))
        return self.known_frames[name]

    def make_frame(self, name):
        m = self.m
        if name in m.joint_frames:
            joint = m.joint_frames[name]
            return rotation.product(self.joint_axes(joint), self.joint_turn(joint))
        base, turn = name, None
        for suffix, count in (("_turn1", 1), ("_turn2", 2)):
            if name.endswith(suffix) and name not in m.frames:
                base, turn = name[:-len(suffix)], count
        if base not in m.frames:
            raise Unknown(f"frame {name}")
        entry = m.frames[base]
        parent = self.frame(entry["from"])
        if "euler_parameters" in entry:
            return parent @ rotation.euler([self.value(e) for e in entry["euler_parameters"]])
        if "sequence" in entry:
            digits, angles = entry["sequence"], [self.value(a) for a in entry["angles"]]
            space = entry.get("fixed") == "space"
            if turn:
                if space:
                    raise Unknown("frames of turns about fixed axes")
                digits, angles = digits[:turn], angles[:turn]
            return parent @ self.time.lift(rotation.sequence(digits, angles, space))
        if turn:
            raise Unknown(f"frame {name}")
        axis = entry["axis"]
        if not isinstance(axis, int):
            axis = [float(self.constant(a)) for a in axis]
        return parent @ self.time.lift(rotation.about(axis, self.value(entry["angle"])))

    def constant(self, text):
        value = self.value(text)
        return value.v if isinstance(value, Jet) else value

    def joint_axes(self, joint, of="turned", body=None):
        """Axes of a joint on the body `to` (or on the body itself for `body_turned`)."""
        body = joint.to if body is None else body
        base = self.frame(self.m.frame_of(body)) if body else self.known_frames[self.m.inertial]
        turned = joint.entry.get(of)
        if not turned:
            return base
        return base @ self.time.lift(rotation.sequence(turned["sequence"], [self.value(a) for a in turned["angles"]]))

    def joint_axis(self, joint):
        return joint.axis if isinstance(joint.axis, int) else [float(self.constant(a)) for a in joint.axis]

    def turns(self, joint):
        return [self.scope[name] for name in joint.coordinates]

    def joint_turn(self, joint):
        """Matrix from the joint's axes to the frame of its body."""
        q, kind = self.turns(joint), joint.kind
        if kind in ("pin", "cylinder", "screw"):
            return rotation.about(self.joint_axis(joint), q[0])
        if kind in ("slider", "weld"):
            return np.eye(3)
        if kind == "planar":
            return rotation.about(joint.axis, q[2])
        if kind == "universal":
            axes = joint.entry.get("axes", [1, 2])
            return rotation.product(rotation.about(axes[0], q[0]), rotation.about(axes[1], q[1]))
        if kind == "free":
            q = q[3:]
        return rotation.euler(q) if joint.euler else rotation.sequence(joint.entry.get("sequence", "123"), q)

    def joint_shift(self, joint):
        """Displacement of the joint, in the joint's axes."""
        q, kind = self.turns(joint), joint.kind
        if kind in ("slider", "cylinder", "screw"):
            axis = self.joint_axis(joint)
            e = np.eye(3)[axis - 1] if isinstance(axis, int) else np.asarray(axis) / np.linalg.norm(axis)
            length = q[-1] if kind != "screw" else self.value(joint.entry["lead"]) * q[0] * (1 / (2 * np.pi))
            return stack([length * e[i] for i in range(3)])
        if kind == "planar":
            parts = [0.0, 0.0, 0.0]
            parts[joint.axis % 3], parts[(joint.axis + 1) % 3] = q[0], q[1]
            return stack(parts)
        return stack(q[:3]) if kind == "free" else None

    def place_on(self, body, place):
        """A place of a body or of the ground: a point, or components."""
        if isinstance(place, str):
            return self.point(place)
        frame = self.frame(self.m.frame_of(body)) if body else self.known_frames[self.m.inertial]
        if body is None:
            start = self.point(self.m.origin)
        elif body in self.m.joint_of:
            start = self.joint_point(self.m.joint_of[body])
        else:
            start = self.point(self.m.centre_of(body))
        return start if place is None else start + frame @ self.vector(place)

    def joint_point(self, joint):
        """The point of the joint's body at the joint."""
        start, shift = self.place_on(joint.to, joint.entry.get("at")), self.joint_shift(joint)
        return start if shift is None else start + self.joint_axes(joint) @ shift

    def point(self, name):
        if name not in self.known_points:
            self.known_points[name] = self.make_point(name)
        return self.known_points[name]

    def make_point(self, name):
        m = self.m
        if name in m.joint_centres:
            joint = m.joint_centres[name]
            start, centre = self.joint_point(joint), joint.entry.get("centre")
            return start if centre is None else start + self.frame(m.frame_of(joint.body)) @ self.vector(centre)
        if name in m.joints:
            joint = m.joints[name]
            return self.joint_point(joint) if not joint.closes else self.place_on(joint.body, joint.entry["body_at"])
        if name not in m.points:
            raise Unknown(f"point {name}")
        entry = m.points[name]
        return self.point(entry["from"]) + self.frame(entry["frame"]) @ self.vector(entry["position"])

    def body_frame(self, body):
        return self.frame(self.m.frame_of(body))

    def centre(self, body):
        return self.point(self.m.centre_of(body))


class ConfigurationScope(Numbers):
    """Names of formulas of the configuration: parameters, coordinates, time, expressions, positions, distances."""
    def __init__(self, configuration, parameters):
        super().__init__(parameters)
        self.configuration = configuration

    def __missing__(self, name):
        text = self.configuration.expressions.get(name)
        if text is None:
            raise Unknown(f"name {name}")
        self[name] = evaluate(text if not isinstance(text, dict) else text["value"], self)
        return self[name]

    def component(self, kind, argument, frame, axis):
        if kind != "p":
            raise Unknown(f"{kind}(…) in a formula of the configuration")
        return (self.configuration.frame(frame)[:, axis - 1] * self.configuration.point(argument)).sum()

    def distance(self, a, b):
        d = self.configuration.point(a) - self.configuration.point(b)
        return (d * d).sum() ** 0.5

    min = staticmethod(lambda *xs: min(xs, key=lambda x: x.v if isinstance(x, Jet) else x))
    max = staticmethod(lambda *xs: max(xs, key=lambda x: x.v if isinstance(x, Jet) else x))
