"""First result of an edited model by heyoka: `first_heyoka.py form|lagrangian SHARE TOLERANCE`; prints the end.

SHARE: the axial moment of inertia over M R^2. `form`: from the closed form, which a person has derived again after the edit;
`lagrangian`: from the energies.
"""

import sys

import heyoka as hy
import numpy as np
from closed_form import general
from mechanics import disk_energies
from worker import PARAMETERS, SPAN, START


def of_lagrangian(share):
    names = [f"q{i}" for i in range(1, 6)]
    q, v = hy.make_vars(*names), hy.make_vars(*(f"v{name}" for name in names))

    def derivative(x):
        return sum((hy.diff(x, a) * b for a, b in zip(q, v)), hy.expression(0.0))

    kinetic, potential = disk_energies(hy, q, v, PARAMETERS, derivative, share)
    return hy.lagrangian(kinetic - potential, q, v)


kind, share, tolerance = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
hy.llvm_state.set_diskcache_enabled(False)
equations = general(*PARAMETERS[1:], share) if kind == "form" else of_lagrangian(share)
integrator = hy.taylor_adaptive(equations, np.array(START), tol=tolerance)
integrator.propagate_until(SPAN)
print(*(repr(float(x)) for x in integrator.state))
