"""Equations and gradients in the hands of other solvers."""

from pathlib import Path

import numpy as np
import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"
START = "span = [0, 1]\n[start]\ntheta = 0.5\nomega = 0\n"
#: Mechanisms with rolling, with a loop, with multipliers of Lagrange, and with a reaction among the unknowns.
MECHANISMS = ["furuta", "disk", "rolling_disc", "four_bar", "cartesian_pendulum", "driven_pendulum"]


@pytest.fixture
def scene():
    return tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START)


@pytest.mark.parametrize("name", MECHANISMS)
@pytest.mark.parametrize("equations", ["kane", "lagrange", "newton-euler"])
def test_the_implicit_system_is_zero_for_a_motion(name, equations):
    model = tripos.Model(MODELS / name)
    dae = model.dae(equations=equations)
    n = len(model.coordinates)
    v = np.random.default_rng(5).uniform(-1, 1, n if equations == "lagrange" else len(model.speeds))
    q = np.random.default_rng(6).uniform(0.2, 0.7, n)
    matrix, forcing = (value(q, v, equations=equations) for value in (model.mass_matrix, model.forcing))
    unknowns = np.linalg.solve(matrix, forcing)
    accelerations, reactions = np.split(unknowns, [len(v)])
    rates = np.concatenate([model.coordinate_rates(q, v, equations=equations), accelerations, np.zeros(len(reactions))])
    y = np.concatenate([q, v, reactions])
    assert dae.is_differential.tolist() == [True] * (n + len(v)) + [False] * len(reactions)
    scale = 1 + abs(forcing).max()
    assert np.allclose(dae(0.0, y, rates), 0, atol=1e-10 * scale)
    # Rates of reactions do not occur, and every other rate does.
    assert np.allclose(dae(0.0, y, rates + ~dae.is_differential), 0, atol=1e-10 * scale)
    assert not np.allclose(dae(0.0, y, rates + dae.is_differential)[:n], 0)
    with pytest.raises(tripos.RequestError, match="shapes"):
        dae(0.0, y[:-1], rates)


def test_an_implicit_solver_moves_along(scene):
    from scipy.optimize import root

    dae = scene.model.dae()
    y, h = np.array([0.5, 0.0]), 1e-3
    for _ in range(1000):
        # The implicit midpoint rule has the order 2.
        y = root(lambda new: dae(0.0, (y + new) / 2, (new - y) / h), y, tol=1e-13).x
    assert y[0] == pytest.approx(scene.simulate(rtol=1e-12).end["theta"], abs=1e-6)


def test_the_objective_has_the_gradient_of_differences(scene):
    objective = scene.objective("theta", ["theta", "omega", "l"], rtol=1e-11, atol=1e-13)
    at, step = np.array([0.5, 0.1, 0.9]), 1e-5
    value, slopes = objective(at)
    for k, one in enumerate(np.eye(3) * step):
        difference = (objective(at + one)[0] - objective(at - one)[0]) / (2 * step)
        assert slopes[k] == pytest.approx(difference, rel=1e-7)
    # The scene itself is as it was.
    assert scene.simulate(rtol=1e-11, atol=1e-13).end["theta"] != value
    with pytest.raises(tripos.RequestError, match="takes 3 numbers"):
        objective([0.5])
    with pytest.raises(tripos.TriposError, match="length"):
        scene.objective("theta", ["length"])([1.0])
    with pytest.raises(tripos.TriposError):
        scene.objective("phi", ["theta"])([1.0])


def test_scipy_finds_a_start_by_the_gradient(scene):
    from scipy.optimize import minimize

    objective = scene.objective("theta", ["theta"], rtol=1e-11)

    def square(x):
        value, slopes = objective(x)
        return (value + 0.3) ** 2, 2 * (value + 0.3) * slopes

    found = minimize(square, [0.5], jac=True, tol=1e-14)
    assert objective(found.x)[0] == pytest.approx(-0.3, abs=1e-6)


def test_jax_differentiates_a_run(scene):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    function = scene.jax_objective("theta", ["theta", "l"], rtol=1e-11)
    value, slopes = scene.objective("theta", ["theta", "l"], rtol=1e-11)([0.5, 1.0])
    at = jax.numpy.array([0.5, 1.0])
    assert float(function(at)) == value
    assert np.allclose(jax.grad(function)(at), slopes, rtol=1e-14)
    twice = jax.jit(jax.grad(lambda x: 2 * function(x) ** 2))(at)
    assert np.allclose(twice, 4 * value * slopes, rtol=1e-12)
    assert jax.vmap(function)(jax.numpy.stack([at, at])).shape == (2,)
