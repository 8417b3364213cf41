"""Commands of the program as functions."""

import os
import signal
import threading
import time
from pathlib import Path

import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"


def test_every_command_can_be_called():
    listed = tripos.run_command("--help").output
    assert "simulate" in listed and "grade" in listed
    assert tripos.run_command("schema", "model").output.startswith("{")


def test_answers_are_those_of_the_program():
    model = tripos.Model(MODELS / "furuta")
    assert [part["formulation"] for part in model.derive()["formulations"]] == ["kane", "lagrange", "newton-euler"]
    (kane,) = model.derive("kane")["formulations"]
    assert kane["mass_matrix"][0][1] == kane["mass_matrix"][1][0] == "L1*l2*m2*cos(theta2)"
    assert "\\begin" in model.latex("kane") and "$" in model.markdown("kane")


def test_failures_are_exceptions_with_their_places(tmp_path):
    broken = tripos.EXAMPLE.replace('angle = "theta"', 'angle = "phi"')
    (tmp_path / "model.toml").write_text(broken)
    with pytest.raises(tripos.InputError, match="phi") as caught:
        tripos.answer("prove", tmp_path)
    assert caught.value.places[0]["line"] > 1
    with pytest.raises(tripos.RequestError):
        tripos.answer("derive", MODELS / "disk", by="hamilton")
    with pytest.raises(tripos.TriposError):
        tripos.answer("no such command")
    with pytest.raises(tripos.TriposError):
        tripos.answer("check", "--json=--out")


def test_equations_are_objects_of_other_packages():
    pytest.importorskip("sympy")
    model = tripos.Model.from_text(tripos.EXAMPLE)
    assert str(model.sympy().mass_matrix[0]) == "l**2*m"
    module = model.numpy()
    assert module.mass_matrix(module.DEFAULTS, [0.3], [0.0]).tolist() == [[1.0]]


def test_a_linear_system_about_a_state():
    model = tripos.Model.from_text(tripos.EXAMPLE)
    about = {"state": {"theta": 0.0, "omega": 0.0}}
    system = model.linearise(about)
    assert system["A"][1][0] == pytest.approx(-9.81)
    with pytest.raises(tripos.RequestError):
        model.linearise({"state": {"theta": float("nan"), "omega": 0.0}})


def test_pictures_and_pages_are_shown_by_notebooks():
    assert tripos.Model(MODELS / "furuta").sketch()._repr_svg_().startswith("<svg")
    scene = tripos.Scene(MODELS / "furuta/scenes/swing.toml")
    assert "<iframe srcdoc=" in scene.view()._repr_html_()
    assert "<svg" in scene.figure("theta2")


def test_ctrl_c_ends_a_command(tmp_path):
    scene = tripos.Scene(MODELS / "furuta/scenes/swing.toml")
    threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        tripos.answer("sweep", scene.path, over=["theta2=0.1:1:1000000"], out=tmp_path / "table.csv")
    assert time.monotonic() - begin < 30
    # The next command is not interrupted.
    assert tripos.run_command("check", MODELS / "furuta").status == 0


def test_commands_from_several_threads_wait_for_one_another():
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: tripos.run_command("check", MODELS / "furuta"), range(6)))
    assert len({result.output for result in results}) == 1 and results[0].output


def test_the_docs_name_every_command():
    listed = tripos.run_command("--help").output.split("Commands:")[1].split("Options:")[0]
    commands = [line.split()[0] for line in listed.splitlines() if line.startswith("  ") and line[2:3].strip()]
    table = (MODELS.parent / "docs" / "python.md").read_text().split("## Commands")[1]
    assert len(commands) > 25 and [name for name in commands if f"`{name}`" not in table] == []
