"""`dataset.clpt`: there whichever import came first, and one sentence for what is not ours."""

import subprocess
import sys

import numpy as np
import pytest
import xarray
from made_fields import uniform_field

import clpt_control as clpt

ORDERS = (
    "import clpt_control, xarray",
    "import xarray, clpt_control",
    "import clpt_control.scenario, xarray.core",
)


@pytest.mark.processes  # test_core_install asks one of them
@pytest.mark.parametrize("order", ORDERS)
def test_it_is_there_whichever_was_imported_first(order):
    code = f"{order}; import xarray; xarray.Dataset().clpt"
    subprocess.run([sys.executable, "-W", "error", "-c", code], check=True)


def test_a_run_and_its_file_as_xarray_opens_it(made, scenario, tmp_path):
    run = made["run"]
    clpt.save_run(run, tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc") as opened:
        for one in (opened, run.isel(time=slice(3, 20))):
            assert one.clpt.kind == "run"
            assert one.clpt.scenario == scenario
            assert len(one.clpt.plot()) == 7
        report = clpt.report(opened.isel(time=[-1]), tmp_path / "page.html")
    assert report["kind"] == "Run of a scenario"


def test_a_field_is_found_from_the_file_alone(scenario, tmp_path):
    """The scenario's field is relative to its file, also for xarray's own opening."""
    uniform_field(tmp_path / "field.nc")
    flow = {"flow": {"field": str(tmp_path / "field.nc")}}
    clpt.save_scenario(scenario.with_values(flow), tmp_path / "s.toml")
    loaded, vary = clpt.load_scenario(tmp_path / "s.toml"), "learning.gain=0.2:2.0"
    clpt.save_run(clpt.simulate(loaded), tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc") as opened:
        assert clpt.simulation.track_plot(opened).has_data()
    for out in (None, tmp_path / "e.zarr"):
        data = clpt.ensemble.run_ensemble(loaded, vary, 2, out=out)
        assert data.clpt.scenario.field_path.is_file()
    assert xarray.open_zarr(out, consolidated=False).clpt.scenario.field_path.is_file()


def test_teams_ensembles_and_replays(made, scenario, tmp_path):
    replay, data = made["replay"], clpt.replay.replay_dataset(made["replay"])
    for kind, one, count in (
        ("team", made["team"], 3),
        ("ensemble", made["ensemble"], 2),
        ("replay", data, 5),
    ):
        assert one.clpt.kind == kind
        assert len(one.clpt.plot()) == count
        assert f"clpt of a dataset: {kind}" in repr(one.clpt)
    assert [*made["team"].clpt.scenario.members.values()] == [scenario, scenario]
    assert made["ensemble"].clpt.scenario == scenario
    data.to_netcdf(tmp_path / "replay.nc")
    with xarray.open_dataset(tmp_path / "replay.nc") as opened:  # times decoded
        for plot in (clpt.replay.current_plot, clpt.replay.map_plot, clpt.replay.dive_clpe_plot):
            for of_data, own in zip(np.ravel(plot(opened)), np.ravel(plot(replay)), strict=True):
                assert of_data.get_title(loc="left") == own.get_title(loc="left")
                for a, b in zip(of_data.lines, own.lines, strict=True):
                    np.testing.assert_allclose(a.get_ydata(), b.get_ydata(), atol=1e-3)


def test_what_is_not_ours_is_one_sentence(made):
    foreign = xarray.Dataset({"a": 1})
    assert repr(foreign.clpt) == "<clpt of a dataset: none of clpt's>"
    for ask in (
        lambda: foreign.clpt.plot(),
        lambda: foreign.clpt.scenario,
        lambda: clpt.simulation.track_plot(foreign),
        lambda: clpt.replay.map_plot(foreign),
        lambda: clpt.animate(foreign),
        lambda: clpt.report(foreign, "page.html"),
        lambda: clpt.replay.map_plot(made["run"]),
    ):
        with pytest.raises(clpt.ClptError) as caught:
            ask()
        assert "\n" not in str(caught.value)


def test_a_run_is_linearized_at_one_of_its_times(scenario):
    scenario = clpt.theory.started_true(scenario)
    run = clpt.simulate(scenario)
    made = run.clpt.linearize(10.0, input="zc", output="x", minimal=True)
    steered = clpt.closed_loop(scenario, external="zc")
    state, desired = clpt.state_at(run, 10.0), run.reference.sel(time=10.0).values
    whole = clpt.linearize(steered, state, desired, 10.0)
    assert (made.nstates, made.input_labels) == (2, ["zc[0]", "zc[1]"])
    np.testing.assert_allclose(
        made(1j), whole(1j)[whole.output_labels.index("x[0]") :][:2], atol=1e-12
    )
    assert run.clpt.linearize(10.0).ninputs == 0
    cut = run.clpt.linearize(10.0, input="x", output="alpha")
    assert cut.state_labels[0] == "learning_model_z[0]"
    with pytest.raises(clpt.ArgumentError, match="has no 'nothing'"):
        run.clpt.linearize(10.0, output="nothing")
    changed = clpt.simulate(scenario, params={"basis_x.widths": [1.0, 2.0, 3.0]})
    with pytest.raises(clpt.DataError, match="does not hold its diagram"):
        changed.clpt.linearize(10.0)
