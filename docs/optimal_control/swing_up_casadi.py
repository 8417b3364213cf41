"""Swing-up of a Furuta pendulum by direct collocation in CasADi: the linear system M x = f stays unsolved.

    tripos emit models/furuta --language casadi --out furuta
    PYTHONPATH=furuta python swing_up_casadi.py

The accelerations x are variables beside the state, and the residual M x - f is a constraint at each point. IPOPT, which
comes with CasADi, finds the torque of least square. A fine integration of the solved equations checks the result.
"""

import casadi
import furuta_kane_casadi as model
import numpy

TIME, INTERVALS, STRONGEST = 2.0, 80, 1.0
N = model.LENGTHS["q"]


def with_torque(tau):
    """The parameters, with the torque of the motor in its place."""
    return casadi.vertcat(*(tau if name == "tau" else value for name, value in zip(model.PARAMETERS, model.DEFAULTS)))


def implicit():
    """The function (state, accelerations, torque) -> rates of the state, residual of the linear system."""
    y, x, tau = casadi.SX.sym("y", 2 * N), casadi.SX.sym("x", N), casadi.SX.sym("tau")
    p, q, u = with_torque(tau), y[:N], y[N:]
    rates = casadi.vertcat(model.coordinate_rates(p, q, u), x)
    return casadi.Function("implicit", [y, x, tau], [rates, model.residual(p, q, u, x)])


def swing_up():
    """The torques, each constant in its interval, and the states at the ends of the intervals."""
    h, equations, problem = TIME / INTERVALS, implicit(), casadi.Opti()
    y, tau = problem.variable(2 * N, INTERVALS + 1), problem.variable(1, INTERVALS)
    for k in range(INTERVALS):
        # Hermite's cubic and Simpson's rule: residuals at both ends and in the middle.
        x = problem.variable(N, 3)
        left, right = y[:, k], y[:, k + 1]
        middle = problem.variable(2 * N)
        problem.set_initial(middle, [0, numpy.pi * (k + 0.5) / INTERVALS, 0, numpy.pi / TIME])
        rates = []
        for point, column in ((left, 0), (middle, 1), (right, 2)):
            rate, residual = equations(point, x[:, column], tau[k])
            problem.subject_to(residual == 0)
            rates.append(rate)
        problem.subject_to(middle == (left + right) / 2 + h / 8 * (rates[0] - rates[2]))
        problem.subject_to(right == left + h / 6 * (rates[0] + 4 * rates[1] + rates[2]))
    problem.subject_to(y[:, 0] == casadi.DM([0, 0, 0, 0]))
    problem.subject_to(y[:, -1] == casadi.DM([0, casadi.pi, 0, 0]))
    problem.subject_to(problem.bounded(-STRONGEST, tau, STRONGEST))
    problem.minimize(casadi.sumsqr(tau) * h)
    problem.set_initial(y[1, :], numpy.linspace(0, numpy.pi, INTERVALS + 1)[None, :])
    problem.set_initial(y[3, :], numpy.pi / TIME)
    problem.solver("ipopt", {"print_time": False, "ipopt": {"print_level": 0, "sb": "yes"}})
    found = problem.solve()
    return found.value(tau), found.value(y)


def check(torques, states):
    """The largest difference from runs of the solved equations, interval by interval."""
    y, tau = casadi.SX.sym("y", 2 * N), casadi.SX.sym("tau")
    rates = casadi.vertcat(*model.derivative(with_torque(tau), y[:N], y[N:]))
    options = {"reltol": 1e-11, "abstol": 1e-12}
    step = casadi.integrator("step", "cvodes", {"x": y, "p": tau, "ode": rates}, 0, TIME / INTERVALS, options)
    ends = [step(x0=states[:, k], p=torques[k])["xf"].full()[:, 0] for k in range(INTERVALS)]
    return abs(numpy.array(ends).T - states[:, 1:]).max()


if __name__ == "__main__":
    torques, states = swing_up()
    print(f"strongest torque {abs(torques).max():.3f} N m, largest error of an interval {check(torques, states):.1e}")
    print("at the end:", ", ".join(f"{x:.6f}" for x in states[:, -1]))
