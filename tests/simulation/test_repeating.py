"""A diagram's run in a file: what it holds repeats it, to the same bytes, without its code."""

import copy
import json
import pickle
import random
import re
import sys
from functools import partial

import control
import numpy as np
import pytest
import xarray
from compared_loops import lemniscate, loop
from error_sentences import says
from example_models import MODELS
from file_damages import json_changed
from random_diagrams import random_diagram
from subprocesses import ran

import clpt_control as clpt

TIMES = np.linspace(0.0, 4.0, 21)
SCENARIO = clpt.paper_scenario().with_values({"run.duration": 20.0})


def at_odd_times(p, t0, t1):
    return np.array([t for t in (1.0, 2.5, 3.3) if t0 < t <= t1])


def kicked():
    ports = {"states": {"a": 1}, "parameters": {"interval": -1.0, "by": 1.0}}
    ports |= {"breakpoints": at_odd_times, "jump": lambda t, x, u, p: {"a": x.a + p.by}}
    return clpt.Block("kicked", update=lambda t, x, u, p: {"a": -x.a}, **ports)


def lag_of(takes, makes, name, pole=-1):
    gains = np.ones((1, len(takes))), 1, 0
    return control.ss(pole, *gains, inputs=[*takes], outputs=makes, name=name)


def nested():
    error = control.summing_junction(["r", "-y"], "e", name="error")
    inner = clpt.connect(
        [error, lag_of("e", "w", "c")], external=["r", "y"], name="inner"
    )
    return clpt.connect(
        [inner, lag_of("w", "y", "plant", -0.3)], external="r", name="outer"
    )


def two_of_one_name():
    """A diagram of two diagrams, each of a block called lag."""
    made = [clpt.connect([lag_of(u, y, "lag")], u, name=y) for u, y in ("ra", "sb")]
    return clpt.connect([*made, lag_of("ab", "y", "last")], external=["r", "s"])


def bounded(t, x, u, p):
    """A way that raises, and a question whether a number is none, are NaN in a record."""
    if x[0] > 1e3:
        raise ValueError("out of range")
    return np.where(x == x, u - x, 0.0)


def of_model(name):
    """Return a run of a model that is differentiated and exported too."""
    system, start, u, h, *_ = MODELS[name]
    return clpt.simulate(system, h * np.arange(41), u or None, start)


def of_random(seed):
    """Return the run of a random diagram, of those that run as machine code."""
    diagram, numbers = random_diagram(random.Random(seed)), np.random.default_rng(seed)
    u, x0 = (
        0.1 * numbers.normal(size=(diagram.ninputs or 0, 5)),
        np.zeros(diagram.nstates or 0),
    )
    return clpt.simulate(diagram, np.linspace(0.0, 0.2, 5), u, x0)


ELSEWHERE = {"papers-loop", "names"}  # which are asked below
STIFF = {
    "rtol": 1e-5,
    "atol": 1e-7,
    "method": "rodas5p",
    "max_step": 0.5,
    "first_step": 0.01,
}
RUNS = {
    **{name: partial(of_model, name) for name in MODELS if name not in ELSEWHERE},
    **{f"random {seed}": partial(of_random, seed) for seed in range(12)},
    "NaN": lambda: clpt.simulate(
        control.nlsys(bounded, states=1, inputs=1, name="b"), TIMES, 1.0
    ),
    "samples": lambda: clpt.simulate(loop(), TIMES, np.sin(TIMES)),
    "start": lambda: clpt.simulate(loop(), TIMES, 1.0, initial_state=[1.0, -2.0]),
    "parameters": lambda: clpt.simulate(loop(), TIMES, 1.0, params={"tank.a": 1.5}),
    "method": lambda: clpt.simulate(loop(), TIMES, 1.0, **STIFF),
    "stop": lambda: clpt.simulate(loop(), TIMES, 1.0, stop=lambda t, y, u: 1.0 - y[0]),
    "nested": lambda: clpt.simulate(nested(), TIMES, np.cos(TIMES)),
    "names": lambda: clpt.simulate(two_of_one_name(), TIMES, [1.0, TIMES]),
    "times": lambda: clpt.simulate(kicked(), TIMES),
    "late": lambda: clpt.simulate(kicked(), TIMES + 0.5),
}


