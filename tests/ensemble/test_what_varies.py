"""What of a diagram may vary, and how: distributions, names, units, and each mistake."""

import control
import numpy as np
import pytest
import xarray
from adaptive_loop import mrac
from ensemble_stores import assert_identical
from scipy import stats
from swept import TIMES, lag, springs, system

import clpt_control as clpt
from clpt_control.ensemble.drawn_values import distribution, read_vary
from clpt_control.errors import ClptError


def test_distributions_are_those_of_scipy():
    frozen = stats.gamma(2.0, scale=0.5)
    data = clpt.run_ensemble(lag(), {"tau": frozen}, 400, timepts=TIMES[:2])
    assert stats.kstest(data.tau.values, frozen.cdf).pvalue > 0.9  # a Latin hypercube
    (text,) = data.attrs["vary"] if isinstance(data.attrs["vary"], list) else [data.attrs["vary"]]
    assert text == "tau~gamma(2.0, scale=0.5)"
    again = clpt.run_ensemble(lag(), text, 400, timepts=TIMES[:2])
    assert_identical(again, data)
    assert read_vary(text).text == text
    assert distribution("uniform(0.5, 1)").ppf(0.5) == 1.0


def test_a_dict_says_the_same_of_a_scenario():
    scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    given = {"seed": 1}
    texts = ["learning.gain=0.2:2.0", "flow.parameters~normal:0.1"]
    asked = {"learning.gain": "0.2:2.0", "flow.parameters": "~normal:0.1"}
    assert_identical(
        clpt.run_ensemble(scenario, asked, 4, **given),
        clpt.run_ensemble(scenario, texts, 4, **given),
    )
    vary = {"learning.gain": [0.4, 0.8], "vehicle.max_speed": stats.uniform(2, 1)}
    limited = scenario.with_values({"vehicle.max_speed": 3.0})
    assert clpt.run_ensemble(limited, vary, 4, **given)["vehicle.max_speed"].values.min() >= 2
    vary = {"learning.gain": np.array([0.4, 0.8]), "reference.dwell": [5.0, 10.0, 20.0]}
    grid = clpt.run_ensemble(scenario, vary, **given)
    assert set(vary) <= set(grid.coords)
    assert dict(grid.unstack().clpe_rms_whole.sizes) == {"learning.gain": 2, "reference.dwell": 3}


MISTAKES = [
    ({"vary": {"tua": [1.0]}}, "unknown name tua; did you mean tau\\? May vary: tau, lag.tau, x"),
    ({"vary": {"tau[0]": [1.0]}}, r"tau\[0\] is no element of tau"),
    ({"vary": {"tau": 2.0}}, "tau = 2.0: must be a list of values, a range '0.2:2.0', or a dis"),
    ({"vary": {"tau": []}}, "must be a list of values"),
    ({"vary": {"tau": ["a"]}}, "must be a list of values"),
    ({"vary": {"tau": [[1.0, 2.0]]}}, "each value must be a number"),
    ({"vary": {"tau": [np.inf]}}, r"tau = \[Infinity\]: each value must be a number"),
    ({"vary": {"tau": stats.uniform(0.5, 1)}}, "members: is required where values are drawn"),
    ({"vary": "tau~nothing(1)", "members": 3}, r"nothing\(1\) is no distribution of scipy.stats"),
    ({"vary": "tau~norm(1, a)", "members": 3}, "is no distribution of scipy.stats with numbers"),
    ({"vary": {"tau": stats.norm([0, 1], 1)}, "members": 3}, "must be a list of values"),
    ({"vary": {"tau": [1.0, 2.0]}, "members": 3}, "this grid must have 2 members"),
    ({"timepts": None}, "timepts: is required to run a diagram many times"),
    ({"timepts": [0.0]}, "timepts: must be at least two increasing times"),
    ({"times": [1.0]}, "times: is for a scenario; a diagram has timepts; leave it out"),
    ({"times": [1.0]}, "times: is for a scenario"),
    ({"method": "euler"}, "method = 'euler': must be one of auto, dop853, dopri5, rodas5p"),
    ({"rtol": -1.0}, "rtol = -1.0: must be a number, 0 or more"),
    ({"params": {"tua": 1.0}}, "unknown parameter 'tua'"),
    ({"initial_state": [1.0, 2.0]}, "initial_state: must have 1 numbers"),
]


@pytest.mark.parametrize(("given", "sentence"), MISTAKES)
def test_mistakes_are_one_sentence(tmp_path, given, sentence):
    whole = {"vary": {"tau": [1.0]}, "timepts": TIMES, "out": tmp_path / "e.zarr", **given}
    with pytest.raises(ClptError, match=sentence) as error:
        clpt.run_ensemble(lag(), **whole)
    assert "\n" not in str(error.value)
    assert not list(tmp_path.iterdir())


