"""Evaluates functions of generated Python: evaluate.py numpy|jax|casadi MODULE INPUT OUTPUT FUNCTIONS [TIMES].

The input has the counts of states and of the entries of p, q, v, u and x, as 8-byte integers, then these entries,
state by state, as doubles. The output has the values of each function that the module has, state by state. The file of
times gets the seconds that the module takes to be imported, and those of each function for one state of all.
"""

import importlib
import sys
import time

import numpy

FUNCTIONS = sys.argv[5].split(",")


def states(path):
    with open(path, "rb") as file:
        counts = numpy.fromfile(file, dtype="<i8", count=6)
        values = numpy.fromfile(file, dtype="<f8").reshape(counts[0], -1).T
    ends = numpy.cumsum(counts[1:])
    return dict(zip("pqvux", numpy.split(values, ends[:-1])))


def flat(result, count):
    parts = result if isinstance(result, tuple) else (result,)
    return numpy.concatenate([numpy.asarray(part, dtype=float).reshape(-1, count) for part in parts]).T


def seconds(call, count):
    """Least time of a call for one of the states, of three samples."""
    samples = []
    for _ in range(3):
        begin, calls = time.perf_counter(), 0
        while time.perf_counter() - begin < 5e-3:
            call()
            calls += 1
        samples.append((time.perf_counter() - begin) / calls / count)
    return min(samples)


def arrays(module, xp, name, given, count):
    """Values of a function, and the call that gives them."""
    import inspect

    function = getattr(module, name)
    names = [n for n in inspect.signature(function).parameters if n not in ("xp", "corrections")]
    call = lambda: function(*(given[n] for n in names), xp=xp)
    return flat(call(), count), call


def expressions(module, name, given, count):
    """Values of a function of expressions, and the call that gives them."""
    body, names = module.FUNCTIONS[name]
    function = module.function(name).map(count)
    arguments = [given[n] for n in names]
    columns = []
    for result in function.call(arguments):
        values = numpy.asarray(result.full(), dtype=float)
        rows = values.shape[0]
        width = values.shape[1] // count
        # The states stand side by side.
        columns.append(values.reshape(rows, count, width).transpose(1, 0, 2).reshape(count, rows * width))
    return numpy.concatenate(columns, axis=1), lambda: function.call(arguments)


def main():
    kind, name, given, out = sys.argv[1:5]
    given = states(given)
    count = given["q"].shape[1]
    begin = time.perf_counter()
    module = importlib.import_module(name)
    times = [time.perf_counter() - begin]
    q_dot = "q_dot" in module_arguments(module, kind)
    named = {"p": given["p"], "q": given["q"], "u": given["u"], "x": given["x"]}
    named["q_dot" if q_dot else "u"] = given["v"]
    if q_dot:
        named["u"] = given["u"]
    named["v_dot"] = given["x"][: given["v"].shape[0]]
    with open(out, "wb") as file, numpy.errstate(all="ignore"):
        for function in FUNCTIONS:
            if kind == "casadi":
                values, call = expressions(module, function, named, count)
            else:
                values, call = arrays(module, namespace(kind), function, named, count)
            numpy.ascontiguousarray(values).tofile(file)
            if len(sys.argv) > 6:
                times.append(seconds(call, count))
    if len(sys.argv) > 6:
        numpy.array(times).tofile(sys.argv[6])


def module_arguments(module, kind):
    import inspect

    return list(inspect.signature(module.mass_matrix).parameters)


def namespace(kind):
    if kind == "jax":
        import jax

        jax.config.update("jax_enable_x64", True)
        return jax.numpy
    return numpy


main()
