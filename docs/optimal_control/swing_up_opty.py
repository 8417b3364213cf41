"""Swing-up of a Furuta pendulum by opty, from the residual M x - f of the linear system.

    tripos emit models/furuta --language python --out furuta
    PYTHONPATH=furuta python swing_up_opty.py

opty wants equations 0 = f(y', y, ...) in SymPy. The generated functions take any array library; here it is NumPy with
arrays of SymPy's terms. opty needs IPOPT and cyipopt.
"""

from types import SimpleNamespace

import furuta_kane as model
import numpy
import sympy
from sympy.physics.mechanics import dynamicsymbols

NODES, TIME, STRONGEST = 81, 2.0, 1.0


# The functions of NumPy that the generated code calls, for arrays of SymPy's terms.
TERMS = SimpleNamespace(
    asarray=lambda array: numpy.asarray(array, dtype=object),
    broadcast_shapes=numpy.broadcast_shapes,
    broadcast_to=numpy.broadcast_to,
    reshape=numpy.reshape,
    stack=numpy.stack,
    zeros=numpy.zeros,
    sin=sympy.sin,
    cos=sympy.cos,
    tan=sympy.tan,
    sqrt=sympy.sqrt,
)


def equations(q, u, tau):
    """Rows q' - W u - w and M u' - f, which are zero in a motion."""
    t = dynamicsymbols._t
    p = [tau if name == "tau" else sympy.Float(value) for name, value in zip(model.PARAMETERS, model.DEFAULTS)]
    rates, accelerations = [x.diff(t) for x in q], [x.diff(t) for x in u]
    rows = [rate - known for rate, known in zip(rates, model.coordinate_rates(p, q, u, xp=TERMS))]
    return sympy.Matrix([*rows, *model.residual(p, q, u, accelerations, xp=TERMS)])


def swing_up():
    """The solution of opty: states, then torques, at the nodes."""
    from opty import Problem, create_objective_function

    q, u, tau = dynamicsymbols("q1:3"), dynamicsymbols("u1:3"), dynamicsymbols("tau")
    h, t = TIME / (NODES - 1), dynamicsymbols._t
    objective, gradient = create_objective_function(
        sympy.Integral(tau**2, t), [*q, *u], [tau], (), NODES, h, time_symbol=t
    )
    starts = [x.subs(t, 0) for x in (*q, *u)]
    ends = [x.subs(t, TIME) - end for x, end in zip((*q, *u), (0, sympy.pi, 0, 0))]
    problem = Problem(
        objective,
        gradient,
        equations(q, u, tau),
        [*q, *u],
        NODES,
        h,
        instance_constraints=(*starts, *ends),
        bounds={tau: (-STRONGEST, STRONGEST)},
        integration_method="midpoint",
        time_symbol=t,
        backend="numpy",
    )
    problem.add_option("print_level", 0)
    guess = numpy.zeros((5, NODES))
    guess[1], guess[3] = numpy.linspace(0, numpy.pi, NODES), numpy.pi / TIME
    solution, outcome = problem.solve(guess.ravel())
    return solution.reshape(5, NODES), outcome["status"]


if __name__ == "__main__":
    solution, status = swing_up()
    print(f"status {status}, strongest torque {abs(solution[4]).max():.3f} N m")
    print("at the end:", ", ".join(f"{x:.6f}" for x in solution[:4, -1]))
