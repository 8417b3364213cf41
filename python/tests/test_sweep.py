"""Sweeps: on this machine, in blocks, and on workers of Dask that are lost."""

import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import tripos

MODELS = Path(__file__).resolve().parents[2] / "models"
LEANS = "q2=0.05:1.4:301"


@pytest.fixture(scope="module")
def scene():
    return tripos.Scene(MODELS / "disk/scenes/report.toml")


@pytest.fixture(scope="module")
def client():
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def of_the_program(tmp_path, scene, *over, **options):
    file = tmp_path / "table.csv"
    result = tripos.run_command("sweep", scene.path, over=list(over), out=file, **options)
    assert result.status in (0, 3), result.messages
    return file.read_text(encoding="utf-8")


def test_the_table_is_that_of_the_program(tmp_path, scene):
    assert tripos.sweep(scene, LEANS).csv == of_the_program(tmp_path, scene, LEANS)


def test_values_are_texts_or_numbers(scene):
    leans = [0.1, 0.2, 0.30000000000000004]
    table = tripos.sweep(scene, {"q2": leans, "g": np.array([1.62, 9.81])})
    assert len(table) == 6 and table["over:q2"].tolist() == [lean for lean in leans for _ in range(2)]
    assert table.csv == tripos.sweep(scene, ["q2=0.1,0.2,0.30000000000000004", "g=1.62,9.81"]).csv
    assert table["stop"][0] == "end" and table["reason"] == [""] * 6
    assert tripos.sweep(scene, {"q2": 0.1}).csv == tripos.sweep(scene, "q2=0.1").csv
    with pytest.raises(KeyError, match="no column 'lean'"):
        table["lean"]


def test_a_row_is_a_run(scene):
    table = tripos.sweep(scene, {"q2": [0.4]}, by="kane", rtol=1e-10, atol=1e-12)
    own = tripos.Scene(scene.path)
    own.set(q2=0.4)
    run = own.simulate(by="kane", rtol=1e-10, atol=1e-12)
    assert table["q3"][0] == pytest.approx(run.end["q3"], rel=1e-12)


def test_numbers_that_were_set_are_columns():
    own = tripos.Scene(MODELS / "disk/scenes/report.toml")
    own.set(g=1.62)
    table = tripos.sweep(own, {"q2": [0.4]})
    assert table["over:g"].tolist() == [1.62]
    assert table["q3"] == tripos.sweep(tripos.Scene(own.path), ["g=1.62", "q2=0.4"])["q3"]
    # A number that varies has the values of the sweep.
    own.set(q2=0.1)
    assert tripos.sweep(own, {"q2": [0.4]}).csv.splitlines()[0] == table.csv.splitlines()[0]


@pytest.mark.parametrize("blocks", [1, 2, 7, 40])
def test_blocks_one_after_another_are_the_table(scene, blocks):
    request = tripos.SweepRequest.of(scene, LEANS)
    whole = tripos.sweep(scene, LEANS).csv
    tables = [tripos.run_block(request, block, blocks, 1)[0] for block in range(blocks)]
    assert len({table[: table.index("\n")] for table in tables}) == 1
    assert tripos.SweepTable.joined(tables).csv == whole


def test_requests_that_are_wrong_are_refused(scene):
    with pytest.raises(tripos.TriposError, match="lean"):
        tripos.sweep(scene, "lean=0:1:3")
    with pytest.raises(tripos.TriposError):
        tripos.sweep(scene, {"q2": []})
    with pytest.raises(tripos.TriposError, match="method"):
        tripos.sweep(scene, LEANS, method="leapfrog")
    with pytest.raises(tripos.TriposError):
        tripos.sweep(scene, {"q2": [float("nan")]})


def test_points_without_a_result_are_rows(scene):
    table = tripos.sweep(scene, {"M": [0.0, 1.0]})
    assert table["stop"] == ["no-start", "end"]
    assert "`M` is stated to be positive" in table["reason"][0] and table["reason"][1] == ""
    assert np.isnan(table["q1"][0]) and np.isfinite(table["q1"][1])


def test_dask_gives_the_same_bytes(scene, client):
    assert tripos.sweep(scene, LEANS, client=client).csv == tripos.sweep(scene, LEANS).csv
    assert tripos.sweep(scene, LEANS, client=client, blocks=1).csv == tripos.sweep(scene, LEANS).csv


