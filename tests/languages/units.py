"""Checks Functional Mock-up Units by FMPy: units.py LIST ANSWERS. The list is JSON of {"unit", "t", "state", "slopes", "constraints"}.

Each unit is validated, run to the end of its scene by co-simulation and by model exchange, and asked for directional
and adjoint derivatives, which are compared with differences. Its state is stored and restored in the middle of a run.
The answers are a JSON list of what was found.
"""

import importlib
import json
import shutil
import sys
import time

import numpy
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu


def variables(description):
    return {variable.name: variable.valueReference for variable in description.modelVariables}


def error_of(found, expected):
    """The largest error over the size of its component, or over 1."""
    names = found.keys() & expected.keys()
    return max(abs(found[name] - expected[name]) / max(1, abs(expected[name])) for name in names)


def slopes(unit, folder, description, start):
    """The largest difference between derivatives and differences, and between both kinds of derivatives."""
    names = variables(description)
    unknowns = [u.variable.valueReference for u in description.derivatives]
    unknowns += [u.variable.valueReference for u in description.outputs if u.variable.initial != "exact"]
    known = [v for v in description.modelVariables if v.causality in ("parameter", "input") or v.initial == "exact"]
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="slopes",
    )
    slave.instantiate()
    slave.enterInitializationMode(startTime=start)
    slave.exitInitializationMode()
    # A state that is nowhere special.
    moved = numpy.random.default_rng(5)
    references = [v.valueReference for v in known]
    values = numpy.array(slave.getFloat64(references))
    values = values * (1 + 0.01 * moved.standard_normal(values.shape)) + 0.01 * moved.standard_normal(values.shape)
    slave.setFloat64(references, list(values))
    seed = moved.standard_normal(len(references))
    product = numpy.array(slave.getDirectionalDerivative(unknowns, references, list(seed)))
    step = 1e-6
    sides = []
    for sign in (1, -1):
        slave.setFloat64(references, list(values + sign * step * seed))
        sides.append(numpy.array(slave.getFloat64(unknowns)))
    slave.setFloat64(references, list(values))
    differences = (sides[0] - sides[1]) / (2 * step)
    weights = moved.standard_normal(len(unknowns))
    adjoint = numpy.array(slave.getAdjointDerivative(unknowns, references, list(weights), len(references)))
    slave.terminate()
    slave.freeInstance()
    size = 1 + abs(product).max()
    transposed = abs(weights @ product - adjoint @ seed) / (1 + abs(weights @ product))
    return float(abs(product - differences).max() / size), float(transposed)


def restored(folder, description, start, end):
    """The difference between a run and the same run from a state that was stored as bytes in its middle."""
    states = [v.valueReference for v in description.modelVariables if v.initial == "exact"]
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="restored",
    )
    slave.instantiate()
    slave.enterInitializationMode(startTime=start)
    slave.exitInitializationMode()
    middle = start + 0.01 * (end - start)
    slave.doStep(start, middle - start)
    state = slave.getFMUState()
    data = slave.serializeFMUState(state)
    slave.doStep(middle, middle - start)
    first = slave.getFloat64(states)
    again = slave.deserializeFMUState(data)
    slave.setFMUState(again)
    slave.doStep(middle, middle - start)
    second = slave.getFloat64(states)
    for kept in (state, again):
        slave.freeFMUState(kept)
    slave.terminate()
    slave.freeInstance()
    return float(abs(numpy.array(first) - numpy.array(second)).max())


def openness(folder, kind, end, emitted):
    """The largest residual of the constraints at the end of a coarse run, by the emitted Python."""
    sys.path.insert(0, emitted["folder"])
    model = importlib.import_module(emitted["module"])
    names = [*model.PARAMETERS, *model.COORDINATES, *model.VARIABLES]
    run = simulate_fmu(folder, fmi_type=kind, relative_tolerance=1e-3, stop_time=end, output=names)[-1]
    values = [numpy.array([run[name] for name in list_]) for list_ in (model.PARAMETERS, model.COORDINATES, model.VARIABLES)]
    return float(abs(numpy.asarray(model.constraints(*values))).max())


def check(entry):
    unit, end, expected = entry["unit"], entry["t"], entry["state"]
    description = read_model_description(unit)
    start = float(description.defaultExperiment.startTime)
    found = {"unit": unit, "problems": validate_fmu(unit)}
    folder = extract(unit)
    try:
        began = time.perf_counter()
        names = [v.name for v in description.modelVariables if v.initial == "exact"]
        settings = dict(start_time=start, stop_time=end, output=names)
        if description.fmiVersion != "2.0":
            settings["early_return_allowed"] = True
        run = simulate_fmu(folder, fmi_type="CoSimulation", output_interval=(end - start) / 20, **settings)[-1]
        found["ended"] = float(run["time"])
        found["cosimulation_s"] = time.perf_counter() - began
        found["cosimulation"] = float(error_of({n: float(run[n]) for n in names}, expected)) if run["time"] == end else None
        run = simulate_fmu(
            folder, fmi_type="ModelExchange", relative_tolerance=1e-9, output_interval=(end - start) / 1000, **settings
        )[-1]
        found["ended_exchange"] = float(run["time"])
        found["exchange"] = float(error_of({n: float(run[n]) for n in names}, expected)) if run["time"] == end else None
        if entry["constraints"]:
            found["open"] = openness(folder, "CoSimulation", end, entry["constraints"])
            found["open_exchange"] = openness(folder, "ModelExchange", end, entry["constraints"])
        if description.fmiVersion == "2.0":
            return found
        if entry["slopes"]:
            found["slopes"], found["transposed"] = slopes(unit, folder, description, start)
        found["restored"] = restored(folder, description, start, end)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return found


with open(sys.argv[1]) as file:
    answers = []
    for entry in json.load(file):
        try:
            answers.append(check(entry))
        except Exception as error:
            answers.append({"unit": entry["unit"], "problems": [repr(error)]})
with open(sys.argv[2], "w") as file:
    json.dump(answers, file)
