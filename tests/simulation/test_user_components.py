"""The paper's diagram with other parts and numbers: what runs, is recorded and is refused."""

import re
from functools import partial

import control
import law_blocks
import numpy as np
import pytest
from error_sentences import says
from film_frames import frame_of
from matplotlib.quiver import Quiver
from matplotlib.text import Text
from still_water import CALM, KD, POINTS, GammaD, exact_positions
from xarray.testing import assert_allclose, assert_equal, assert_identical

import clpt_control as clpt
from clpt_control import BlockError, ClptError, DataError, DiagramError, prove

PAPER = clpt.paper_scenario().with_values({"run.duration": 30})
LIMITED = PAPER.with_values({"vehicle.max_speed": 1.0})
TIGHT = {"rtol": 1e-11, "atol": 1e-13}
LAG = control.tf(1, [0.5, 1], name="lag")
ENGINES = ("native", "python")


@pytest.mark.long
@pytest.mark.parametrize("engine", ENGINES)
def test_a_lag_of_one_line_is_its_closed_form(engine):
    times = np.linspace(0, 5, 11)
    loop = clpt.closed_loop(CALM, insert={("v_x", "vehicle"): LAG})
    run = clpt.simulate(loop, times, engine=engine, **TIGHT)
    np.testing.assert_allclose(run.position, exact_positions(times, 0.5), atol=1e-8)
    matrices = {"lag.A": -np.eye(2) / 0.2, "lag.C": np.eye(2) / 0.2}
    start = [clpt.initial_state(CALM), 0]
    run = clpt.simulate(loop, times, 0, start, params=matrices, engine=engine, **TIGHT)
    np.testing.assert_allclose(run.position, exact_positions(times, 0.2), atol=1e-8)


def test_what_passes_everything_on_changes_nothing():
    through, plain = control.tf(1, 1, name="through"), clpt.simulate(PAPER)
    for where in (
        "v_x",
        ("x", "clpe", "basis_x"),
        "phi_x",
        ("K", "learning_controller"),
    ):
        run = clpt.simulate(clpt.closed_loop(PAPER, insert={where: through}))
        assert_allclose(run[list(plain)], plain, rtol=0, atol=1e-7)


def test_parts_of_one_wide_port_in_a_row_and_names_of_ones_own():
    ports = {
        "inputs": ["v[0]", "v[1]"],
        "outputs": ["v_f[0]", "v_f[1]"],
        "name": "motor",
    }
    motor = control.ss(-np.eye(2), np.eye(2), np.eye(2), 0, **ports)
    loop = clpt.closed_loop(PAPER, insert={("v_x", "vehicle"): motor, "v_f": LAG})
    assert loop.state_labels[-4:] == [
        "motor_x[0]",
        "motor_x[1]",
        "lag_x[0]",
        "lag_x[1]",
    ]
    run = clpt.simulate(loop, [0, 1], 0, [clpt.initial_state(PAPER), 0])
    assert {"v_x", "v_f", "v_f_lag"} <= set(run.data_vars)


def test_a_replaced_vehicle_starts_where_the_scenario_says():
    ports = {"inputs": [f"{port}[{k}]" for port in ("flow_x", "v_x") for k in (0, 1)]}
    ports |= {"outputs": ["x[0]", "x[1]"], "name": "boat"}
    boat = control.ss(0 * np.eye(2), np.hstack([np.eye(2)] * 2), np.eye(2), 0, **ports)
    (vehicle,) = (one for one in clpt.paper_blocks(PAPER) if one.name == "vehicle")
    hull = clpt.connect([vehicle], external=["flow_x", "v_x"], name="hull")
    scenario = PAPER.with_values({"vehicle.position": [1.0, -2.0]})
    plain = clpt.simulate(scenario)
    for own, first in ((boat, "boat_x[0]"), (hull, "hull_vehicle_x[0]")):
        run = clpt.simulate(clpt.closed_loop(scenario, replace={"vehicle": own}))
        np.testing.assert_allclose(run.position, plain.position, rtol=0, atol=1e-7)
        assert (run.state.values[0], "lyapunov" in run) == (first, True)