OF_OTHERS = [  # what is varied of another diagram
    (springs, {"one.K": [[1, 2]], "one.K[0]": [1]}, r"one\.K\[0\] and one\.K are one number; na"),
    (springs, {"one.turns": [1.0]}, r"unknown name one\.turns; may vary: one\.K"),
    (springs, {"one.K[2]": [1.0]}, r"one\.K\[2\] is no element of one\.K"),
    (springs, {"one.K[-1]": [1.0]}, r"one\.K\[-1\] is no element of one\.K"),
    (springs, {"one.K[0:2]": [1.0]}, r"one\.K\[0:2\] is no element of one\.K"),
    (mrac, {"a": [1], "plant.a": [1]}, r"plant\.a and a are one number"),
    (mrac, {"plant.aa": [1]}, r"unknown name plant\.aa; did you mean plant\.a\?"),
    (lag, {"lag.tua": [1]}, r"unknown name lag\.tua; did you mean lag\.tau\?"),
    (clpt.paper_scenario, {"learning.gain": [1.0]}, "timepts: is for a diagram, with timepts; l"),
    (lambda: called("x"), {"x": [1.0]}, "x is more than one of a parameter, an initial state and"),
]


def called(name):
    """A system with a parameter of a name."""
    rate = lambda t, x, u, p: -p[name] * x  # noqa: E731
    return system(rate, outputs=["y[0]", "y[1]"], states=["x", "w"], params={name: 1.0})


@pytest.mark.parametrize(("made", "vary", "sentence"), OF_OTHERS)
def test_names_that_do_not_vary_are_one_sentence(made, vary, sentence):
    with pytest.raises(ClptError, match=sentence):
        clpt.run_ensemble(made(), vary, timepts=TIMES)


@pytest.mark.parametrize("name", ["member", "status", "end", "y_final", "y_index"])
def test_a_name_of_the_result_does_not_vary(name):
    with pytest.raises(ClptError, match=f"{name} is twice a name of the result"):
        clpt.run_ensemble(called(name), {name: [1.0]}, timepts=TIMES)


@pytest.mark.parametrize("two", [np.array([1.0, 2.0]), [1, 2]])
def test_one_name_for_two_shapes_has_the_shape_that_python_control_hands_down(two):
    systems = [
        system(lambda t, x, u, p: -x, params={"K": 1.0}, name="a"),
        system(lambda t, x, u, p: -p["K"][1] * x, params={"K": two}, name="b"),
    ]
    loop = control.interconnect(systems, connections=False, outlist=["b.y"], outputs=["y"])
    with pytest.raises(
        ClptError, match=r"K = \[1.*\]: each value must be an array of shape \(2,\)"
    ):
        clpt.run_ensemble(loop, {"K": [1.0, 2.0]}, timepts=TIMES)
    data = clpt.run_ensemble(loop, {"K[1]": [1.0, 2.0]}, timepts=TIMES, initial_state=1.0)
    np.testing.assert_allclose(data.y_final, np.exp([-5, -10]), atol=1e-9)


def test_states_and_inputs_bring_their_units():
    sail = clpt.Block(
        "sail",
        update=lambda t, x, u, p: {"s": u.v - x.s, "w": -x.w},
        inputs={"v": 1},
        states={"s": 1, "w": 2},
        units={"v": "m/s", "s": "m", "w": "kg"},
    )
    loop = clpt.connect([sail], external="v", name="sailing")
    data = clpt.run_ensemble(loop, {"v": [1.0, 2.0], "sail_s[0]": [0.0, 1.0]}, timepts=TIMES)
    assert data.v.attrs["units"] == "m/s"
    assert data["sail_s[0]"].attrs["units"] == "m"
    assert data.s_rms.attrs["units"] == "m"
    load = clpt.run_ensemble(loop, {"sail_w[0]": [0.0, 1.0]}, timepts=TIMES)
    assert load["sail_w[0]"].attrs["units"] == "kg"
    axes = data.unstack().s_rms.plot.contourf().axes
    assert axes.get_xlabel() == "sail_s[0] [m]"


def test_the_accessor_says_what_it_is():
    data = clpt.run_ensemble(lag(), {"tau": [0.5, 1.0]}, timepts=TIMES)
    assert data.clpt.kind == "ensemble"
    assert repr(data.clpt) == "<clpt of a dataset: ensemble Ensemble of lag>"
    for ask in (data.clpt.plot, lambda: data.clpt.report("page.html")):
        with pytest.raises(ClptError, match=r"is an ensemble of a diagram.*plot\.contourf"):
            ask()


def test_a_state_whose_label_is_a_word_of_the_function_varies():
    def rate(t, x, u, p):
        own = dict(zip(("s", "i"), x, strict=True))
        return [-own["s"] * own["i"], own["s"] * own["i"] - p.get("k", 0.3) * own["i"]]

    spread = system(rate, states=["s", "i"], outputs=["s", "i"])
    found = clpt.run_ensemble(
        spread, {"s": [0.8, 0.9]}, timepts=TIMES, initial_state=[0.5, 0.1], trajectories=True
    )
    assert found.s_.values[:, 0].tolist() == [0.8, 0.9]
    assert found.s_final.equals(found.s_[:, -1].drop_vars("time"))
    one = clpt.simulate(spread, TIMES, initial_state=[0.9, 0.1])
    np.testing.assert_allclose(found.i_final.values[-1], one.i.values[-1], rtol=1e-7)


