"""Mechanisms built in code."""

from pathlib import Path

import numpy as np
import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"


def disk():
    m = tripos.Mechanism("Disk", source="course report")
    m.parameter("M", "kg", 1, positive=True, about='mass, "of the disk"')
    m.parameter("R", "m", 1, positive=True)
    m.parameter("g", "m/s^2", 9.81, positive=True)
    for name, unit in {"q1": "rad", "q2": "rad", "q3": "rad", "q4": "m", "q5": "m", "z": "m"}.items():
        m.coordinate(name, unit)
    speeds = {"u1": "-q2'", "u2": "q1'*cos(q2)", "u3": "q1'*sin(q2) + q3'", "u4": "q4'", "u5": "q5'"}
    for name, definition in speeds.items():
        m.speed(name, definition)
    m.inertial("A", "O")
    m.frame("H", from_="A", axis=3, angle="q1")
    m.frame("B", from_="H", axis=1, angle="pi/2 - q2")
    m.frame("C", from_="B", axis=3, angle="q3 - pi/2")
    m.point("P", from_="O", frame="A", position=["q4", "q5", "z"])
    m.point("Cstar", from_="P", frame="B", position=[0, "R", 0])
    inertia = {"frame": "B", "diagonal": ["M*R^2/4", "M*R^2/4", "M*R^2/2"]}
    m.body("disk", frame="C", centre="Cstar", mass="M", inertia=inertia)
    m.gravity("A", [0, 0, "-g"], zero_at={"q2": 0})
    m.reaction("N", on="disk", at="P", frame="A", direction=[0, 0, 1])
    m.constraint("plane", "z = 0", enforced_by="N")
    m.domain("upright", "abs(q2) < pi/2")
    return m


def test_the_disk_is_that_of_the_library(tmp_path):
    built, library = disk().model(), tripos.Model(MODELS / "disk")
    n = len(library.coordinates)
    assert len(built.coordinates) == n and list(built.speeds) == list(library.speeds)
    random = np.random.default_rng(1)
    q, u = random.uniform(-1, 1, (100, n)), random.uniform(-1, 1, (100, 5))
    # The equations of the library are compiled, and those of the text interpreted.
    assert np.allclose(built.accelerations(q, u), library.accelerations(q, u), rtol=1e-12, atol=1e-13)
    disk().save(tmp_path / "model.toml")
    assert tripos.Model(tmp_path).text == disk().toml()


def test_wrong_elements_are_refused_at_their_line():
    m = disk()
    with pytest.raises(ValueError, match="already"):
        m.parameter("M", "kg")
    m.frame("D", from_="nowhere", axis=3, angle=0.1)
    with pytest.raises(tripos.InputError, match="nowhere") as caught:
        m.model()
    assert "nowhere" in m.toml().splitlines()[caught.value.places[0]["line"] - 1]
    for value in (object(), float("nan"), float("inf")):
        with pytest.raises(ValueError):
            n = tripos.Mechanism("x")
            n.point("P", position=[value])
            n.toml()


def test_names_and_texts_stay_names_and_texts():
    m = tripos.Mechanism('a "title"\n[parameters]')
    m.parameter("l", "m", 1e-300, about="line\nbreak \\ \u202e end")
    assert m.toml().count("\n[parameters]") == 1
    with pytest.raises(tripos.TriposError):
        m.model()