def test_a_port_of_one_in_and_one_out_takes_the_names_it_replaces():
    limits = {"inputs": 2, "outputs": 2, "name": "saturation"}
    saturation = control.nlsys(
        None, lambda t, x, u, params: np.clip(u, -1, 1), **limits
    )
    run = clpt.simulate(clpt.closed_loop(LIMITED, replace={"speed_limit": saturation}))
    assert run.attrs["engine"] == "native"
    assert abs(run.velocity).max() == 1.0
    np.testing.assert_allclose(run.velocity, run.commanded_velocity.clip(-1, 1))


WIDE = control.ss(-np.eye(3), np.eye(3), np.eye(3), 0, name="w")
UNFIT = [
    ({"external": ("zcc",)}, "external: there is no zcc. Did you mean 'zc'"),
    ({"replace": {"vehicel": LAG}}, "replace: there is no vehicel. Did you mean 'vehicle'"),
    ({"replace": {"vehicle": LAG}}, "replace = vehicle: no block makes 'x' now. Rename"),
    ({"insert": {"v_c": LAG}}, "insert = 'v_c': must begin with one of Gamma, K, alpha"),
    ({"insert": {("v_x", "clpe"): LAG}}, "'v_x' goes to vehicle, not to 'clpe'"),
    ({"insert": {"v_x": LAG, "zc": LAG}}, "two blocks are called 'lag'"),
    ({"insert": {"v_x": WIDE}}, r"'v_x_w' has 3 signals, but vehicle takes 2; both must"),
    ({"insert": {"v_x": clpt.parts.saturation(-1, 1)}}, r"vehicle takes 2; .* signals="),
    ({"insert": {"v_x": control.summing_junction(["a", "b"], "c", name="sum")}},
     r"sum takes a, b. Rename the intended port to 'v_x'"),
    ({"insert": {("v_x", 3): LAG}}, "not to 3"),
    ({"insert": {(): LAG}}, "must begin with one of"),
    ({"law": "sigma"}, "law = 'sigma': must be a Block"),
    ({"law": law_blocks.papers_law(N=2)}, r"alpha of N = 2 functions; the scenario has 3"),
    ({"law": clpt.paper_blocks(PAPER)[0]}, r"a law makes alpha\[2N\], K\[2\] and Gamma\[2\]"),
    ({"law": law_blocks.papers_law(), "replace": {"adaptation": WIDE}}, "both replace the law"),
]  # fmt: skip


@pytest.mark.parametrize(("changes", "said"), UNFIT, ids=[said for _, said in UNFIT])
def test_what_does_not_fit_is_refused_in_a_sentence(changes, said):
    says(ClptError, rf"\A.*{said}.*\Z", clpt.closed_loop, PAPER, **changes)


def test_a_loop_that_knows_its_scenario_is_its_scenario():
    """Times, start, tolerances and attributes."""
    later, loop = PAPER.with_values({"vehicle.position": [1.0, 2.0]}), clpt.closed_loop
    plain, run = clpt.simulate(later), clpt.simulate(loop(later))
    assert_identical(run[list(plain)], plain)
    from_ten = clpt.simulate(loop(later), [10.0, 12.0])
    np.testing.assert_array_equal(
        from_ten.states, clpt.simulate(later, [10.0, 12.0]).states
    )
    # a scenario's is at t = 0, a diagram's at once
    moved = clpt.initial_state(later) + 0.25
    run = clpt.simulate(loop(later), [10.0, 12.0], initial_state=moved)
    np.testing.assert_array_equal(run.clpt.state(10.0), moved)
    run = clpt.simulate(later, [10.0, 12.0], initial_state=moved)
    before = clpt.simulate(later, [0.0, 10.0], initial_state=moved)
    np.testing.assert_allclose(run.states[0], before.states[-1], atol=1e-6)
    fast = clpt.simulate(loop(LIMITED))
    assert fast.attrs["message"] == clpt.simulate(LIMITED).attrs["message"]
    law = clpt.paper_blocks(PAPER.with_values({"learning.gain": 2.0}))[-1]
    loops = [
        loop(PAPER, **own) for own in ({"law": law}, {"replace": {"adaptation": law}})
    ]
    assert clpt.simulate(loops[0]).identical(clpt.simulate(loops[1]))
    with pytest.raises(
        clpt.ScenarioError, match="timepts: is required to run a diagram"
    ):
        clpt.run_ensemble(loop(later, external="zc"), "learning.gain=0.2:2.0", 2)


