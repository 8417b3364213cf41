"""Model predictive control of a Furuta pendulum by do-mpc: from 60° beside upright to rest, with unsolved equations.

    tripos emit models/furuta --language casadi --out furuta
    PYTHONPATH=furuta python stabilise_do_mpc.py

do-mpc takes semi-explicit equations: the accelerations are algebraic variables, and the residual M x - f of the linear
system is their equation. The simulator of do-mpc integrates the same equations.
"""

import warnings

import casadi
import furuta_kane_casadi as equations
import numpy

with warnings.catch_warnings():
    # do-mpc names the optional packages that it was installed without.
    warnings.simplefilter("ignore")
    import do_mpc

STEP, HORIZON, STEPS, STRONGEST = 0.02, 40, 150, 1.0
N = equations.LENGTHS["q"]


def model():
    mechanism = do_mpc.model.Model("continuous", "SX")
    q = mechanism.set_variable("_x", "q", shape=(N, 1))
    u = mechanism.set_variable("_x", "u", shape=(N, 1))
    x = mechanism.set_variable("_z", "x", shape=(N, 1))
    tau = mechanism.set_variable("_u", "tau")
    p = casadi.vertcat(*(tau if n == "tau" else v for n, v in zip(equations.PARAMETERS, equations.DEFAULTS)))
    mechanism.set_rhs("q", equations.coordinate_rates(p, q, u))
    mechanism.set_rhs("u", x)
    mechanism.set_alg("linear system", equations.residual(p, q, u, x))
    mechanism.setup()
    return mechanism


def controller(mechanism):
    mpc = do_mpc.controller.MPC(mechanism)
    mpc.settings.n_horizon = HORIZON
    mpc.settings.t_step = STEP
    mpc.settings.store_full_solution = False
    mpc.settings.supress_ipopt_output()
    q, u = mechanism.x["q"], mechanism.x["u"]
    # 1 + cos of the pendulum's angle is zero upright.
    cost = 10 * (1 + casadi.cos(q[1])) + q[0] ** 2 + 0.01 * casadi.sumsqr(u)
    mpc.set_objective(mterm=10 * cost, lterm=cost)
    mpc.set_rterm(tau=0.1)
    mpc.bounds["lower", "_u", "tau"] = -STRONGEST
    mpc.bounds["upper", "_u", "tau"] = STRONGEST
    mpc.setup()
    return mpc


def simulator(mechanism):
    plant = do_mpc.simulator.Simulator(mechanism)
    plant.set_param(integration_tool="idas", abstol=1e-10, reltol=1e-10, t_step=STEP)
    plant.setup()
    return plant


if __name__ == "__main__":
    mechanism = model()
    mpc, plant = controller(mechanism), simulator(mechanism)
    state = numpy.array([[0.0], [numpy.radians(120)], [0.0], [0.0]])
    mpc.x0 = plant.x0 = state
    mpc.set_initial_guess()
    plant.set_initial_guess()
    strongest = 0.0
    for _ in range(STEPS):
        torque = mpc.make_step(state)
        strongest = max(strongest, abs(torque.item()))
        state = plant.make_step(torque)
    print(f"strongest torque {strongest:.3f} N m")
    print("at the end:", ", ".join(f"{x:.6f}" for x in state[:, 0]))