def test_a_scene_without_a_file_goes_to_the_workers(client):
    model = tripos.Model.from_text(tripos.EXAMPLE)
    scene = tripos.Scene.from_text(model, "span = [0, 1]\n[start]\ntheta = 0.5\nomega = 0\n")
    over = {"theta": np.linspace(0.1, 1.0, 20)}
    assert tripos.sweep(scene, over, client=client).csv == tripos.sweep(scene, over).csv


def test_tables_of_inputs_go_to_the_workers(tmp_path, client):
    model = tripos.EXAMPLE.replace("[coordinates]", "[inputs]\ntau = { unit = 'N*m' }\n\n[coordinates]")
    (tmp_path / "signals").mkdir()
    (tmp_path / "signals/drive.csv").write_text("t,torque\n0,0\n1,2\n2,-1\n")
    (tmp_path / "model.toml").write_text(model + "\n[torques]\ndrive = { on = \"B\", frame = \"N\", vector = [0, 0, \"tau\"] }\n")
    (tmp_path / "scenes").mkdir()
    (tmp_path / "scenes/driven.toml").write_text(
        "span = [0, 2]\n[start]\ntheta = 0.5\nomega = 0\n"
        '[inputs]\ntau = { table = "../signals/drive.csv", time = "t", column = "torque" }\n'
    )
    scene = tripos.Scene(tmp_path / "scenes/driven.toml")
    over = {"theta": [0.1, 0.2, 0.3]}
    here = of_the_program(tmp_path, scene, "theta=0.1,0.2,0.3")
    assert tripos.sweep(scene, over, client=client).csv == tripos.sweep(scene, over).csv == here


def test_errors_of_workers_are_raised(scene, client):
    with pytest.raises(tripos.TriposError, match="lean"):
        tripos.sweep(scene, "lean=0:1:3", client=client, retries=0)


def test_a_worker_that_is_killed_loses_nothing(scene, client):
    over = "q2=0.05:1.4:4001"
    expected = tripos.sweep(scene, over, rtol=1e-9).csv
    (first, *_) = client.run(os.getpid).values()

    killed = []

    def kill():
        # The first blocks have ended, and others run.
        time.sleep(0.3)
        os.kill(first, signal.SIGKILL)
        killed.append(time.monotonic())

    killer = threading.Thread(target=kill)
    killer.start()
    table = tripos.sweep(scene, over, client=client, blocks=60, rtol=1e-9)
    assert killed and killed[0] < time.monotonic() - 0.1, "the worker was killed after the sweep"
    killer.join()
    assert table.csv == expected
    assert first not in client.run(os.getpid).values()


def test_tables_are_saved(tmp_path, scene):
    pandas = pytest.importorskip("pandas")
    table = tripos.sweep(scene, LEANS)
    table.save(tmp_path / "table.csv")
    assert (tmp_path / "table.csv").read_bytes() == table.csv.encode()
    frame = table.to_pandas()
    assert len(frame) == 301 and frame["q3"].tolist() == table["q3"].tolist()
    pytest.importorskip("pyarrow")
    table.save(tmp_path / "table.parquet")
    pandas.testing.assert_frame_equal(pandas.read_parquet(tmp_path / "table.parquet"), frame)


def test_a_lazy_frame_is_the_table(tmp_path, scene):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    pytest.importorskip("dask.dataframe")
    frame = tripos.sweep_frame(scene, LEANS, blocks=5)
    assert frame.npartitions == 5
    whole = frame.compute(scheduler="synchronous").reset_index(drop=True)
    assert whole["q3"].tolist() == tripos.sweep(scene, LEANS)["q3"].tolist()
    assert (whole["index"] == np.arange(301)).all()
    frame.to_parquet(tmp_path / "parts")
    assert len(list((tmp_path / "parts").glob("*.parquet"))) == 5
    read = pandas.read_parquet(tmp_path / "parts")
    assert read["q3"].tolist() == whole["q3"].tolist()


