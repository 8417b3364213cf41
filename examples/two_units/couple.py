"""Runs two mock-up units together, a cart and its controller: couple.py CART.fmu CONTROLLER.fmu.

The units exchange values at equal instants: the cart gives its place and velocity, the controller its force. Both
take the last values through a step, so the error of the coupling is proportional to the step. The motion of both
together is linear, and the matrix exponential gives it exactly.
"""

import shutil
import sys

import numpy
from fmpy import extract, read_model_description
from fmpy.fmi3 import FMU3Slave
from scipy.linalg import expm

END = 5.0


class Unit:
    """A unit in co-simulation, whose variables have names."""

    def __init__(self, path):
        description = read_model_description(path)
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        self.folder = extract(path)
        self.slave = FMU3Slave(
            guid=description.guid,
            unzipDirectory=self.folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName=description.modelName,
        )
        self.slave.instantiate()
        self.slave.enterInitializationMode(startTime=0.0)
        self.slave.exitInitializationMode()

    def __getitem__(self, name):
        return self.slave.getFloat64([self.references[name]])[0]

    def __setitem__(self, name, value):
        self.slave.setFloat64([self.references[name]], [value])

    def step(self, now, size):
        self.slave.doStep(currentCommunicationPoint=now, communicationStepSize=size)

    def close(self):
        self.slave.terminate()
        self.slave.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)


def run(paths, steps):
    """The state (x, v, y, w) after the run."""
    cart, controller = (Unit(path) for path in paths)
    size = END / steps
    for k in range(steps):
        controller["x"], controller["v"] = cart["x"], cart["v"]
        cart["F"] = controller["F"]
        cart.step(k * size, size)
        controller.step(k * size, size)
    state = numpy.array([cart["x"], cart["v"], controller["y"], controller["w"]])
    cart.close()
    controller.close()
    return state


def exact():
    m, k, mu, ka, ca = 2, 80, 0.2, 6.6, 0.4
    matrix = [
        [0, 1, 0, 0],
        [-(k + ka) / m, -ca / m, ka / m, ca / m],
        [0, 0, 0, 1],
        [ka / mu, ca / mu, -ka / mu, -ca / mu],
    ]
    return expm(END * numpy.array(matrix)) @ [0.1, 0, 0, 0]


def main():
    expected = exact()
    errors = [numpy.abs(run(sys.argv[1:3], steps) - expected).max() for steps in (2000, 4000)]
    print(f"x = {expected[0]:.6f} m at {END} s; errors {errors[0]:.1e} and, with half the step, {errors[1]:.1e}")
    assert errors[1] < 1e-3, "the units do not move as the coupled system"
    assert 1.8 < errors[0] / errors[1] < 2.2, "the error is not proportional to the step"


main()
