"""Scenes, runs and controllers."""

import copy
import gc
from pathlib import Path

import numpy as np
import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"
CART = tripos.EXAMPLE + '\n[inputs]\nF = { unit = "N*m", value = 0 }\n[torques.motor]\non = "B"\nframe = "N"\nvector = [0, 0, "F"]\n'
START = "span = [0, 2]\n[start]\ntheta = 0.5\nomega = 0\n"


def test_a_run_has_columns_digits_and_drifts():
    scene = tripos.Scene(MODELS / "furuta/scenes/swing.toml")
    run = scene.simulate(rtol=1e-9)
    assert run.values.shape == (len(run.t), len(run.names))
    assert run["theta2"][-1] == run.end["theta2"]
    assert min(run.digits.values()) > 6 and all(abs(change) < 1e-6 for change in run.drift.values())
    with pytest.raises(KeyError, match="theta2"):
        run["theta9"]


def test_runs_become_tables():
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    run = tripos.Scene(MODELS / "furuta/scenes/swing.toml").simulate()
    frame, dataset = run.to_pandas(), run.to_xarray()
    assert isinstance(frame, pandas.DataFrame) and frame["theta2"].iloc[-1] == run.end["theta2"]
    assert isinstance(dataset, xarray.Dataset) and float(dataset["theta2"][-1]) == run.end["theta2"]


def test_values_are_set_and_settings_named():
    model = tripos.Model.from_text(tripos.EXAMPLE)
    scene = tripos.Scene.from_text(model, START)
    before = scene.simulate().end["theta"]
    scene.set(g=1.62)
    assert scene.simulate().end["theta"] != before
    with pytest.raises(tripos.RequestError, match="tolerance"):
        scene.simulate(tolerance=1e-3)
    with pytest.raises(tripos.TriposError):
        scene.set(gee=1.0)
    with pytest.raises(tripos.TriposError):
        scene.simulate(method="no such method")


def test_slopes_are_those_of_differences():
    model = tripos.Model.from_text(tripos.EXAMPLE)
    scene = tripos.Scene.from_text(model, START)
    slope = scene.sensitivity("l")["theta"]["l"]
    assert scene.gradient("theta")["l"] == pytest.approx(slope, rel=1e-6)
    ends = []
    for length in (1 + 1e-5, 1 - 1e-5):
        scene.set(l=length)
        ends.append(scene.simulate(rtol=1e-12, atol=1e-14).end["theta"])
    assert (ends[0] - ends[1]) / 2e-5 == pytest.approx(slope, rel=1e-4)


def test_a_controller_is_a_function():
    model = tripos.Model.from_text(CART)
    scene = tripos.Scene.from_text(model, START)
    instants = np.arange(0.0, 2.0, 0.05)
    run = scene.sampled(["F"], instants, lambda t, state: [-5 * state["theta"] - 3 * state["omega"]])
    assert abs(run["theta"][-1]) < 0.05
    assert run.decisions.shape == (len(run.decision_times), 1)
    assert not run.warnings and run.errors is not None and abs(run.errors["theta"]) < 1e-3


def test_what_speaks_against_a_run_is_a_warning():
    # The run of the report, which its method loses near cos(q2) = 0.
    scene = tripos.Scene(MODELS / "disk/scenes/report.toml")
    with pytest.warns(tripos.UntrustedRunWarning, match="digits are right"):
        run = scene.simulate(by="kane")
    assert not run.is_trusted and run.warnings
    with pytest.warns(tripos.UntrustedRunWarning):
        scene.sensitivity("M", by="kane")
    with pytest.warns(tripos.UntrustedRunWarning):
        scene.gradient("q2", by="kane")


def test_the_model_of_a_scene_has_the_file_of_the_model():
    scene = tripos.Scene(MODELS / "furuta/scenes/swing.toml")
    assert scene.model.path.resolve() == (MODELS / "furuta/model.toml").resolve()


@pytest.mark.parametrize("answer", [[], [1.0, 2.0], [float("nan")], ["x"], None])
def test_a_controller_that_returns_nonsense_is_refused(answer):
    scene = tripos.Scene.from_text(tripos.Model.from_text(CART), START)
    with pytest.raises((tripos.RequestError, TypeError, ValueError)):
        scene.sampled(["F"], [0.5, 1.0], lambda t, state: answer)


def test_what_a_controller_raises_is_raised():
    scene = tripos.Scene.from_text(tripos.Model.from_text(CART), START)

    def controller(t, state):
        if t > 0.8:
            raise ZeroDivisionError("at the second instant")
        return [0.0]

    with pytest.raises(ZeroDivisionError, match="at the second instant"):
        scene.sampled(["F"], [0.7, 1.0], controller)


def test_ctrl_c_ends_a_run():
    import os
    import signal
    import threading
    import time

    scene = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START.replace("[0, 2]", "[0, 1000000]"))
    threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        scene.simulate(rtol=1e-12, by="kane")
    assert time.monotonic() - begin < 10


