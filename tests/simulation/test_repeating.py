"""Files of diagrams' runs: the same data, what made them, and damages that are refused."""

import copy
import json
import pickle

import control
import numpy as np
import pytest
import xarray
from compared_loops import lemniscate, loop
from error_sentences import says

import clpt_control as clpt

TIMES = np.linspace(0.0, 4.0, 21)
SCENARIO = clpt.paper_scenario().with_values({"run.duration": 20.0})


def given_much():
    """A run with arguments of every kind."""
    solver = {"rtol": 1e-5, "atol": 1e-7, "method": "rodas5p", "max_step": 0.5}
    return clpt.simulate(
        loop(), TIMES, np.sin(TIMES), params={"tank.a": 1.5}, first_step=0.01, **solver
    )


@pytest.fixture
def saved(tmp_path):
    """Write a run; return what is loaded of it, and the attributes of the file."""

    def saved(run):
        clpt.save_run(run, tmp_path / "run.nc")
        attributes = xarray.load_dataset(tmp_path / "run.nc").attrs
        return clpt.load_run(tmp_path / "run.nc"), attributes

    return saved


def test_a_file_says_how_its_run_was_made(saved, tmp_path):
    run = given_much()
    loaded, attributes = saved(run)
    assert loaded.identical(run)
    assert json.loads(attributes["arguments"]) == {
        **{"params": {"tank.a": 1.5}, "method": "rodas5p"},
        **{"rtol": 1e-5, "atol": 1e-7, "max_step": 0.5, "first_step": 0.01},
    }
    labels = json.loads(attributes["labels"])
    assert (labels["name"], labels["inputs"]) == ("loop", ["q[0]"])
    assert attributes["comment"] == "The script that made this run repeats it"
    assert f"numpy {np.__version__}" in attributes["software"]
    assert not [text for text in attributes if "equations" in text]
    again, others = saved(loaded)
    assert again.identical(run)
    assert others == attributes
    sentence = "contains no scenario. Give a scenario or its run; repeat the run of a "
    says(clpt.DataError, sentence, clpt.load_scenario, tmp_path / "run.nc")


def test_a_loaded_run_has_the_labels_of_its_diagram(saved):
    run = given_much()
    loaded, _ = saved(run)
    for response in (run.clpt.response(), loaded.clpt.response()):
        assert response.input_labels == ["q[0]"]
        assert response.output_labels[:2] == ["h[0]", "h[1]"]
        assert response.sysname == "loop"


def test_a_closed_loop_with_own_parts_is_not_repeated_by_its_scenario(saved, tmp_path):
    own = clpt.closed_loop(SCENARIO, replace={"reference": lemniscate()})
    run = clpt.simulate(own, TIMES)
    loaded, _ = saved(run)
    assert loaded.identical(run)
    clpt.compare({"first": run, "again": loaded})  # it has the names of its scenario
    sentence = "alone does not repeat it. Give the scenario itself, and "
    says(clpt.DataError, sentence, clpt.load_scenario, tmp_path / "run.nc")


def test_a_run_that_grows_far_has_its_page_but_for_axes_beyond_the_largest_double(
    tmp_path,
):
    growing = control.ss(1, 1, 1, 0, name="growing", outputs="y")
    clpt.save_run(clpt.simulate(growing, [0, 100, 200], 0.0, 1.0), tmp_path / "run.nc")
    clpt.report(tmp_path / "run.nc", tmp_path / "run.html")
    assert "e+86</td>" in (tmp_path / "run.html").read_text("utf-8")  # exp(200)
    still = control.ss(0, 1, 1, 0, name="still", outputs="y")
    run = clpt.simulate(still, [0, 1], 0.0, 1.7e308)
    with pytest.raises(
        clpt.ClptError, match=r"a figure cannot be drawn: .*; numbers above 1e307"
    ):
        clpt.report(run, tmp_path / "far.html")
    assert not (tmp_path / "far.html").exists()


def test_a_run_without_signals_is_not_saved(tmp_path):
    decay = control.nlsys(
        lambda t, x, u, p: -x, lambda t, x, u, p: [], inputs=0, outputs=0, states=1
    )
    run = clpt.simulate(decay, TIMES, initial_state=[1.0])
    sentence = r"the run has no signal. Give its system outputs"
    says(clpt.DataError, sentence, clpt.save_run, run, tmp_path / "none.nc")
    assert not (tmp_path / "none.nc").exists()


def test_runs_that_are_copied_cut_or_pickled_have_their_notes(saved, tmp_path):
    run = given_much()
    wanted = saved(run)[1]
    copies = [copy.deepcopy(run), run.copy(deep=True), pickle.loads(pickle.dumps(run))]
    for one in (*copies, run.isel(time=slice(2, 9)), run[["h"]]):
        assert saved(one)[1] == wanted
    run.to_netcdf(tmp_path / "theirs.nc")  # xarray's own way holds the data alone
    assert clpt.load_run(tmp_path / "theirs.nc").equals(run)


def test_damaged_numbers_of_a_run_are_one_sentence(tmp_path):
    clpt.save_run(given_much(), tmp_path / "run.nc")
    whole = xarray.load_dataset(tmp_path / "run.nc")
    damaged = {
        "nan": whole.assign(h=whole.h * np.nan),
        "words": whole.assign(h=("time", ["a"] * 21)),
        "times": whole.assign_coords(time=whole.time.values[::-1]),
        "no sample": whole.isel(time=slice(0, 0)),
        "one time": whole.isel(time=0),
        "no signal": whole[["states"]],
        "another": whole.assign(n=1.0),
        "title": whole.assign_attrs(title=3.5),
        "count": whole.assign_attrs(solver_steps="\t"),
        "labels": whole.assign_attrs(labels="{" * 5000),
        "number": whole.assign_attrs(labels='{"inputs": [3.5]}'),
        "no list": whole.assign_attrs(labels='{"inputs": 3}'),
        "arguments": whole.assign_attrs(arguments='{"system": 1}'),
        "units": whole.assign(h=whole.h.assign_attrs(units=3.5)),
    }
    for how, data in damaged.items():
        data.drop_encoding().to_netcdf(tmp_path / f"{how}.nc")
        says(
            clpt.DataError,
            rf"\A.*{tmp_path}.*\Z",
            clpt.load_run,
            tmp_path / f"{how}.nc",
        )


@pytest.mark.long
def test_names_of_a_file_are_neither_markup_nor_formulas(saved, tmp_path):
    """Ports and units of a stranger's file, on its page."""
    run = given_much()
    run["v"].attrs["units"] = "$\\frac{<u>"
    loaded, _ = saved(run.rename({"v": "v$_{<i>", "mean": "x<b>$_$"}))
    clpt.report(loaded, tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text()
    assert not [tag for tag in ("<b>", "<i>", "<u>") if tag in page]
    assert [tag in page for tag in ("&lt;i&gt;", "&lt;u&gt;")] == [True, True]
