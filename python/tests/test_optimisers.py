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
    root = pytest.importorskip("scipy.optimize").root
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
    minimize = pytest.importorskip("scipy.optimize").minimize
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


def test_an_objective_with_a_wrong_request_fails_when_it_is_made(scene):
    for of, names, settings, text in [
        ("phi", ["theta"], {}, "phi"),
        ("theta", ["length"], {}, "no derivative by `length`"),
        ("theta", ["theta", "l", "theta"], {}, "`theta` is given twice"),
        ("theta", "theta", {}, r"give a list: \['theta'\]"),
        ("theta", ["theta"], {"tolerance": 1e-3}, "tolerance"),
        ("theta", ["theta"], {"rtol": "1e-3"}, "rtol"),
    ]:
        with pytest.raises(tripos.RequestError, match=text):
            scene.objective(of, names, **settings)
    with pytest.raises(tripos.RequestError, match="no array of real numbers"):
        scene.objective("theta", ["theta"])([1j])


def test_an_objective_may_be_the_time_of_an_event(scene):
    text = START.replace("[0, 1]", "[0, 3]") + '[[events]]\nname = "bottom"\nzero = "theta"\nterminal = true\n'
    falling = tripos.Scene.from_text(scene.model, text)
    assert falling.objective("t", ["theta"])([0.5])[0] == pytest.approx(falling.simulate().t[-1], rel=1e-6)


@pytest.mark.parametrize("method", ["rhs", "rhs_jacobian", "dae"])
def test_functions_for_solvers_refuse_wrong_requests_at_once(scene, method):
    make = getattr(scene.model, method)
    with pytest.raises(tripos.RequestError, match="no parameter `foo`"):
        make(foo=1.0)
    with pytest.raises(tripos.TriposError, match="hamilton"):
        make(equations="hamilton")


def test_functions_for_solvers_refuse_other_numbers(scene):
    masked = np.ma.masked_array([0.5, 0.0], [True, False])
    for y, text in [([0.5, 1j], "complex128"), (np.array([0.5, 1j]), "complex128"), (masked, "masked numbers")]:
        with pytest.raises(tripos.RequestError, match=text):
            scene.model.rhs()(0.0, y)
        with pytest.raises(tripos.RequestError, match=text):
            scene.model.dae()(0.0, y, [0.0, 0.0])
    assert scene.model.rhs()(0.0, [1, 0]).tolist() == scene.model.rhs()(0.0, np.array([1.0, 0.0])).tolist()