@pytest.mark.parametrize("change", ["wires", "numbers"])
def test_what_was_done_to_a_loop_since_is_in_its_run(change):
    loop = clpt.closed_loop(PAPER)
    if change == "wires":
        loop.set_connect_map(0.5 * loop.connect_map)
    else:
        loop.syslist[-1].parameters = loop.syslist[-1].parameters._replace(gain=3.0)
    run = clpt.simulate(loop)
    assert run.attrs["own_parts"] == "closed_loop: run as a diagram"
    assert not np.allclose(
        run.predicted_position, clpt.simulate(PAPER).predicted_position
    )
    for use in (lambda own: clpt.run_ensemble(own, "learning.gain=0.2:2.0", 2), prove):
        says(DiagramError, "closed_loop: was changed after closed_loop", use, loop)


def test_nothing_is_told_of_a_run_whose_parts_its_scenario_does_not_hold():
    """A reference that leaves z_2 at rest teaches nothing of Gamma_2; a slow law is no fast one."""
    gramian = partial(clpt.gramian, window=20.0, start=0.0)

    def said_of_decay(run):
        found, reason = gramian(run).certified
        assert found is None
        return reason

    times, loop = np.linspace(0, 30, 601), clpt.closed_loop(PAPER)
    lagging = clpt.closed_loop(PAPER, insert={("v_x", "vehicle"): LAG})
    own_law = clpt.closed_loop(PAPER, law=law_blocks.papers_law())
    assert prove(own_law, points=100).status == "proved"
    says(
        ClptError,
        "has v_x to vehicle: lag, so V' is not its law's alone",
        prove,
        lagging,
    )
    run = clpt.simulate(lagging, times)
    said = "The run has parts given in Python, v_x to vehicle: lag"
    assert said in said_of_decay(run)
    says(ClptError, "v_x .* its vehicle is not known", clpt.currents.flow_estimate, run)
    rests = lambda t, x, u, p: {"zc": [np.cos(t), 0.0]}  # noqa: E731
    still = clpt.Block("reference", output=rests, outputs={"zc": 2})
    run = clpt.simulate(clpt.closed_loop(PAPER, replace={"reference": still}), times)
    says(ClptError, "made with a reference that its scenario does not", gramian, run)
    wide = clpt.simulate(loop, times, params={"basis_x.widths": np.full(3, 1e3)})
    says(
        ClptError, "made with a basis_x that its scenario does not have", gramian, wide
    )
    slow = clpt.simulate(loop, times, params={"adaptation.gain": 1e-3})
    assert gramian(slow).window == 20.0
    assert 'at call time, {"adaptation.gain": 0.001}' in said_of_decay(slow)
    run = clpt.simulate(own_law, times)
    assert re.search(
        "no certificate: .* The run has a law given in Python, mine", said_of_decay(run)
    )
    assert gramian(run).eigenvalues["x1"][0] > 0


def made(name, output, port, size, **inputs):
    return clpt.Block(
        name, output=output, inputs={"x": 2, **inputs}, outputs={port: size}
    )


def turning(t, x, u, p):
    return 0.3 * np.array([-np.sin(u.x[1]), np.sin(u.x[0])])


