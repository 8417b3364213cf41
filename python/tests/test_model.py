"""Models, their functions on arrays, and their errors."""

from pathlib import Path

import numpy as np
import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"


def test_functions_have_the_shapes_of_their_states():
    model = tripos.Model(MODELS / "furuta")
    one = model.accelerations([0.1, 0.2], [0.3, 0.4])
    many = model.accelerations(np.tile([0.1, 0.2], (1000, 1)), np.tile([0.3, 0.4], (1000, 1)))
    assert one.shape == (2,) and many.shape == (1000, 2) and (many == one).all()
    mass = model.mass_matrix(np.zeros((3, 2)), [0.0, 0.0])
    assert mass.shape == (3, 2, 2) and np.allclose(mass, mass.transpose(0, 2, 1))
    assert model.kinetic_energy([0.0, 0.0], [1.0, 0.0]).shape == ()
    assert model.jacobian([0.0, 0.0], [1.0, 0.0]).shape == (4, 4)


def test_the_equations_agree_with_one_another():
    model = tripos.Model(MODELS / "furuta")
    random = np.random.default_rng(3)
    q, u = random.standard_normal((50, 2)), random.standard_normal((50, 2))
    a = model.accelerations(q, u)
    assert np.allclose(model.inverse(q, u, a), 0, atol=1e-12)
    solved = np.linalg.solve(model.mass_matrix(q, u), model.forcing(q, u)[:, :, None])[:, :, 0]
    assert np.allclose(solved, a, rtol=1e-10)
    assert np.allclose(model.accelerations(q, u, equations="lagrange"), a, rtol=1e-9)
    step = 1e-6
    ahead = model.derivative(q + [step, 0], u)
    behind = model.derivative(q - [step, 0], u)
    assert np.allclose((ahead - behind) / (2 * step), model.jacobian(q, u)[:, :, 0], rtol=1e-5, atol=1e-6)


def test_a_mechanism_with_more_coordinates_than_speeds():
    model = tripos.Model(MODELS / "rolling_disc")
    q = np.full(len(model.coordinates), 0.3)
    u = np.full(len(model.speeds), 0.2)
    assert model.derivative(q, u).shape == (q.size + u.size,)
    rates = model.coordinate_rates(q, u)
    by_rates = model.kinetic_energy(q, rates, equations="lagrange")
    assert by_rates == pytest.approx(model.kinetic_energy(q, u), rel=1e-12)
    with pytest.raises(tripos.RequestError, match="u has the shape"):
        model.kinetic_energy(q, u, equations="lagrange")


def test_parameters_are_keywords():
    model = tripos.Model.from_text(tripos.EXAMPLE)
    assert model.accelerations([0.5], [0.0], g=1.0, l=2.0)[0] == pytest.approx(-np.sin(0.5) / 2)
    with pytest.raises(tripos.RequestError, match="no parameter `length`"):
        model.accelerations([0.5], [0.0], length=2.0)


def test_arrays_that_are_wrong_are_refused():
    model = tripos.Model.from_text(tripos.EXAMPLE)
    for q in ([0.1, 0.2], [[[0.1]]], "text", [[0.1], [0.2, 0.3]], None, 1j, np.zeros((4, 0))):
        with pytest.raises(tripos.RequestError):
            model.accelerations(q, [0.0])
    with pytest.raises(tripos.RequestError, match="2, 3 states"):
        model.accelerations(np.zeros((2, 1)), np.zeros((3, 1)))
    assert model.accelerations(np.zeros((0, 1)), np.zeros((0, 1))).shape == (0, 1)
    assert np.isnan(model.accelerations([np.nan], [0.0])).all()
    strided = np.asfortranarray(np.arange(20.0).reshape(10, 2))[::2, :1]
    strided.flags.writeable = False
    assert np.allclose(model.accelerations(strided, np.zeros((5, 1))), -9.81 * np.sin(strided))
    with pytest.raises(tripos.RequestError):
        model.constraints([0.0], [0.0])
    with pytest.raises(tripos.TriposError):
        model.forcing([0.0], [0.0], equations="hamilton")


def test_errors_of_files_have_places(tmp_path):
    broken = tripos.EXAMPLE.replace('angle = "theta"', 'angle = "phi"')
    (tmp_path / "model.toml").write_text(broken)
    with pytest.raises(tripos.InputError, match="phi") as caught:
        tripos.Model(tmp_path)
    place = caught.value.places[0]
    line = broken.splitlines()[place["line"] - 1]
    assert "phi" in line and line[place["column"] - 1 :].startswith(('"phi', "phi"))
    with pytest.raises(tripos.TriposError):
        tripos.Model(tmp_path / "nowhere.toml")


def test_solve_ivp_takes_the_right_hand_side():
    integrate = pytest.importorskip("scipy.integrate")
    model = tripos.Model.from_text(tripos.EXAMPLE)
    settings = dict(rtol=1e-10, atol=1e-12)
    run = integrate.solve_ivp(model.rhs(), (0, 1), [0.5, 0.0], **settings)
    assert run.y[0, -1] == pytest.approx(-0.499157187, abs=1e-8)
    stiff = integrate.solve_ivp(model.rhs(), (0, 1), [0.5, 0.0], method="Radau", jac=model.rhs_jacobian(), **settings)
    assert stiff.y[0, -1] == pytest.approx(-0.499157187, abs=1e-7)


def test_threads_share_a_model():
    from concurrent.futures import ThreadPoolExecutor

    model = tripos.Model(MODELS / "disk")
    q, u = np.tile(np.linspace(0.1, 0.6, 6), (500, 1)), np.tile(np.linspace(0.1, 0.5, 5), (500, 1))
    with ThreadPoolExecutor(4) as pool:
        all_ = list(pool.map(lambda _: model.accelerations(q[:, : len(model.coordinates)], u), range(8)))
    assert all((values == all_[0]).all() for values in all_)
