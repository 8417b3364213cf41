"""Compares the equations of mechanisms in C, NumPy and CasADi: mechanisms.py FOLDER...

Each folder has the modules of one mechanism in all three languages, and the C of each module as a shared library. At a
random state on the constraints, all languages have the same values; the unknowns solve the linear system; the Jacobians
are the slopes of the derivative; and the power is the rate of the energy, unless a motion is given.
"""

import ctypes
import glob
import importlib.util
import inspect
import os
import re
import sys

import numpy

STEP = 1e-6
failures = []
counts = {}


def load(path):
    folder = os.path.dirname(path)
    sys.path.insert(0, folder)
    for name in ("tripos_arrays", "tripos_casadi"):
        sys.modules.pop(name, None)
    spec = importlib.util.spec_from_file_location(os.path.basename(path)[:-3], path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    sys.path.pop(0)
    return module


def compare(place, what, found, expected, share):
    """Notes a failure unless two lists differ by less than a share of the largest entry."""
    counts[what.split()[0]] = counts.get(what.split()[0], 0) + 1
    found, expected = numpy.ravel(found), numpy.ravel(expected)
    if found.shape != expected.shape or (numpy.isfinite(found) != numpy.isfinite(expected)).any():
        failures.append(f"{place} {what}: {found} is not {expected}")
        return
    finite = numpy.isfinite(found)
    size = max(1e-3, abs(expected[finite]).max(initial=0))
    if abs(found - expected)[finite].max(initial=0) > share * size:
        failures.append(f"{place} {what}: {found} is not {expected}")


def arguments(function):
    return [name for name in inspect.signature(function).parameters if name not in ("xp", "corrections")]


def call(function, given):
    with numpy.errstate(all="ignore"):
        result = function(*(given[name] for name in arguments(function)))
    parts = result if isinstance(result, tuple) else (result,)
    return numpy.concatenate([numpy.ravel(numpy.asarray(part, dtype=float)) for part in parts])


class Library:
    """The functions of one module in C."""

    def __init__(self, stem):
        self.name = os.path.basename(stem)
        self.library = ctypes.CDLL(stem + ".so")
        with open(stem + ".h") as file:
            self.header = file.read()

    def call(self, name, given, first, size):
        """The value of a function; `first` is the length of the first of two results."""
        start = self.header.find(f"{self.name}_{name}(")
        if start < 0:
            return None
        returned = self.header[self.header.rfind("\n", 0, start) + 1 : start].split()[0]
        listed = self.header[start : self.header.index(";", start)]
        listed = listed[listed.index("(") + 1 : listed.rindex(")")].split(",")
        names = [re.findall(r"[A-Za-z_]\w*", re.sub(r"\[.*", "", argument))[-1] for argument in listed]
        out, out_2 = numpy.zeros(size + 1), numpy.zeros(size + 1)
        arrays = {**given, "out": out, "out_2": out_2}
        function = getattr(self.library, f"{self.name}_{name}")
        function.restype = {"int": ctypes.c_int, "void": None}.get(returned, ctypes.c_double)
        values = [numpy.ascontiguousarray(arrays[n], dtype=float) for n in names]
        result = function(*(value.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for value in values))
        if "out" not in names:
            return numpy.array([result])
        return numpy.concatenate((out[:first], out_2[: size - first])) if "out_2" in names else out[:size]


def check(folder, path):
    place = path[len(os.path.dirname(folder)) + 1 : -3]
    module, casadi = load(path), load(path[:-3] + "_casadi.py")
    library = Library(path[:-3])
    in_rates = "q_dot" in arguments(module.mass_matrix)
    random = numpy.random.default_rng(len(place))
    p = numpy.asarray(module.DEFAULTS, dtype=float)
    q = random.uniform(0.2, 1.2, len(module.COORDINATES))
    v = random.uniform(-1.5, 1.5, len(module.VARIABLES))
    if hasattr(module, "project"):
        several = numpy.stack([p, 1.001 * p], axis=1)
        together = numpy.concatenate(module.project(several, q, v))
        for at in range(2):
            alone = numpy.concatenate(module.project(several[:, at], q, v))
            compare(place, "project with several parameters", together[:, at], alone, 1e-9)
        q, v = module.project(p, q, v)
        if not (numpy.isfinite(q).all() and numpy.isfinite(v).all()):
            counts["open"] = counts.get("open", 0) + 1
            return
    given = {"p": p, "q": q, "u": v, "q_dot": v}
    if in_rates:
        given["u"] = call(module.generalized_speeds, given)
    given["x"] = random.uniform(-2, 2, call(module.forcing, given).size)
    given["v_dot"] = given["x"][: v.size]
    for name, function in list(vars(module).items()):
        own = inspect.isfunction(function) and function.__module__ == module.__name__
        if not own or name in ("project", "state_derivative"):
            continue
        value = call(function, given)
        first = q.size if name == "derivative" else value.size - given["x"].size
        found = library.call(name, given, first, value.size)
        compare(place, f"C {name}", found, value, 1e-9)
        if name in casadi.FUNCTIONS:
            result = casadi.function(name).call([given[n] for n in casadi.FUNCTIONS[name][1]])
            compare(place, f"CasADi {name}", numpy.concatenate([numpy.ravel(part.full()) for part in result]), value, 1e-9)
    identities(place, module, given, in_rates)


def identities(place, module, given, in_rates):
    p, q = given["p"], given["q"]
    v = given["q_dot" if in_rates else "u"]

    def at(name, dp=0, dx=numpy.zeros(q.size + v.size)):
        moved = {**given, "p": p + dp, "q": q + dx[: q.size], "q_dot" if in_rates else "u": v + dx[q.size :]}
        return call(getattr(module, name), moved)

    def slope(name, direction, of="dx"):
        """Slope by differences of two steps: their errors, which grow with the square of the step, cancel."""
        wide, narrow = (
            (at(name, **{of: step * direction}) - at(name, **{of: -step * direction})) / (2 * step)
            for step in (2 * STEP, STEP)
        )
        return (4 * narrow - wide) / 3

    unknowns = call(module.unknowns, given)
    if numpy.isfinite(unknowns).all():
        rest = call(module.residual, {**given, "x": unknowns})
        compare(place, "residual of the unknowns", rest / (1 + abs(unknowns).max()), 0 * rest, 1e-6)
        if hasattr(module, "accelerations"):
            compare(place, "unknowns solved for", unknowns[: v.size], at("accelerations"), 1e-6)
    if not hasattr(module, "derivative"):
        return
    x = q.size + v.size
    for name, of, count in [("jacobian", "dx", x), ("parameter_jacobian", "dp", p.size)]:
        if hasattr(module, name) and count:
            columns = [slope("derivative", direction, of) for direction in numpy.eye(count)]
            compare(place, f"{name} by differences", at(name), numpy.transpose(columns), 1e-4)
    if not GIVEN:
        rates = at("derivative")
        power = at("power") if hasattr(module, "power") else [0.0]
        # Near a dead point both energies change fast and their sum does not: each stands on a side of its own.
        rate = power - slope("potential_energy", rates)
        compare(place, "power by differences", slope("kinetic_energy", rates), rate, 1e-4)
    if hasattr(module, "regressor"):
        for table, values in [("regressor", "inertial_parameters"), ("base_regressor", "base_parameters")]:
            if hasattr(module, table):
                forces = at(table).reshape(v.size, -1) @ at(values) + at("regressor_rest")
                compare(place, f"{table} times {values}", forces, at("inverse_dynamics"), 1e-8)


for folder in sys.argv[1:]:
    GIVEN = os.path.exists(os.path.join(folder, "given"))
    for path in sorted(glob.glob(os.path.join(folder, "*.py"))):
        if not path.endswith(("_casadi.py", "_simulate.py")) and "tripos_" not in os.path.basename(path):
            check(folder, path)
print(counts)
sys.exit("\n".join(failures[:20]) if failures else 0)