@pytest.mark.parametrize("key", ["r", "y", "decay_y"])
def test_states_and_inputs_vary_where_python_runs(key):
    """A function that is not read could read any name; it is asked for none."""

    def rate(t, x, u, p):
        return [-p["k"] * float(str(x[0])) + u[0]]

    decay = control.nlsys(
        rate, None, inputs=["r"], states=["y"], outputs=["y"], params={"k": 2.0}, name="decay"
    )
    if key != "y":
        lag = control.tf(1, [1, 1], inputs="y", outputs="z", name="lag")
        decay = clpt.connect([decay, lag], external="r")
    with pytest.warns(UserWarning, match="runs in Python"):
        found = clpt.run_ensemble(decay, {key: [1.0, 3.0]}, timepts=TIMES)
    last = np.exp(-2.0 * TIMES[-1])
    end = (1.0 - last) / 2.0 if key == "r" else last
    np.testing.assert_allclose(found.y_final, [end, 3.0 * end], rtol=1e-6)


def test_an_interrupt_waits_for_one_member_that_python_runs():
    begun = set()

    def rate(t, x, u, p):
        begun.add(p["k"])
        return [-p["k"] * float(str(x[0]))]

    def stop(done):
        if done:
            raise KeyboardInterrupt

    decay = control.nlsys(rate, None, inputs=0, states=1, outputs=1, params={"k": 2.0}, name="d")
    given = {"timepts": TIMES, "threads": 1, "progress": stop}
    with pytest.warns(UserWarning, match="runs in Python"), pytest.raises(KeyboardInterrupt):
        clpt.run_ensemble(decay, "k=1:2", 200, **given)
    assert len(begun) < 20  # those that are tried before, and one or two


def test_an_output_named_as_a_summary_of_another_is_refused():
    system = control.nlsys(lambda t, x, u, p: -p["k"] * x, lambda t, x, u, p: [x[0], 7.0],
                           inputs=0, states=1, outputs=["y", "y_final"], params={"k": 1.0},
                           name="two")  # fmt: skip
    given = {"vary": {"k": [1.0]}, "timepts": TIMES, "initial_state": 1.0}
    with pytest.raises(ClptError, match="y_final is twice a name of the result"):
        clpt.run_ensemble(system, trajectories=True, **given)
    assert clpt.run_ensemble(system, **given).y_final_final.values == 7.0


@pytest.mark.parametrize("times", [5.0, np.array(["2020-01-01", "2020-01-02"], "datetime64[ns]")])
def test_times_that_are_none_are_one_sentence(times):
    with pytest.raises(ClptError, match=r"timepts = .*: must be Sequence.float., an array of"):
        clpt.run_ensemble(lag(), {"tau": [0.5]}, timepts=times)


@pytest.mark.parametrize("label", ["\\", "a\\b", "[0]"])
def test_a_name_that_zarr_does_not_have_is_told(label, tmp_path):
    block = control.nlsys(
        lambda t, x, u, p: -x, None, states=[label], outputs=[label], inputs=["u"], name="lag"
    )
    for out in (None, tmp_path / "e.zarr"):
        with pytest.raises(clpt.DataError, match=r"Zarr has no name .* call that signal otherwise"):
            clpt.run_ensemble(block, {"u": [1.0, 2.0]}, timepts=TIMES, out=out, trajectories=True)
        assert not (tmp_path / "e.zarr").exists()


def test_variables_stand_in_order():
    data = clpt.run_ensemble(lag(), {"tau": [0.5, 1.0]}, timepts=TIMES, trajectories=True)
    assert list(data.data_vars) == sorted(data.data_vars)


def test_values_that_vary_have_the_units_of_their_keys():
    words = ["flow.parameters~normal:0.1", "vehicle.feedback=0.5:2", "reference.dwell=[19, 20]"]
    lengths = {"run.duration": 4.0, "units.length": "km"}
    scenario = clpt.paper_scenario().with_values(lengths)
    words += ["learning.position~normal:1", "learning.gain=1:2"]
    data = clpt.run_ensemble(scenario, words, 2)
    units = {key: data[key].attrs.get("units") for key in data.coords if "." in key}
    assert units == {
        "flow.parameters": "km s-1",
        "learning.gain": None,  # 1/s2 for alpha, less a length squared for K and Gamma
        "learning.position": "km",
        "reference.dwell": "s",
        "vehicle.feedback": "s-1",
    }


def test_an_ensemble_is_written_as_netcdf(tmp_path):
    drawn = clpt.run_ensemble(lag(), {"tau": "1:2"}, 3, timepts=TIMES)
    grid = clpt.run_ensemble(lag(), {"tau": [1.0, 2.0]}, timepts=TIMES).reset_index("member")
    for data in (drawn, grid):
        data.to_netcdf(tmp_path / "many.nc")
        with xarray.open_dataset(tmp_path / "many.nc") as read:
            xarray.testing.assert_equal(read, data)