@pytest.fixture
def again(tmp_path):
    """Write a run, and give what is loaded of it and the diagram that repeats it."""

    def saved(run):
        clpt.save_run(run, tmp_path / "run.nc")
        return clpt.load_run(tmp_path / "run.nc"), clpt.load_diagram(
            tmp_path / "run.nc"
        )

    return saved


@pytest.mark.parametrize("name", RUNS)
@pytest.mark.filterwarnings("ignore:.*runs in Python")
def test_a_file_repeats_its_run_to_the_same_bytes(again, name):
    run = RUNS[name]()
    loaded, diagram = again(run)
    assert loaded.equals(run)
    assert "not_repeated" not in loaded.attrs
    repeated = clpt.simulate(diagram)
    if name == "stop":  # its sentence was a function's
        assert run.attrs["status"] == repeated.attrs["status"] == "stopped"
        repeated.attrs["message"] = run.attrs["message"]
    assert run.identical(repeated), "attributes differ, or values"
    assert all(
        run[n].values.tobytes() == repeated[n].values.tobytes() for n in run.variables
    )
    for one in (loaded, repeated):
        assert clpt.simulate(again(one)[1]).equals(run)


def test_what_a_file_repeats_is_what_python_control_runs(again):
    """The loaded diagram has the rates and outputs of the first one, and its poles."""
    (_, loaded), first = again(clpt.simulate(nested(), TIMES, np.cos(TIMES))), nested()
    for ours, theirs in (
        (loaded.dynamics, first.dynamics),
        (loaded.output, first.output),
    ):
        at = 1.5, [2.0, -1.0], [0.7]
        np.testing.assert_allclose(ours(*at), theirs(*at), rtol=1e-12)
    poles = np.sort_complex(control.linearize(loaded, 0, 0).poles())
    np.testing.assert_allclose(
        poles, [-0.65 - 0.9367497j, -0.65 + 0.9367497j], atol=1e-5
    )


def test_what_is_given_takes_the_place_of_what_was_by_all_that_run_it(again):
    usual = {"timepts": TIMES, "inputs": np.sin(TIMES), "initial_state": [1.0, -2.0]}
    run = clpt.simulate(loop(), **usual)
    _, diagram = again(run)
    for given in (
        {"timepts": np.linspace(0.0, 2.0, 5), "inputs": 1.0},
        {"inputs": 2.0},
        {"initial_state": [0.5, 0.0]},
        {"params": {"tank.a": 2.0}},
        {"rtol": 1e-4, "method": "rodas5p"},
    ):
        assert clpt.simulate(diagram, **given).equals(
            clpt.simulate(loop(), **(usual | given))
        )
    found = clpt.sensitivity(diagram, TIMES, to=["tank.a", "x0"])
    np.testing.assert_array_equal(
        found.h, clpt.sensitivity(loop(), to=["tank.a", "x0"], **usual).h
    )
    many = clpt.run_ensemble(diagram, vary="tank.a=[0.5, 1.0]", timepts=TIMES)
    np.testing.assert_allclose(many.h_final[0], run.h[-1], rtol=1e-6)


def test_a_closed_loop_of_ones_own_is_repeated(again, tmp_path):
    run = clpt.simulate(
        clpt.closed_loop(SCENARIO, replace={"reference": lemniscate()}), TIMES
    )
    loaded, diagram = again(run)
    assert loaded.equals(run)
    repeated = clpt.simulate(diagram)
    assert run.identical(repeated)
    clpt.compare({"first": run, "again": repeated})  # it has the names of its scenario
    with pytest.raises(
        clpt.DataError, match=r"alone does not repeat it; clpt\.load_diagram"
    ):
        clpt.load_scenario(tmp_path / "run.nc")
    assert again(clpt.simulate(SCENARIO))[1].origin.scenario == SCENARIO