GYRE = made("gyre", turning, "flow_x", 2, phi_x=3)
PULL = made(
    "own", lambda t, x, u, p: 2.0 * np.tanh(u.zc - u.x), "v_x", 2, zc=2, phi_x=3
)
BASIS = made("b", lambda t, x, u, p: 0.1 * np.array([1, u.x[0], u.x[1]]), "phi_x", 3)
TOLD = {  # what a page and a film's last picture say of a run: its true flow and its learned flow
    "scenario": ({}, "flow_parameter_error, gain_error, learned flow, true arrow"),
    "true_flow": ({"true_flow": GYRE}, "gain_error, learned flow, learned arrow"),
    "controller": (
        {"vehicle_controller": PULL},
        "flow_parameter_error, learned flow, true arrow",
    ),
    "basis_x": ({"basis_x": BASIS}, "flow_parameter_error, gain_error"),
}


@pytest.mark.long
@pytest.mark.parametrize("part", TOLD)
def test_what_stands_in_place_of_a_truth_leaves_no_error_to_tell(
    part, tmp_path, undrawn
):
    replace, wanted = TOLD[part]
    loop = clpt.closed_loop(PAPER, replace=replace)
    run, many = clpt.simulate(loop), tmp_path / "many"
    data = clpt.run_ensemble(loop, {"vehicle.position": [[0.0, 0.0]]}, out=many)
    for one in (run, many):
        clpt.report(one, tmp_path / f"{'run' if one is run else 'many'}.html")
    page, ensemble = (
        (tmp_path / f"{n}.html").read_text("utf-8") for n in ("run", "many")
    )
    told = {"learned flow"} if "the learned flow at the end" in page else set()
    axes = run.clpt.plot("learning")
    for error, below in (("flow_parameter_error", 0), ("gain_error", 1)):
        has = f"largest {error.replace('_', ' ')}" in page
        assert has is (error in data) is (f"{error} mark" in ensemble)
        assert has is ("true" in axes[below].get_title(loc="left"))
        told |= {error} if has else set()
    ax = frame_of(run, run.sizes["time"] - 1)
    texts = [text.get_text() for text in ax.figure.findobj(Text)]
    arrows = set(re.findall(r"^longest (true|learned) arrow ", "\n".join(texts), re.M))
    assert ("true flow" in texts) is ("true" in arrows)
    told |= {f"{kind} arrow" for kind in arrows}
    track = run.clpt.plot("track").collections
    assert any(isinstance(one, Quiver) for one in track) is ("true arrow" in told)
    assert told == set(wanted.split(", "))


def test_delta_comes_from_outside():
    """x' = F + v + delta: in calm water a held delta moves the rest by delta/KD."""
    loop, delta = clpt.closed_loop(CALM, external="delta"), np.array([0.3, -0.2])
    run = clpt.simulate(loop, [0, 0.6], delta, clpt.initial_state(CALM), **TIGHT)
    rest = (GammaD * POINTS[0] + delta) / KD
    exact = rest + (np.array([4.0, -2.0]) - rest) * np.exp(-0.6 * KD)
    np.testing.assert_allclose(run.position[-1], exact, atol=1e-9)
    np.testing.assert_array_equal(run.delta[-1], delta)
    assert run.position.attrs == clpt.simulate(CALM, [0, 0.6]).position.attrs


def test_a_loop_cut_open_is_the_controller_and_the_vehicle():
    """In calm water from v to v_x = GammaD zc - KD x with x' = v: -KD/s."""
    cut = {("v_x", "vehicle"): control.tf(1, 1, name="cut")}
    opened = clpt.closed_loop(CALM, external="v_x_cut", insert=cut)
    assert len(clpt.initial_state(opened)) == opened.nstates == 14
    state = np.append([2.0, -3.0], np.ones(12))
    linear = control.linearize(opened, state, [0.3, 0.4], t=0.2, copy_names=True)
    for i in range(2):
        L = linear[f"v_x[{i}]", f"v_x_cut[{i}]"]
        np.testing.assert_allclose(L(0.7j), -KD[i] / 0.7j, rtol=1e-6)


