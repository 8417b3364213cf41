"""Swing-up of a Furuta pendulum by acados, from the residual M x - f of the linear system.

    tripos emit models/furuta --language casadi --out furuta
    PYTHONPATH=furuta python swing_up_acados.py

acados takes implicit equations f(y', y, tau) = 0 and integrates them by an implicit Runge-Kutta method. It compiles C
that CasADi writes from the expressions of the module. Not run: acados is not on the package index.
"""

import casadi
import furuta_kane_casadi as equations
import numpy
from acados_template import AcadosModel, AcadosOcp, AcadosOcpSolver

TIME, INTERVALS, STRONGEST = 2.0, 80, 1.0
N = equations.LENGTHS["q"]


def model():
    mechanism = AcadosModel()
    mechanism.name = "furuta"
    mechanism.x, mechanism.xdot = casadi.SX.sym("y", 2 * N), casadi.SX.sym("y_dot", 2 * N)
    mechanism.u = casadi.SX.sym("tau")
    q, u = mechanism.x[:N], mechanism.x[N:]
    p = casadi.vertcat(*(mechanism.u if n == "tau" else v for n, v in zip(equations.PARAMETERS, equations.DEFAULTS)))
    mechanism.f_impl_expr = casadi.vertcat(
        mechanism.xdot[:N] - equations.coordinate_rates(p, q, u), equations.residual(p, q, u, mechanism.xdot[N:])
    )
    return mechanism


def solver():
    problem = AcadosOcp()
    problem.model = model()
    problem.solver_options.N_horizon = INTERVALS
    problem.solver_options.tf = TIME
    problem.solver_options.integrator_type = "IRK"
    problem.solver_options.nlp_solver_type = "SQP"
    problem.solver_options.nlp_solver_max_iter = 500
    problem.solver_options.globalization = "MERIT_BACKTRACKING"
    problem.cost.cost_type = "EXTERNAL"
    problem.model.cost_expr_ext_cost = problem.model.u**2
    problem.constraints.x0 = numpy.zeros(2 * N)
    problem.constraints.idxbx_e = numpy.arange(2 * N)
    problem.constraints.lbx_e = problem.constraints.ubx_e = numpy.array([0, numpy.pi, 0, 0])
    problem.constraints.idxbu = numpy.array([0])
    problem.constraints.lbu, problem.constraints.ubu = numpy.array([-STRONGEST]), numpy.array([STRONGEST])
    return AcadosOcpSolver(problem)


if __name__ == "__main__":
    ocp = solver()
    for k in range(INTERVALS + 1):
        ocp.set(k, "x", numpy.array([0, numpy.pi * k / INTERVALS, 0, numpy.pi / TIME]))
    status = ocp.solve()
    torques = [ocp.get(k, "u").item() for k in range(INTERVALS)]
    print(f"status {status}, strongest torque {max(map(abs, torques)):.3f} N m")
    print("at the end:", ", ".join(f"{x:.6f}" for x in ocp.get(INTERVALS, "x")))
