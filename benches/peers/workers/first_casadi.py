"""First result of an edited model by CasADi and CVODES: `first_casadi.py c|machine SHARE TOLERANCE`; prints the end.

SHARE: the axial moment of inertia over M R^2. `c`: its C is compiled; `machine`: its virtual machine runs the equations.
"""

import sys

import casadi as ca
import mechanics
from worker import PARAMETERS, SPAN, START

kind, share, tolerance = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
q, v, p, M, f = mechanics.of_casadi(5, 3, share)
rates = ca.vertcat(v, ca.ldl_solve(f, *ca.ldl(M)))
problem = {"x": ca.vertcat(q, v), "p": p, "ode": rates}
options = {"abstol": tolerance, "reltol": tolerance, "max_num_steps": 1_000_000}
if kind == "c":
    options |= {"jit": True, "compiler": "shell", "jit_options": {"flags": ["-O3", "-march=native"], "verbose": False}}
end = ca.integrator("run", "cvodes", problem, 0, SPAN, options)(x0=START, p=PARAMETERS)["xf"]
print(*(repr(float(x)) for x in end.full().ravel()))
