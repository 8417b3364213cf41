"""Functions on arrays: rows, kinds of numbers, and what is refused."""

import threading
from pathlib import Path

import numpy as np
import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"
#: A compiled model, a model with fewer speeds than coordinates, and an interpreted one with a loop.
MECHANISMS = ["disk", "rolling_disc", "four_bar", "furuta"]
FUNCTIONS = [
    "mass_matrix", "forcing", "accelerations", "coordinate_rates", "derivative", "jacobian",
    "kinetic_energy", "potential_energy",
]  # fmt: skip


def states(model, count, seed=1):
    random = np.random.default_rng(seed)
    return (
        random.uniform(0.1, 0.7, (count, len(model.coordinates))),
        random.uniform(-1, 1, (count, len(model.speeds))),
    )


@pytest.mark.parametrize("name", MECHANISMS)
@pytest.mark.parametrize("count", [1, 2, 7, 8, 9, 3001])
def test_a_row_of_an_array_is_the_value_of_its_state(name, count):
    model = tripos.Model(MODELS / name)
    q, u = states(model, count)
    for function in FUNCTIONS:
        values = getattr(model, function)(q, u)
        assert len(values) == count
        for at in {0, count // 2, count - 1}:
            one = getattr(model, function)(q[at], u[at])
            assert one.shape == values[at].shape
            assert np.allclose(values[at], one, rtol=1e-12, atol=1e-12 * (1 + abs(one).max(initial=0))), function


def test_a_value_depends_on_no_other_row():
    model = tripos.Model(MODELS / "disk")
    q, u = states(model, 5000)
    whole = model.accelerations(q, u)
    for first, last in [(0, 2), (3, 17), (4990, 5000)]:
        assert np.array_equal(model.accelerations(q[first:last], u[first:last]), whole[first:last])
    q[17] = np.nan
    with_nan = model.accelerations(q, u)
    assert np.isnan(with_nan[17]).any()
    assert np.array_equal(np.delete(with_nan, 17, 0), np.delete(whole, 17, 0))


def test_interpreted_equations_have_the_same_bits_for_one_state_and_for_many():
    model = tripos.Model.from_text(tripos.EXAMPLE)
    q, u = states(model, 100)
    for function in FUNCTIONS:
        many = getattr(model, function)(q, u)
        one = np.array([getattr(model, function)(q[at], u[at]) for at in range(100)])
        assert np.array_equal(many, one), function


@pytest.mark.parametrize(
    "change",
    [
        lambda a: a.astype(np.float32).astype(float),
        lambda a: np.asfortranarray(a),
        lambda a: a.astype(">f8"),
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: a[::-1][::-1],
        lambda a: a.tolist(),
        lambda a: np.lib.stride_tricks.as_strided(a, a.shape, a.strides, writeable=False),
        lambda a: np.frombuffer(a.tobytes()).reshape(a.shape),
    ],
)
def test_kinds_of_arrays(change):
    model = tripos.Model(MODELS / "furuta")
    q, u = (np.round(a, 2).astype(np.float32).astype(float) for a in states(model, 50))
    assert np.array_equal(model.accelerations(change(q), change(u)), model.accelerations(q, u))


def test_arrays_are_not_changed():
    model = tripos.Model(MODELS / "furuta")
    q, u = states(model, 50)
    q.flags.writeable = u.flags.writeable = False
    before = q.copy(), u.copy()
    model.jacobian(q, u)
    assert np.array_equal(q, before[0]) and np.array_equal(u, before[1])


def test_one_state_counts_for_all_rows():
    model = tripos.Model(MODELS / "furuta")
    q, u = states(model, 9)
    assert np.array_equal(model.forcing(q[0], u), model.forcing(np.tile(q[0], (9, 1)), u))
    assert np.array_equal(model.forcing(q[:1], u), model.forcing(q[0], u))
    assert model.forcing(q[:1], u[0]).shape == (1, 2)
    assert model.forcing(np.zeros((0, 2)), np.zeros((0, 2))).shape == (0, 2)
    assert model.forcing(np.zeros((0, 2)), u[0]).shape == (0, 2)


@pytest.mark.parametrize(
    "q",
    [
        [0.1, 0.2, 0.3], [[[0.1, 0.2]]], "text", [[0.1, 0.2], [0.3]], None, [1j, 0.0], 0.1, [],
        np.zeros((3, 2), dtype="datetime64[s]"), [object(), 0.0], {"theta": 1.0}, np.zeros((2, 3)),
    ],
)  # fmt: skip
def test_other_arrays_are_refused(q):
    model = tripos.Model(MODELS / "furuta")
    with pytest.raises(tripos.RequestError, match="^q "):
        model.accelerations(q, [0.0, 0.0])


def test_rows_that_do_not_fit_are_refused():
    model = tripos.Model(MODELS / "furuta")
    with pytest.raises(tripos.RequestError, match="3, 4 states"):
        model.accelerations(np.zeros((3, 2)), np.zeros((4, 2)))
    with pytest.raises(tripos.RequestError, match="3, 4 states"):
        model.inverse(np.zeros((3, 2)), np.zeros(2), np.zeros((4, 2)))


def test_parameters_and_functions_that_are_wrong_are_refused():
    model = tripos.Model(MODELS / "furuta")
    zero = [0.0, 0.0]
    for wrong in ("text", None, [1.0], 1j):
        with pytest.raises((tripos.RequestError, TypeError), match="m1"):
            model.forcing(zero, zero, m1=wrong)
    with pytest.raises(tripos.RequestError, match="no function `constraints`"):
        model.constraints(zero, zero)
    with pytest.raises(tripos.TriposError, match="hamilton"):
        model.forcing(zero, zero, equations="hamilton")


def test_threads_share_a_model():
    model = tripos.Model(MODELS / "furuta")
    q, u = states(model, 20000)
    expected = model.accelerations(q, u)
    results = [None] * 8

    def work(at):
        results[at] = tripos.Model(MODELS / "furuta") if at % 2 else model
        results[at] = results[at].accelerations(q, u, equations="kane")

    threads = [threading.Thread(target=work, args=(at,)) for at in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(result, expected) for result in results)


@pytest.mark.parametrize("name", ["furuta", "puma560", "four_bar", "gimbals", "governor", "window_linkage", "bricard"])
def test_the_regressor_gives_the_generalized_forces(name):
    model = tripos.Model(MODELS / name)
    q, u = states(model, 40)
    u_dot = np.random.default_rng(2).uniform(-1, 1, u.shape)
    pi = np.array(list(model.base_parameters().values()))
    regressor, rest = model.regressor(q, u, u_dot), model.regressor_rest(q, u, u_dot)
    assert regressor.shape == (40, u.shape[1], pi.size) and rest.shape == u.shape
    forces = model.inverse(q, u, u_dot)
    assert np.isfinite(pi).all()
    assert np.allclose(regressor @ pi + rest, forces, rtol=1e-9, atol=1e-9 * abs(forces).max())
    assert np.array_equal(model.regressor(q[3], u[3], u_dot[3]), regressor[3])


def test_a_fit_by_the_regressor_finds_the_base_parameters():
    model = tripos.Model(MODELS / "furuta")
    q, u = states(model, 200)
    u_dot = np.random.default_rng(2).uniform(-1, 1, u.shape)
    forces = model.inverse(q, u, u_dot) - model.regressor_rest(q, u, u_dot)
    regressor = model.regressor(q, u, u_dot)
    fit, *_ = np.linalg.lstsq(regressor.reshape(-1, regressor.shape[-1]), forces.ravel(), rcond=None)
    assert np.allclose(fit, list(model.base_parameters().values()), rtol=1e-8)


def test_masked_numbers_are_refused():
    model = tripos.Model(MODELS / "furuta")
    q, u = states(model, 5)
    whole = np.ma.masked_array(q, mask=False)
    assert np.array_equal(model.accelerations(whole, u), model.accelerations(q, u))
    for name, arrays in [("q", (np.ma.masked_array(q, q > 0.3), u)), ("u", (q, np.ma.masked_array(u, u > 0)))]:
        with pytest.raises(tripos.RequestError, match=f"^{name} has masked numbers"):
            model.accelerations(*arrays)
        with pytest.raises(tripos.RequestError, match=f"^{name} has masked numbers"):
            model.regressor(*arrays, u)


def test_parameters_may_have_the_names_of_arguments():
    names = ["q", "u", "u_dot", "self", "equations", "parameters"]
    m = tripos.Mechanism("Cart")
    m.parameter("m", "kg", 2)
    m.coordinate("x", "m"), m.speed("v", "x'"), m.inertial("N", "O")
    m.point("P", from_="O", frame="N", position=["x", 0, 0])
    m.particle("cart", point="P", mass="m")
    for name in names:
        m.input(name, "N")
        m.force(f"f_{name}", on="cart", frame="N", vector=[name, 0, 0])
    model, state = m.model(), ([0.0], [0.0])
    for name in names[:4]:
        given = {name: 3.0}
        assert model.accelerations(*state, **given)[0] == 1.5
        assert model.inverse(*state, [0.0], **given)[0] == -3.0
        assert model.rhs(**given)(0.0, [0.0, 0.0])[1] == 1.5
        assert np.isfinite(model.regressor(*state, [0.0], **given)).all() and model.base_parameters(**given)
        assert model.dae(**given)(0.0, [0.0, 0.0], [0.0, 1.5]).tolist() == [0.0, 0.0]
    for name in names:
        assert model.accelerations(*state, parameters={name: 3.0}, m=3.0)[0] == 1.0
    with pytest.raises(tripos.RequestError, match=r"`equations` is 2.0, .*parameters={'equations'"):
        model.accelerations(*state, equations=2.0)
    with pytest.raises(tripos.RequestError, match=r"`parameters` is 2.0"):
        model.accelerations(*state, parameters=2.0)
    with pytest.raises(tripos.RequestError, match="`m` is given twice"):
        model.accelerations(*state, parameters={"m": 1.0}, m=2.0)
