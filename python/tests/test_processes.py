"""Forks, threads, other interpreters and signals: an exception or a result, and never a hang."""

import copy
import multiprocessing
import os
import pickle
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"
START = "span = [0, 1]\n[start]\ntheta = 0.5\nomega = 0\n"


def work(_=None):
    """Values that use arrays, a run and a command."""
    model = tripos.Model.from_text(tripos.EXAMPLE)
    scene = tripos.Scene.from_text(model, START)
    values = model.accelerations(np.linspace(0, 1, 5000)[:, None], np.zeros((5000, 1)))
    run = scene.simulate(rtol=1e-10)
    checked = tripos.run_command("prove", model.path).status
    return float(values.sum()), run.end["theta"], checked


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_fork_in_the_middle_of_a_command_and_a_run_has_a_package_that_works():
    expected = work()
    scene = tripos.Scene.from_text(tripos.Model.from_text(tripos.EXAMPLE), START.replace("[0, 1]", "[0, 300]"))
    command = threading.Thread(target=tripos.run_command, args=("simulate", scene.path), kwargs={"rtol": 1e-12})
    run = threading.Thread(target=scene.simulate, kwargs={"rtol": 1e-12, "by": "kane"})
    command.start(), run.start()
    forks = 0
    while command.is_alive() or run.is_alive():
        with multiprocessing.get_context("fork").Pool(1) as pool:
            assert pool.map_async(work, [0]).get(timeout=60) == [expected]
        forks += 1
    command.join(), run.join()
    assert forks > 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
@pytest.mark.parametrize("is_busy", [False, True])
def test_a_fork_has_a_package_that_works(is_busy):
    expected = work()
    stop = threading.Event()
    thread = threading.Thread(target=lambda: [work() for _ in iter(stop.is_set, True)])
    if is_busy:
        thread.start()
    try:
        with multiprocessing.get_context("fork").Pool(2) as pool:
            assert pool.map_async(work, range(4)).get(timeout=100) == [expected] * 4
    finally:
        stop.set()
        if is_busy:
            thread.join()


def test_a_new_process_has_the_same_results():
    code = f"import sys; sys.path[:0] = {sys.path!r}; import test_processes as t; print(t.work())"
    folder = Path(__file__).parent
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=folder, timeout=100)
    assert output.stdout.strip() == repr(work()), output.stderr


def test_threads_run_scenes_and_commands_at_once():
    expected, results = work(), [None] * 6

    def one(at):
        results[at] = work()

    threads = [threading.Thread(target=one, args=(at,)) for at in range(len(results))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=100)
    assert results == [expected] * len(results)


def test_a_second_interpreter_is_refused_or_served():
    interpreters = pytest.importorskip("_xxsubinterpreters" if sys.version_info < (3, 13) else "_interpreters")
    code = f"""
import sys
sys.path[:0] = {sys.path!r}
try:
    import tripos._tripos
except ImportError as error:
    assert "subinterpreter" in str(error) or "interpreter" in str(error), error
"""
    script = f"import {interpreters.__name__} as i; k = i.create(); i.run_string(k, {code!r}); i.destroy(k); print('ended')"
    output = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=100)
    assert output.stdout.strip() == "ended", output.stderr


def test_errors_are_sent_between_processes():
    for error in (tripos.InputError("a"), tripos.RequestError("b"), tripos.StoppedError("c")):
        error.places, error.help = [{"line": 3}], "d"
        copy = pickle.loads(pickle.dumps(error))
        assert type(copy) is type(error) and copy.args == error.args and copy.places == error.places


def test_a_pool_of_new_processes_takes_models_and_scenes_and_returns_runs():
    from concurrent.futures import ProcessPoolExecutor

    model = tripos.Model.from_text(tripos.EXAMPLE)
    scene = tripos.Scene.from_text(model, START)
    scene.set(g=1.62, theta=0.3)
    filed = tripos.Scene(MODELS / "furuta/scenes/swing.toml")
    filed.set(g=5.0)
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        # A command needs a file of the model. New processes import functions of the package, not of this test.
        checks = pool.map(tripos.Model.check, [model, filed.model, scene.model])
        assert [check["degrees_of_freedom"] for check in checks] == [1, 2, 1]
        for own in [scene, filed]:
            assert pool.submit(tripos.Scene.reduce, own).result()
            run, here = pool.submit(tripos.Scene.simulate, own, rtol=1e-10).result(), own.simulate(rtol=1e-10)
            assert type(run) is tripos.Run and run.end == here.end and np.array_equal(run.values, here.values)


def test_copies_by_pickle_are_the_same():
    torque = '[torques.motor]\non = "B"\nframe = "N"\nvector = [0, 0, "F"]\n'
    text = tripos.EXAMPLE + '\n[inputs]\nF = { unit = "N*m" }\n' + torque
    scene = tripos.Scene.from_text(tripos.Model.from_text(text), START)
    scene.set(l=2.0)
    for run in (scene.simulate(), scene.sampled(["F"], [0.2, 0.4], lambda t, values: -values["theta"])):
        for copied in (pickle.loads(pickle.dumps(run)), pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(run)))),
                       copy.copy(run), copy.deepcopy(run)):  # fmt: skip
            assert type(copied) is type(run) and repr(copied) == repr(run)
            public = [name for name in dir(run) if not name.startswith("_") and not callable(getattr(run, name))]
            assert {"t", "values", "names", "end", "errors", "digits", "is_trusted", "ending"} < set(public)
            for name in public:
                assert np.array_equal(getattr(copied, name), getattr(run, name)), name
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        copied = pickle.loads(pickle.dumps(scene, protocol))
        assert copied.simulate().end == scene.simulate().end and copied.model.text == text
        assert pickle.loads(pickle.dumps(scene.model, protocol)).text == text


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
def test_a_forked_child_leaves_the_folders_of_its_parent():
    code = f"""
import sys
sys.path[:0] = {sys.path!r}
import os, tripos
model = tripos.Model.from_text(tripos.EXAMPLE)
folder = model.path.parent
if os.fork() == 0:
    assert model.check()["degrees_of_freedom"] == 1
    sys.exit(0)
assert os.wait()[1] == 0
assert model.check()["degrees_of_freedom"] == 1 and folder.is_dir()
print(folder)
"""
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=100)
    assert output.returncode == 0, output.stderr
    assert not Path(output.stdout.strip()).exists()
