"""Formulas of model files, read by this program alone and evaluated over any kind of number."""
import functools, math, re
from jets import function, DERIVATIVES

UNITS = {"mm": 1e-3, "cm": 1e-2, "km": 1e3, "g": 1e-3, "t": 1e3, "ms": 1e-3, "min": 60.0, "h": 3600.0, "kN": 1e3,
         "kJ": 1e3, "kW": 1e3, "kPa": 1e3, "MPa": 1e6, "deg": math.pi / 180, "rev": 2 * math.pi, "rpm": math.pi / 30}
SI = {"kg", "m", "s", "rad", "N", "J", "W", "Pa", "Hz", "1"}

VECTOR = re.compile(r"\b(p|v|omega|force|torque)\s*\(([^()]*)\)\s*@\s*(\w+)\s*\[\s*([123])\s*\]")
DISTANCE = re.compile(r"\bdistance\s*\(\s*(\w+)\s*,\s*(\w+)\s*\)")
WITH_UNIT = re.compile(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s+([A-Za-z][\w*/^]*)\s*")
NAME = re.compile(r"(?<![\w.\"])([A-Za-z]\w*)('{0,2})(\s*\()?")


@functools.lru_cache(maxsize=None)
def compiled(text):
    """Python code of a formula in a scope `S` and functions `F`."""
    places = []

    def keep(code):
        places.append(code)
        return f"\0{len(places) - 1}\0"

    text = VECTOR.sub(lambda m: keep(f"S.component({m[1]!r}, {m[2].strip()!r}, {m[3]!r}, {m[4]})"), text)
    text = DISTANCE.sub(lambda m: keep(f"S.distance({m[1]!r}, {m[2]!r})"), text)

    def name(m):
        if m[3]:
            if m[1] in ("min", "max", "atan2"):
                return keep(f"S.{m[1]}") + "("
            if m[1] not in DERIVATIVES:
                raise ValueError(f"unknown function {m[1]}")
            return keep(f"F[{m[1]!r}]") + "("
        return keep(f"S[{(m[1] + m[2])!r}]")

    text = re.sub(r"\d+(\.\d*)?([eE][-+]?\d+)?|\.\d+([eE][-+]?\d+)?", lambda m: m[0], text)
    text = NAME.sub(name, protect_exponents(text)).replace("^", "**").replace("\1", "e")
    text = re.sub(r"\0(\d+)\0", lambda m: places[int(m[1])], text)
    return compile(text.strip(), "formula", "eval")


def protect_exponents(text):
    """The exponent letter of numbers such as 1e-3 is no name."""
    return re.sub(r"(?<![\w.])(\d+\.?\d*|\.\d+)[eE]([-+]?\d)", "\\1\1\\2", text)


class Functions(dict):
    def __missing__(self, name):
        self[name] = functools.partial(function, name)
        return self[name]


FUNCTIONS = Functions()


def evaluate(text, scope):
    """The value of a formula, or of a plain number."""
    if isinstance(text, (int, float)):
        return float(text)
    if WITH_UNIT.fullmatch(text):
        return quantity(text, scope)
    return eval(compiled(text), {"S": scope, "F": FUNCTIONS})


def names(text):
    """Names in a formula, with primes."""
    if isinstance(text, (int, float)):
        return set()
    bare = VECTOR.sub(" ", DISTANCE.sub(" ", protect_exponents(text)))
    return {m[1] + m[2] for m in NAME.finditer(bare) if not m[3]}


def has_velocity(text):
    """Whether a formula contains a component of a velocity."""
    return any(m[1] in ("v", "omega") for m in VECTOR.finditer(text))


class Numbers(dict):
    """Scope of constants: `pi`, `deg` and given names."""
    def __init__(self, values=()):
        super().__init__({"pi": math.pi, "deg": math.pi / 180})
        self.update(values)


def quantity(value, scope):
    """A number, a formula of numbers, or a number with a unit."""
    if isinstance(value, (int, float)):
        return float(value)
    m = WITH_UNIT.fullmatch(value)
    if not m:
        return evaluate(value, scope)
    number, factor = float(m[1]), 1.0
    for sign, unit, power in re.findall(r"([*/]?)([A-Za-z]+)(?:\^(\d+))?", m[2]):
        if unit not in SI and unit not in UNITS:
            raise ValueError(f"unit {unit}")
        part = UNITS.get(unit, 1.0) ** int(power or 1)
        factor = factor / part if sign == "/" else factor * part
    return number * factor