def test_a_run_with_a_controller_has_its_samples():
    scene = tripos.Scene.from_text(tripos.Model.from_text(CART), START)

    def make():
        before = [0.0]

        def controller(t, state):
            force = -5 * state["theta"] - 3 * state["omega"] - 0.1 * before[0]
            before[0] = force
            return [force]

        return controller

    run = scene.sampled(["F"], np.arange(0.0, 2.0, 0.05), make=make, rtol=1e-9)
    assert run.t[0] == 0.0 and run.t[-1] == 2.0 and (np.diff(run.t) > 0).all()
    assert run.values.shape == (len(run.t), len(run.names)) and run["theta"][-1] == run.end["theta"]
    assert "t = 2 s" in run.ending and run.events == []
    for controller, make in [(None, None), (make(), make)]:
        with pytest.raises(tripos.RequestError, match="either"):
            scene.sampled(["F"], [0.5], controller, make=make)


def test_few_digits_of_a_run_with_a_controller_are_a_warning():
    # Between two decisions the coarse run has steps of its own, and the force decides by the sign of a state.
    scene = tripos.Scene.from_text(tripos.Model.from_text(CART), START.replace("[0, 2]", "[0, 20]"))

    def switch(t, state):
        return [10.0 if state["omega"] > 0 else -10.0]

    with pytest.warns(tripos.UntrustedRunWarning, match="fewer than three digits"):
        run = scene.sampled(["F"], np.arange(0.0, 20.0, 0.5), switch, rtol=1e-2, atol=1e-2)
    assert run.warnings


def test_a_controller_may_return_a_number_and_use_outputs():
    model = tripos.Model.from_text(CART)
    scene = tripos.Scene.from_text(model, 'outputs = ["theta", { name = "height", value = "-l*cos(theta)" }]\n' + START)
    run = scene.sampled(["F"], [0.0, 1.0], lambda t, values: np.float64(values["height"]))
    assert run.names == ["theta", "omega", "height"]
    assert run.decisions[0, 0] == run["height"][0] == pytest.approx(-np.cos(0.5), rel=1e-14)
    assert run.digits["height"] > 3 and run.is_trusted
    with pytest.raises(tripos.RequestError, match=r"returned 'no' at t = 0.5 s; return a finite number for each of F"):
        scene.sampled(["F"], [0.5], lambda t, values: "no")


def test_progress_is_shown_where_tqdm_is(capsys):
    pytest.importorskip("tqdm")
    scene = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START.replace("[0, 2]", "[0, 2000]"))
    run = scene.simulate(progress=True, rtol=1e-12, by="kane")
    shown = capsys.readouterr().err
    assert "run:" in shown and "of 2000 s" in shown
    # The last line shows a full bar, and a colon is never followed by another.
    assert "second run, for the digits: 100%" in shown.split("\r")[-1] and ": :" not in shown and "::" not in shown
    assert run.end == scene.simulate(rtol=1e-12, by="kane").end


def test_samples_and_the_step_limit_are_settings():
    scene = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START)
    assert scene.simulate(samples=5).t.tolist() == [0.0, 0.5, 1.0, 1.5, 2.0]
    with pytest.warns(tripos.UntrustedRunWarning, match="3 steps|limit"):
        assert not scene.simulate(step_limit=3).is_trusted
    for setting in [{"samples": 1}, {"step_limit": 0}]:
        with pytest.raises(tripos.RequestError, match="whole number from"):
            scene.simulate(**setting)


def test_a_view_of_an_untrusted_run_warns_as_the_run_does():
    with pytest.warns(tripos.UntrustedRunWarning):
        tripos.Scene(MODELS / "disk/scenes/report.toml").view(by="kane")


def test_a_run_is_a_mapping_of_names_to_columns():
    run = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START).simulate()
    assert "theta" in run and "phi" not in run and 0 not in run
    assert list(run) == list(run.keys()) == run.names and len(run) == len(run.names)
    columns = dict(run)
    assert list(columns) == run.names and np.array_equal(columns["omega"], run["omega"])


@pytest.mark.parametrize(
    "setting",
    [
        {"rtol": "1e-8"}, {"rtol": True}, {"atol": 1j}, {"step": [0.1]}, {"until": "a"}, {"samples": 5.0},
        {"samples": -5}, {"samples": True}, {"step_limit": "10"}, {"step_limit": 1 << 70}, {"by": 1}, {"method": 4.0},
    ],
)  # fmt: skip
def test_settings_of_wrong_kinds_are_refused_by_name(setting):
    scene = tripos.Scene.from_text(tripos.Model.from_text(CART), START)
    (name,) = setting
    for call in [
        lambda: scene.simulate(**setting),
        lambda: scene.simulate(progress=True, **setting),
        lambda: scene.sampled(["F"], [0.5], lambda t, values: 0.0, **setting),
        lambda: scene.sensitivity("l", **setting),
        lambda: scene.gradient("theta", **setting),
    ]:
        with pytest.raises(tripos.RequestError, match=f"the setting `{name}` is "):
            call()


