"""First result of an edited model by SymPy's KanesMethod: `first_sympy.py pydy|lambdify SHARE TOLERANCE`; prints q at the end.

SHARE: the axial moment of inertia over M R^2. `pydy`: PyDy makes and compiles C through Cython; `lambdify`: NumPy functions with
common subexpressions shared, and a solve at each state. SciPy's DOP853 integrates either.
"""

import sys

import numpy as np
import sympy as sm
import sympy_models
from scipy.integrate import solve_ivp
from worker import PARAMETERS, SPAN, START

kind, share, tolerance = sys.argv[1], sys.argv[2], float(sys.argv[3])
symbols, M, f, numbers, _ = sympy_models.disk(sm.Rational(share))
q, u, p = symbols[:5], symbols[5:10], symbols[10:]
start = np.array(numbers(START[:5], START[5:], PARAMETERS)[:10])
q1, q2, q3, q4, q5 = q
u1, u2, u3, u4, u5 = u
kinematics = sm.Matrix([u2 / sm.cos(q2), -u1, u3 - u2 * sm.tan(q2), u4, u5])
if kind == "pydy":
    from pydy.codegen.ode_function_generators import generate_ode_function

    whole = generate_ode_function(
        f, q, u, list(p), mass_matrix=M, coordinate_derivatives=kinematics, generator="cython", linear_sys_solver="numpy"
    )
    rates = lambda t, x: whole(x, t, np.array(PARAMETERS))
else:
    matrices = sm.lambdify([q, u, p], [M, f, kinematics], cse=True)

    def rates(_t, x):
        m, forcing, q_dot = matrices(x[:5], x[5:], PARAMETERS)
        return np.concatenate([q_dot.ravel(), np.linalg.solve(m, forcing.ravel())])


end = solve_ivp(rates, (0, SPAN), start, method="DOP853", rtol=tolerance, atol=tolerance).y[:5, -1]
print(*(repr(float(x)) for x in end))