@pytest.mark.parametrize("ending", ["parquet", "arrow"])
def test_the_command_writes_tables_in_columns(tmp_path, scene, ending):
    file = tmp_path / f"table.{ending}"
    result = tripos.run_command("sweep", scene.path, over=LEANS, out=file)
    if "table in columns" in result.messages:
        assert result.status == 2 and not file.exists()
        pytest.skip("the package was built without the feature `tables`")
    feather = pytest.importorskip("pyarrow.feather")
    parquet = pytest.importorskip("pyarrow.parquet")
    table = parquet.read_table(file) if ending == "parquet" else feather.read_table(file)
    expected = tripos.sweep(scene, LEANS)
    assert table.column_names == expected.names and table.num_rows == len(expected)
    for name in expected.names:
        column = table[name].to_pylist()
        if name in ("stop", "warning", "reason"):
            assert column == expected[name]
        else:
            cells = np.array([np.nan if value is None else value for value in column], dtype=float)
            assert np.array_equal(cells, expected[name].astype(float), equal_nan=True)
    assert [path.name for path in tmp_path.iterdir()] == [file.name]
    again = tripos.run_command("sweep", scene.path, over=LEANS, out=file)
    assert again.status == 2, "an existing table is kept"
    samples = tmp_path / f"samples.{ending}"
    assert tripos.run_command("simulate", scene.path, out=samples).status in (0, 1)
    read = parquet.read_table(samples) if ending == "parquet" else feather.read_table(samples)
    assert read["t"].to_pylist()[0] == 0.0 and "q3" in read.column_names


@pytest.mark.parametrize("option", ["out", "json", "resume", "shard", "json_"])
def test_options_of_the_command_that_make_no_sense_are_refused(scene, option):
    with pytest.raises(tripos.RequestError, match=rf"`{option}`.*(table\.save|`blocks`)"):
        tripos.sweep(scene, {"q2": [0.1]}, **{option: "table.csv"})
    with pytest.raises(tripos.RequestError, match=option):
        tripos.SweepRequest.of(scene, {"q2": [0.1]}, **{option: "table.csv"})


def test_threads_are_an_option(scene):
    assert tripos.sweep(scene, LEANS, threads=1).csv == tripos.sweep(scene, LEANS).csv
    with pytest.raises(tripos.RequestError, match="threads is 0"):
        tripos.sweep(scene, LEANS, threads=0)
    with pytest.raises(tripos.RequestError, match="run_block"):
        tripos.SweepRequest.of(scene, LEANS, threads=1)


@pytest.mark.parametrize("values", ["12", b"12", ["a"], [[0.1, 0.2]], [None], None, [1j], np.zeros((2, 2))])
def test_values_that_are_no_numbers_are_refused(scene, values):
    with pytest.raises(tripos.RequestError, match="the values of `q2` are "):
        tripos.sweep(scene, {"q2": values})


@pytest.mark.parametrize("blocks", [0, -1, 2.0, "2"])
def test_the_number_of_blocks_is_positive(scene, blocks):
    with pytest.raises(tripos.RequestError, match="`blocks` is "):
        tripos.sweep(scene, LEANS, blocks=blocks)


def test_a_sweep_here_shows_a_bar(scene, capsys):
    pytest.importorskip("tqdm")
    expected = tripos.sweep(scene, LEANS).csv
    capsys.readouterr()
    assert tripos.sweep(scene, LEANS, progress=True).csv == expected
    assert "sweep: 100%" in capsys.readouterr().err.split("\r")[-1]
    assert tripos.sweep(scene, LEANS, blocks=3).csv == expected
    assert tripos.sweep(scene, {"q2": [0.1, 0.2]}, progress=True).csv == tripos.sweep(scene, {"q2": [0.1, 0.2]}).csv


@pytest.mark.parametrize("settings", [{}, {"blocks": 200}])
def test_ctrl_c_keeps_the_finished_rows(scene, settings):
    over = "q2=0.05:1.4:200001"
    threading.Timer(2.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt, match="the first [0-9]+ rows are the attribute `table`") as caught:
        tripos.sweep(scene, over, rtol=1e-9, **settings)
    assert "resume" not in str(caught.value) and "table.csv" not in str(caught.value)
    table = caught.value.table
    assert 0 < len(table) < 200001 and table["index"].tolist() == list(range(len(table)))
    request = tripos.SweepRequest.of(scene, over, rtol=1e-9)
    assert table.csv.startswith(tripos.run_block(request, 0, 200001)[0])


def test_a_wrong_request_starts_no_task(scene):
    class Client:
        def nthreads(self):
            raise AssertionError("the request went to the workers")

    with pytest.raises(tripos.TriposError, match="lean"):
        tripos.sweep(scene, "lean=0:1:3", client=Client())
    with pytest.raises(tripos.RequestError, match="blocks"):
        tripos.sweep(scene, LEANS, client=Client(), blocks=0)


def test_a_scene_goes_to_a_worker(scene, client):
    own = scene.copy()
    own.set(q2=0.3)
    future = client.submit(lambda scene: scene.simulate(until=0.1), own, pure=False)
    assert future.result().end == own.simulate(until=0.1).end