def test_no_code_is_kept_and_none_is_run(tmp_path):
    """A file made by functions of one process is repeated by another that has none of them."""
    run = RUNS["parameters"]()
    clpt.save_run(run, tmp_path / "run.nc")
    code = (
        "import clpt_control as clpt, sys; run = clpt.simulate(clpt.load_diagram(sys.argv[1])); "
        "print(run.h.values.tobytes().hex())"
    )
    found = ran(sys.executable, "-c", code, tmp_path / "run.nc")
    assert found.stdout.strip() == run.h.values.tobytes().hex()


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


def test_what_cannot_be_recorded_says_so(tmp_path):
    unread = control.nlsys(
        None, lambda t, x, u, p: float(repr(float(u[0]))), inputs=1, outputs=1
    )
    with pytest.warns(UserWarning, match="runs in Python"):
        odd = clpt.simulate(unread, TIMES, 1.0)
    rate = lambda t, x, u, p: -x  # noqa: E731
    unnamed = control.nlsys(rate, inputs=0, states=1, outputs=1, name="two\nlines")
    by_mode = lambda t, x, u, p: -x if p.mode > 0 else -2 * x  # noqa: E731
    changed = clpt.Block("b", update=by_mode, states={"y": 1}, parameters={"mode": 1.0})
    since = clpt.simulate(changed, TIMES, initial_state=[1.0])
    changed.parameters = {"mode": -1.0}
    runs = {
        "of a block or port must not": clpt.simulate(unnamed, TIMES, 0.0, 1.0),
        "by functions that no file holds": odd,
        "another way than": xarray.Dataset(odd.variables, attrs=odd.attrs),
        "changed since it ran": since,
    }
    for why, run in runs.items():
        clpt.save_run(run, tmp_path / "run.nc")
        loaded = clpt.load_run(tmp_path / "run.nc")
        assert loaded.equals(run)
        assert why in loaded.attrs["not_repeated"]
        says(clpt.DataError, why, clpt.load_diagram, tmp_path / "run.nc")
    mute = control.nlsys(rate, lambda t, x, u, p: [], inputs=0, outputs=0, states=1)
    with pytest.raises(
        clpt.DataError, match=r"the run has no signal. Give its system outputs"
    ):
        clpt.save_run(
            clpt.simulate(mute, TIMES, initial_state=[1.0]), tmp_path / "none.nc"
        )
    assert not (tmp_path / "none.nc").exists()


def test_a_parameter_that_the_record_holds_stays(again):
    counted = lambda t, x, u, p: -x.y * sum(1.0 for _ in range(int(p.count)))  # noqa: E731
    block = clpt.Block("b", update=counted, states={"y": 1}, parameters={"count": 2.0})
    _, diagram = again(clpt.simulate(block, TIMES, initial_state=[1.0]))
    np.testing.assert_allclose(clpt.simulate(diagram).y, np.exp(-2 * TIMES), atol=1e-7)
    says(
        clpt.BlockError,
        "is valid for no other",
        clpt.simulate,
        diagram,
        params={"b.count": 3.0},
    )
    with pytest.raises(clpt.ClptError, match="recorded up to"):
        clpt.simulate(again(clpt.simulate(kicked(), TIMES))[1], [0.0, 50.0])


@pytest.fixture
def text_of(tmp_path):
    """Save a run; return the record of its equations in the file, JSON."""

    def text(run):
        clpt.save_run(run, tmp_path / "of.nc")
        return xarray.load_dataset(tmp_path / "of.nc").attrs["equations"]

    return text


@pytest.fixture
def diagram_of(tmp_path):
    """Write a run's file with other equations, JSON as dicts or text; load its diagram."""
    clpt.save_run(RUNS["samples"](), tmp_path / "whole.nc")
    run = xarray.load_dataset(tmp_path / "whole.nc").drop_encoding()

    def loaded(equations):
        text = equations if isinstance(equations, str) else json.dumps(equations)
        run.assign_attrs(equations=text).to_netcdf(tmp_path / "other.nc")
        return clpt.load_diagram(tmp_path / "other.nc")

    return loaded