def test_settings_may_be_numbers_of_numpy():
    scene = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START)
    run = scene.simulate(samples=np.int64(5), rtol=np.float32(1e-3), until=np.array(1), by=None)
    assert run.t.tolist() == [0.0, 0.25, 0.5, 0.75, 1.0]


@pytest.mark.parametrize(
    "instants", [0.5, [[0.5, 1.0]], "text", [1j], None, np.ma.masked_array([0.5, 1.0], [True, False])]
)
def test_other_instants_are_refused(instants):
    scene = tripos.Scene.from_text(tripos.Model.from_text(CART), START)
    with pytest.raises(tripos.RequestError, match="^instants "):
        scene.sampled(["F"], instants, lambda t, values: 0.0)


def test_few_digits_with_a_controller_give_a_hint_to_make():
    scene = tripos.Scene.from_text(tripos.Model.from_text(CART), START.replace("[0, 2]", "[0, 20]"))

    def make():
        before = [0.0]

        def controller(t, values):
            before[0] += values["theta"]
            return -before[0]

        return controller

    instants = np.arange(0.0, 20.0, 0.5)
    with pytest.warns(tripos.UntrustedRunWarning, match="three digits.* give `make` in its place"):
        scene.sampled(["F"], instants, make())
    with pytest.warns(tripos.UntrustedRunWarning) as caught:
        scene.sampled(["F"], instants, make=make, rtol=1e-1, atol=1e-1)
    assert not any("`make`" in str(warning.message) for warning in caught)


def test_a_copy_of_a_scene_is_set_alone():
    scene = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START)
    scene.set(g=5.0)
    before = scene.simulate().end
    for copied in (scene.copy(), copy.copy(scene), copy.deepcopy(scene)):
        assert copied.simulate().end == before
        copied.set(l=2.0)
        assert copied.simulate().end != before and scene.simulate().end == before
        assert copied._set == {"g": 5.0, "l": 2.0} and scene._set == {"g": 5.0}


def test_copies_outlive_their_originals():
    model = tripos.Model.from_text(tripos.EXAMPLE)
    scene = tripos.Scene.from_text(model, START)
    assert model.path.is_file() and scene.path.is_file()
    models, scenes = (copy.copy(model), copy.deepcopy(model)), (copy.copy(scene), copy.deepcopy(scene), scene.copy())
    folder = model.path.parent.parent
    del model, scene
    gc.collect()
    assert all(copied.check()["degrees_of_freedom"] == 1 for copied in models)
    assert all(copied.reduce() for copied in scenes)
    del models, scenes
    gc.collect()
    assert not folder.exists()


def test_a_scene_may_set_a_number_named_self():
    text = tripos.EXAMPLE.replace("m = {", "self = {").replace('mass = "m"', 'mass = "self"')
    scene = tripos.Scene.from_text(tripos.Model.from_text(text), START)
    scene.set(**{"self": 2.0})
    assert scene._set == {"self": 2.0}


def test_errors_of_a_scene_without_states_are_not_needed():
    m = tripos.Mechanism("Cart")
    m.parameter("m", "kg", 1)
    m.coordinate("x", "m"), m.speed("v", "x'"), m.inertial("N", "O")
    m.point("P", from_="O", frame="N", position=["x", 0, 0])
    m.particle("cart", point="P", mass="m")
    run = tripos.Scene.from_text(m.model(), "span = [0, 2]\n[start]\nx = 1\nv = 3\n").simulate()
    assert run.is_trusted and run.errors is None and run.end["x"] == pytest.approx(7.0)
    for words in (tripos.Run.is_trusted.__doc__, tripos.Run.errors.__doc__):
        assert "not needed" in " ".join(words.split())


def test_a_progress_bar_is_full_after_an_event(capsys):
    pytest.importorskip("tqdm")
    event = '[[events]]\nname = "bottom"\nzero = "theta"\nterminal = true\n'
    scene = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START + event)
    scene.simulate(progress=True)
    assert "100%" in capsys.readouterr().err.split("\r")[-1]
    with pytest.raises(tripos.TriposError):
        scene.simulate(progress=True, method="leapfrog")
    assert "100%" not in capsys.readouterr().err


def test_long_titles_have_short_file_names():
    title = "A pendulum with " + "a very long title " * 30
    model = tripos.Model.from_text(tripos.EXAMPLE.replace('"Pendulum"', f'"{title}"'))
    assert model.check()["degrees_of_freedom"] == 1 and len(model.path.parent.name) <= 60
    assert tripos.Scene.from_text(model, START).reduce()