def test_a_run_goes_on_from_its_state():
    run = clpt.simulate(PAPER, **TIGHT)
    rest = clpt.simulate(
        clpt.closed_loop(PAPER), [20, 30], 0, run.clpt.state(20), **TIGHT
    )
    np.testing.assert_allclose(rest.clpt.state(30), run.clpt.state(30), atol=1e-8)
    np.testing.assert_array_equal(run.clpt.state(0), clpt.initial_state(PAPER))


def test_the_state_is_in_the_order_of_the_diagram():
    run, loop = clpt.simulate(PAPER), clpt.closed_loop(PAPER)
    assert run.state.values.tolist() == loop.state_labels
    np.testing.assert_array_equal(run.clpt.state(7)[:2], run.position.sel(time=7))
    team = clpt.Team(members={"west": PAPER, "east": PAPER}, coupling=0.5)
    both = clpt.simulate(team, [0, 1])
    assert both.state.values.tolist() == clpt.closed_loop(team).state_labels
    said = "nearest of its times is 7. Simulate it with timepts"
    says(ClptError, said, run.clpt.state, 7.5)
    says(DataError, "has no states.", run.drop_vars("states").clpt.state, 7)


@pytest.mark.parametrize(
    ("name", "key", "value"),
    [
        ("adaptation.gain", "learning.gain", 2.0),
        ("true_flow.theta", "flow.parameters", [[0.5, 0.1, 0.2], [0.3, 0.4, 0.1]]),
        ("vehicle_controller.KD", "vehicle.feedback", [2.0, 1.5]),
        ("vehicle_controller.GammaD", "vehicle.feedforward", [0.5, 2.0]),
        ("reference.dwell", "reference.dwell", 7.0),
    ],
)
def test_a_run_is_that_of_the_scenario_that_says_so(name, key, value, tmp_path):
    run = clpt.simulate(PAPER, params={name: value})
    own = clpt.simulate(PAPER.with_values({key: value}))
    assert_allclose(run.drop_attrs()[list(own)], own.drop_attrs(), rtol=1e-6, atol=1e-9)
    # V of the parameters that ran falls
    assert np.all(np.diff(run.lyapunov.values) <= 1e-9)
    clpt.save_run(run, tmp_path / "run.nc")
    with pytest.raises(DataError, match=rf"parameters given at call time.*{name}"):
        clpt.load_scenario(tmp_path / "run.nc")


def test_an_initial_state_tolerances_and_noise_are_the_files(tmp_path):
    noise = {"kind": "noise", "amplitude": [0.1, 0.2], "period": 3.0, "seed": 4}
    noisy = PAPER.with_values({"flow.disturbance": noise, "run.output_step": 2.5})
    state = clpt.initial_state(PAPER) + 0.25
    run = clpt.simulate(noisy, initial_state=state, rtol=1e-11, atol=1e-12)
    np.testing.assert_array_equal(run.states[0], state)
    clpt.save_run(run, tmp_path / "run.nc")
    assert_equal(clpt.load_run(tmp_path / "run.nc"), run)


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        ("adaptation.gain", None, r"adaptation\.gain = None: must be a number"),
        (
            "adaptation.gain",
            [1.0, 2.0],
            r"adaptation\.gain = .*: must be a number, without NaN",
        ),
        (
            "adaptation.gain",
            np.nan,
            r"adaptation\.gain = nan: must be a number, without NaN",
        ),
        ("learning.gain", 1.0, r"its name at call time is adaptation\.gain"),
    ],
)
def test_what_is_no_parameter_is_refused(name, value, sentence):
    says(BlockError, sentence, clpt.simulate, PAPER, params={name: value})


def test_a_gain_of_zero_at_call_time_is_the_scenarios():
    run = clpt.simulate(PAPER, params={"adaptation.gain": 0.0})
    own = clpt.simulate(PAPER.with_values({"learning.gain": 0}))
    np.testing.assert_array_equal(run.alpha, own.alpha)
    np.testing.assert_allclose(run.lyapunov, own.lyapunov, rtol=1e-14)