def test_runs_that_are_copied_cut_or_pickled_keep_what_repeats_them(tmp_path, text_of):
    run = RUNS["samples"]()
    copies = [copy.deepcopy(run), run.copy(deep=True), pickle.loads(pickle.dumps(run))]
    for one in (*copies, run.isel(time=slice(2, 9)), run[["h"]]):
        assert text_of(one) == text_of(run)
    run.to_netcdf(tmp_path / "theirs.nc")  # xarray's own way holds the data alone
    assert clpt.load_run(tmp_path / "theirs.nc").equals(run)


def test_changed_equations_are_one_sentence_or_a_diagram(text_of, diagram_of):
    texts = [text_of(RUNS[name]()) for name in ("parameters", "sampled-tank", "times")]
    rng, refused = np.random.default_rng(3), []
    for k in range(150):
        json_changed(rng, plain := json.loads(texts[k % 3]))
        try:
            diagram_of(plain)
        except clpt.DataError as error:
            refused.append(str(error))
    damaged = "(?s).*other.nc: its equations are damaged: .*"
    assert all(re.fullmatch(damaged, said) for said in refused)
    assert len(refused) > 75
    for row, column in ((0, -1), (-1, 0), (0, 99)):  # a wire from or to no signal
        plain = json.loads(texts[0])
        plain["diagram"]["connections"][0][:2] = row, column
        says(clpt.DataError, "its equations are damaged: ", diagram_of, plain)


LINES = [
    *(
        ["view", [0], *at]
        for at in ([[2], [[0, 1, 1]]], [[1], [[0, -1, 1]]], [[], [7]])
    ),  # beside
    *([kind, [0], [2], None] for kind in ("mul", "import os", "fill")),
    *(["leaf", [], *of] for of in ([[5], ["x", "h"]], [[2], ["x", "secret"]])),
    *(["part", [0], *of] for of in ([[2, 1], 1], [[1], -1])),
    *(["part", at, *of] for at, *of in ([[0, 0], [2, 1], 0], [[0.5], [1, 1], 0])),
    ["sum", [0], [2], 0],
    ["mul", [0, 9], [2], None],
    ["exp", [0], [3], None],
    ["constant", [], [2], [1.0]],
    ["join", [0, 0], [3], None],
    ["join", [0, 0], [4, 2], None],
    ["stack", [0], [2, 2], None],
    ["pick", [0, 0], [], None],
]


@pytest.mark.parametrize("line", [*LINES, "no memory holds"], ids=str)
def test_a_line_of_a_record_that_is_none_is_refused(line, text_of, diagram_of):
    """What machine code would believe: each is told, none is run."""
    plain, said = (
        json.loads(text_of(RUNS["samples"]())),
        "damaged: .*(record|KeyError)",
    )
    record = plain["diagram"]["blocks"][1]["records"]["output"]
    assert record["operations"][0][:3] == ["leaf", [], [2]]
    if line in LINES:
        record["operations"].append(line)
    else:
        record["operations"] += [["fill", [0.5], [5_000_000], None]] * 21
        said = r"has 1.05e\+08 numbers; at most 1e\+08"
    says(clpt.DataError, said, diagram_of, plain)


def test_damaged_numbers_of_a_run_are_one_sentence(tmp_path):
    clpt.save_run(RUNS["samples"](), tmp_path / "run.nc")
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
        "equations": whole.assign_attrs(equations="{" * 5000),
        "number": whole.assign_attrs(equations=3.5),
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


def test_names_of_a_file_are_neither_markup_nor_formulas(
    again, tmp_path, text_of, diagram_of
):
    """Ports, blocks and units of a stranger's file, on its page."""
    text = text_of(RUNS["samples"]())
    others = {
        '"gauge"': '"<b>$x_$"',
        '"v"': '"v$_{<i>"',
        '"v[': '"v$_{<i>[',
        '"m3/s"': '"$\\\\frac{<u>"',
    }
    for one, other in others.items():
        text = text.replace(one, other)
    loaded, _ = again(clpt.simulate(diagram_of(text)))
    clpt.report(loaded, tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text()
    assert not [tag for tag in ("<b>$", "<i>", "<u>") if tag in page]
    assert [tag in page for tag in ("&lt;i&gt;", "&lt;u&gt;")] == [True, True]
