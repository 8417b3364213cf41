"""Applied loads of a model at one state: wrenches on bodies, generalized forces, and their power."""
import numpy as np
from formula import evaluate


class Wrench:
    """A force at a place, or a torque, on a body, a particle or a frame."""
    def __init__(self, on, force=None, place=None, torque=None, source=""):
        self.on, self.force, self.place, self.torque, self.source = on, force, place, torque, source

    def generalized(self, i):
        """Generalized forces along the rates of (q, t)."""
        if self.force is not None:
            return i.material_jacobian(self.on, self.place).T @ self.force
        frame = i.m.frame_of(self.on) if self.on in i.m.bodies else self.on
        return i.turning(frame).jacobian.T @ self.torque


def is_ground(i, name):
    return name is None or name in ("ground", i.m.inertial)


def pair(i, on, against, force, place, against_place, source):
    wrenches = []
    if not is_ground(i, on):
        wrenches.append(Wrench(on, force, place, source=source))
    if not is_ground(i, against):
        wrenches.append(Wrench(against, -force, against_place, source=source))
    return wrenches


def place_of(i, entry, point, body):
    """Place of the key `point`, by default the centre of the body under the key `body`."""
    if point in entry:
        return i.point(entry[point]).v
    return None if is_ground(i, entry.get(body)) else i.centre(entry[body]).v


def forces(i):
    for name, entry in i.m.data.get("forces", {}).items():
        force = i.frame(entry["frame"]).v @ i.numbers(entry["vector"])
        place = place_of(i, entry, "at", "on")
        against = i.point(entry["against_at"]).v if "against_at" in entry else place
        if entry.get("against") in i.m.particles:
            against = i.centre(entry["against"]).v
        yield from pair(i, entry["on"], entry.get("against"), force, place, against, name)


def torques(i):
    for name, entry in i.m.data.get("torques", {}).items():
        torque = i.frame(entry["frame"]).v @ i.numbers(entry["vector"])
        yield Wrench(entry["on"], torque=torque, source=name)
        if not is_ground(i, entry.get("against")):
            yield Wrench(entry["against"], torque=-torque, source=name)


def springs(i):
    for name, entry in i.m.data.get("springs", {}).items():
        a, b = place_of(i, entry, "at", "on"), place_of(i, entry, "against_at", "against")
        line = a - b
        d = np.linalg.norm(line)
        k, free, c = (i.number(entry.get(key, 0)) for key in ("stiffness", "free_length", "damping"))
        va = i.material_jacobian(entry["on"], a) @ i.rates
        vb = 0 if is_ground(i, entry.get("against")) else i.material_jacobian(entry["against"], b) @ i.rates
        pull = k * (d - free) + c * (line / d) @ (va - vb) if (free or c) else k * d
        yield from pair(i, entry["on"], entry.get("against"), -pull * line / d, a, b, name)


def resistance(i, entry, slip):
    """Friction opposite to a slip, with smoothing and Stribeck's excess."""
    s0, size2 = i.number(entry["smoothing"]), float(slip @ slip)
    if "torque" in entry:
        level, scale = i.number(entry["torque"]), 1.0
    else:
        level, scale = i.number(entry["coefficient"]), i.number(entry["normal_force"])
    if "static" in entry:
        level = level + (i.number(entry["static"]) - level) * np.exp(-size2 / i.number(entry["stribeck"])**2)
    return -scale * level * slip / np.sqrt(size2 + s0**2)


def frictions(i):
    for name, entry in i.m.data.get("friction", {}).items():
        against = entry.get("against")
        if "torque" in entry:
            axis = i.frame(entry["frame"]).v[:, entry["axis"] - 1]
            spin = i.turning(i.m.frame_of(entry["on"])).value
            spin = spin - (0 if is_ground(i, against) else i.turning(i.m.frame_of(against)).value)
            torque = resistance(i, entry, axis * (axis @ spin))
            yield Wrench(entry["on"], torque=torque, source=name)
            if not is_ground(i, against):
                yield Wrench(against, torque=-torque, source=name)
            continue
        place = place_of(i, entry, "at", "on")
        slip = i.material_jacobian(entry["on"], place) @ i.rates
        if not is_ground(i, against):
            slip = slip - i.material_jacobian(against, place) @ i.rates
        if "normal" in entry:
            normal = i.frame(entry["frame"]).v[:, entry["normal"] - 1]
            slip = slip - normal * (normal @ slip)
        yield from pair(i, entry["on"], against, resistance(i, entry, slip), place, place, name)


def gravity(i):
    entry = i.m.data.get("gravity")
    if entry:
        g = np.array([float(i.constant(a)) for a in entry["acceleration"]])
        for name, body in [*i.m.bodies.items(), *i.m.particles.items()]:
            yield Wrench(name, float(i.constant(body.get("mass", 0))) * g, i.centre(name).v, source="gravity")


def applied(i):
    """All applied wrenches, gravity included; potentials of the section `potentials` are not wrenches."""
    return [*gravity(i), *forces(i), *torques(i), *springs(i), *frictions(i)]


def potential(i):
    """The energy under `potentials` and of the springs, with its slopes in (q, t)."""
    total = i.time.constant(0.0)
    for entry in i.m.data.get("potentials", {}).values():
        total = total + evaluate(entry["value"] if isinstance(entry, dict) else entry, i.scope)
    return total


def gravity_energy(i):
    """−Σ m g·r with r from the origin."""
    return -sum(float(w.force @ (w.place - i.point(i.m.origin).v)) for w in gravity(i))
