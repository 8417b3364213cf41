"""Draft of a model file: sections that are filled at random and written as TOML."""
import json
from decimal import Decimal


LENGTHS = [("m", 0), ("m", 0), ("cm", 2), ("mm", 3), ("km", -3)]
MASSES = [("kg", 0), ("kg", 0), ("g", 3), ("t", -3)]


def with_unit(random, value, units):
    """A number in one of some units, of which each is a power of ten of the SI unit."""
    unit, shift = random.choice(units)
    number = Decimal(str(value)).scaleb(shift)
    return f"{number if random.random() < 0.5 else format(number, 'f')} {unit}"


class Draft:
    """A model file in the making, with its source of random numbers and the size of its numbers."""
    def __init__(self, random, title, hostile=False):
        self.random, self.title, self.hostile = random, title, hostile
        self.sections = {name: {} for name in (
            "parameters", "expressions", "coordinates", "speeds", "frames", "points", "bodies", "joints", "particles",
            "forces", "torques", "springs", "friction", "potentials", "inputs", "reactions", "constraints", "rolling",
            "assembly", "domain")}
        self.gravity, self.start, self.tags = None, {}, set()
        self.counts, self.constrained = {}, False
        self.literals = True

    def name(self, stem):
        """A fresh name."""
        self.counts[stem] = self.counts.get(stem, 0) + 1
        return f"{stem}{self.counts[stem]}"

    def parameter(self, stem, unit, value, positive=False):
        """A new parameter; its name."""
        name = self.name(stem)
        entry = {"unit": unit, "value": value}
        if positive and value > 0:
            entry["positive"] = True
        self.sections["parameters"][name] = entry
        return name

    def number(self, low, high):
        """A short decimal between two bounds."""
        return round(self.random.uniform(low, high), self.random.choice([1, 2, 3]))

    def positive(self, stem, unit, low, high):
        """A new parameter above zero; in hostile drafts of extreme size now and then."""
        value = max(self.number(low, high), 0.1 * low, 1e-3)
        if self.hostile and self.random.random() < 0.3:
            value = self.random.choice([1e-6, 1e6, 1e-3, 1e3]) * value
            self.tags.add("extreme")
        return self.parameter(stem, unit, value, True)

    def length(self, scale=1.0):
        """A component of a position: 0, a number with a unit, or a formula of parameters."""
        r = self.random
        if self.hostile and r.random() < 0.25:
            return 0
        kind = r.random()
        if kind < 0.25:
            return 0
        if kind < 0.3 and self.literals:
            return with_unit(r, self.number(-scale, scale) or 0.3, LENGTHS)
        p = self.positive("l", "m", 0.2 * scale, scale)
        return r.choice([p, f"-{p}", f"{p}/2", f"2*{p}/3", f"-{p}/4"])

    def metres(self, value):
        """A length: a number with a unit, or a parameter where the model must not have such numbers."""
        return f"{value} m" if self.literals else self.parameter("c", "m", value)

    def lengths(self, scale=1.0):
        """Three components of a position."""
        return [self.length(scale) for _ in range(3)]

    def mass(self):
        r = self.random
        if self.hostile and r.random() < 0.15:
            self.tags.add("zero mass")
            return 0
        if not self.literals or r.random() < 0.85:
            return self.positive("m", "kg", 0.3, 3)
        return with_unit(r, max(self.number(0.3, 3), 0.1), MASSES)

    def inertia(self, frame=None):
        """Central inertia of a body in space."""
        r = self.random
        kind = r.random()
        if kind < 0.25 or (self.hostile and kind < 0.5):
            i = self.positive("J", "kg*m^2", 0.05, 0.6)
            if r.random() < 0.5:
                self.tags.add("equal inertias")
                return {"diagonal": [i, i, i]}
            return {"diagonal": [i, i, f"2*{i}" if r.random() < 0.5 else f"{i}/2"]}
        # Second moments of mass give moments that satisfy the triangle inequality.
        a, b, c = (round(r.uniform(0.02, 0.4), 3) for _ in range(3))
        x, y, z = (round(r.uniform(-0.012, 0.012), 4) for _ in range(3))
        moments = [b + c, a + c, a + b]
        if kind < 0.6:
            values = [self.parameter("I", "kg*m^2", round(v, 4), True) for v in moments]
            return {"diagonal": values}
        if kind > 0.7:
            self.tags.add("products")
            return {"diagonal": [self.parameter("I", "kg*m^2", round(v, 4), True) for v in moments],
                    "products": [self.parameter("P", "kg*m^2", v) for v in (-x, -y, -z)]}
        if not self.literals:
            return {"diagonal": [self.parameter("I", "kg*m^2", round(v, 4), True) for v in moments]}
        return {"diagonal": [f"{round(v, 4)} kg*m^2" for v in moments]}

    def fall(self):
        """Gravity along a random direction."""
        r = self.random
        if r.random() < 0.2:
            return
        g = self.parameter("g", "m/s^2", 9.81, True)
        e = [0, 0, 0]
        e[r.randrange(3)] = f"-{g}"
        if r.random() < 0.15:
            e[r.randrange(3)] = f"{g}/2"
        self.gravity = e

    def text(self):
        """The model file."""
        lines = [f"name = {json.dumps(self.title)}", ""]
        for section in ("parameters", "expressions", "coordinates", "speeds"):
            lines += self.write(section)
        lines += ["[inertial]", 'frame = "N"', 'origin = "O"', ""]
        for section in list(self.sections)[4:]:
            lines += self.write(section)
        if self.gravity:
            lines += ["[gravity]", 'frame = "N"', f"acceleration = {toml(self.gravity)}", ""]
        return "\n".join(lines)

    def write(self, section):
        entries = self.sections[section]
        return [f"[{section}]", *(f"{name} = {toml(entry)}" for name, entry in entries.items()), ""] if entries else []


def toml(value):
    """A value in TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(entry) for entry in value) + "]"
    return json.dumps(value) if isinstance(value, str) else repr(value)
