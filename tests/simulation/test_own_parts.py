"""Parts of the paper's diagram replaced and inserted; the state at a time of a run."""

import control
import law_blocks
import numpy as np
import pytest
from calm_water import CALM, KD, POINTS, GammaD, exact_positions
from matplotlib.quiver import Quiver
from matplotlib.text import Text
from xarray.testing import assert_allclose, assert_identical

import clpt_control as clpt
from clpt_control.blocks import vehicle
from clpt_control.diagrams.parts import LAW
from clpt_control.errors import ClptError, DataError, DiagramError
from clpt_control.figures import new_figure
from clpt_control.scenario.file import OWN_PARTS
from clpt_control.simulation.film import draw_samples
from clpt_control.theory import prove

PAPER = clpt.paper_scenario().with_values({"run.duration": 30})
LIMITED = PAPER.with_values({"vehicle.max_speed": 1.0})
TIGHT = {"rtol": 1e-11, "atol": 1e-13}
LAG = control.tf(1, [0.5, 1], name="lag")
ENGINES = ("native", "python")


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
    through = control.tf(1, 1, name="through")
    plain = clpt.simulate(PAPER)
    for where in (
        "v_x",
        ("x", "clpe"),
        ("x", "clpe", "basis_x"),
        "phi_x",
        ("K", "learning_controller"),
    ):
        run = clpt.simulate(clpt.closed_loop(PAPER, insert={where: through}))
        assert_allclose(run[list(plain)], plain, rtol=0, atol=1e-7)


def test_parts_of_one_wide_port_in_a_row_and_names_of_ones_own():
    wide = {"inputs": ["v[0]", "v[1]"], "outputs": ["v_f[0]", "v_f[1]"], "name": "motor"}
    motor = control.ss(-np.eye(2), np.eye(2), np.eye(2), 0, **wide)
    loop = clpt.closed_loop(PAPER, insert={("v_x", "vehicle"): motor, "v_f": LAG})
    assert loop.state_labels[-4:] == ["motor_x[0]", "motor_x[1]", "lag_x[0]", "lag_x[1]"]
    assert loop.syslist[6].input_labels[2:] == ["v_f_lag[0]", "v_f_lag[1]"]
    run = clpt.simulate(loop, [0, 1], 0, [clpt.initial_state(PAPER), 0])
    assert {"v_x", "v_f", "v_f_lag"} <= set(run.data_vars)


def test_a_replaced_vehicle_starts_where_the_scenario_says():
    sizes = {"inputs": [f"{port}[{k}]" for port in ("flow_x", "v_x") for k in range(2)]}
    B = np.hstack([np.eye(2)] * 2)
    boat = control.ss(
        0 * np.eye(2), B, np.eye(2), 0, **sizes, outputs=["x[0]", "x[1]"], name="boat"
    )
    scenario = PAPER.with_values({"vehicle.position": [1.0, -2.0]})
    run = clpt.simulate(clpt.closed_loop(scenario, replace={"vehicle": boat}))
    plain = clpt.simulate(scenario)
    np.testing.assert_allclose(run.position, plain.position, rtol=0, atol=1e-7)
    assert "lyapunov" in run
    nested = clpt.connect([vehicle.vehicle()], external=["flow_x", "v_x"], name="hull")
    run = clpt.simulate(clpt.closed_loop(scenario, replace={"vehicle": nested}))
    np.testing.assert_allclose(run.position, plain.position, rtol=0, atol=1e-7)
    assert run.state.values[0] == "hull_vehicle_x[0]"


def test_a_port_of_one_in_and_one_out_takes_the_names_it_replaces():
    limited = PAPER.with_values({"vehicle.max_speed": 1.5})
    saturation = control.nlsys(
        None, lambda t, x, u, params: np.clip(u, -1, 1), inputs=2, outputs=2, name="saturation"
    )
    run = clpt.simulate(clpt.closed_loop(limited, replace={"speed_limit": saturation}))
    assert run.attrs["engine"] == "native"
    assert abs(run.velocity).max() == 1.0
    np.testing.assert_allclose(run.velocity, run.commanded_velocity.clip(-1, 1))


def test_law_is_replace_adaptation():
    law = clpt.paper_blocks(PAPER.with_values({"learning.gain": 2.0}))[-1]
    loops = [clpt.closed_loop(PAPER, **own) for own in ({"law": law}, {"replace": {LAW: law}})]
    assert clpt.simulate(loops[0]).identical(clpt.simulate(loops[1]))
    with pytest.raises(DiagramError, match="one and the same"):
        clpt.closed_loop(PAPER, law=law, replace={LAW: law})


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"replace": {"vehicel": LAG}}, "replace = 'vehicel': must be among reference, basis_x"),
        ({"replace": {"vehicle": LAG}}, "'x', an input of basis_x, is made by no block"),
        ({"insert": {"v_c": LAG}}, "insert = 'v_c': must begin with one of Gamma, K, alpha"),
        ({"insert": {("v_x", "clpe"): LAG}}, "'v_x' goes to vehicle, not to 'clpe'"),
        ({"insert": {"v_x": LAG, "zc": LAG}}, "two blocks are called 'lag'"),
        ({"insert": {"v_x": control.ss(-np.eye(3), np.eye(3), np.eye(3), 0, name="w")}},
         r"'v_x_w' has 3 signals, but vehicle takes 2; both must"),
        ({"insert": {"v_x": clpt.parts.saturation(-1, 1)}}, r"vehicle takes 2; .* signals="),
        ({"insert": {"v_x": control.summing_junction(["a", "b"], "c", name="sum")}},
         r"sum takes a, b; call the one that is meant 'v_x'"),
        ({"insert": {"v_x": control.tf(1, [1, 1])}}, "a TransferFunction without a name"),
        ({"insert": {("v_x", 3): LAG}}, "not to 3"),
        ({"insert": {(): LAG}}, "must begin with one of"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused_in_a_sentence(changes, said):
    with pytest.raises(ClptError, match=said) as caught:
        clpt.closed_loop(PAPER, **changes)
    assert "\n" not in str(caught.value)


def test_a_loop_that_knows_its_scenario_is_its_scenario():
    """Times, start, tolerances and attributes; what was done to the diagram since is in its run."""
    later, loop = PAPER.with_values({"vehicle.position": [1.0, 2.0]}), clpt.closed_loop
    plain, run = clpt.simulate(later), clpt.simulate(loop(later))
    assert_identical(run[list(plain)], plain)
    from_ten = clpt.simulate(loop(later), [10.0, 12.0])
    np.testing.assert_array_equal(from_ten.states, clpt.simulate(later, [10.0, 12.0]).states)
    moved = clpt.initial_state(later) + 0.25  # a scenario's is at t = 0, a diagram's at once
    run = clpt.simulate(loop(later), [10.0, 12.0], initial_state=moved)
    np.testing.assert_array_equal(clpt.state_at(run, 10.0), moved)
    run = clpt.simulate(later, [10.0, 12.0], initial_state=moved)
    np.testing.assert_allclose(
        run.states[0], clpt.simulate(later, [0.0, 10.0], initial_state=moved).states[-1], atol=1e-6
    )
    fast = clpt.simulate(loop(LIMITED))
    assert fast.attrs["message"] == clpt.simulate(LIMITED).attrs["message"]
    for change in (rewired, renumbered):
        changed = change(loop(later))
        run = clpt.simulate(changed)
        assert run.attrs[OWN_PARTS] == "closed_loop: run as a diagram"
        assert not np.allclose(run.predicted_position, plain.predicted_position)
        for use in (lambda own: clpt.run_ensemble(own, "learning.gain=0.2:2.0", 2), prove):
            with pytest.raises(DiagramError, match="closed_loop: was changed after closed_loop"):
                use(changed)
    with pytest.raises(clpt.ScenarioError, match="timepts: is required to run a diagram"):
        clpt.run_ensemble(loop(later, external="zc"), "learning.gain=0.2:2.0", 2)


def rewired(loop):
    loop.set_connect_map(0.5 * loop.connect_map)
    return loop


def renumbered(loop):
    loop.syslist[-1].parameters = loop.syslist[-1].parameters._replace(gain=3.0)
    return loop


def test_the_law_of_a_loop_is_proved():
    law = law_blocks.papers_law()
    assert prove(clpt.closed_loop(PAPER, law=law), points=100).status == "proved"
    assert prove(clpt.closed_loop(PAPER), points=100).status == "proved"
    with pytest.raises(DiagramError, match="has v_x to vehicle: lag, so V' is not its law's alone"):
        prove(clpt.closed_loop(PAPER, insert={("v_x", "vehicle"): LAG}))


def test_no_certificate_for_parts_that_it_is_not_of():
    run = clpt.simulate(
        clpt.closed_loop(PAPER, insert={("v_x", "vehicle"): LAG}), np.linspace(0, 30, 601)
    )
    with pytest.raises(ClptError, match="the run has parts given in Python, v_x to vehicle: lag"):
        clpt.theory.certificate(run, 20.0, 0.0)
    with pytest.raises(ClptError, match=r"parts given in Python, v_x .* its vehicle is not known"):
        clpt.estimation.flow_estimate(run)


def test_what_a_run_taught_is_not_told_of_another_track_nor_of_other_gains():
    """A reference that leaves z_2 at rest teaches nothing of Gamma_2; a slow law is no fast one."""
    times = np.linspace(0, 30, 601)
    still = clpt.Block(
        "reference", output=lambda t, x, u, p: {"zc": [np.cos(t), 0.0]}, outputs={"zc": 2}
    )
    run = clpt.simulate(clpt.closed_loop(PAPER, replace={"reference": still}), times)
    with pytest.raises(ClptError, match="made with a reference that its scenario does not hold"):
        clpt.theory.gramian(run, 20.0, 0.0)
    loop = clpt.closed_loop(PAPER)
    wide = clpt.simulate(loop, times, params={"basis_x.widths": np.full(3, 1e3)})
    with pytest.raises(ClptError, match="made with a basis_x that its scenario does not hold"):
        clpt.theory.gramian(wide, 20.0, 0.0)
    slow = clpt.simulate(loop, times, params={"adaptation.gain": 1e-3})
    assert clpt.theory.gramian(slow, 20.0, 0.0).window == 20.0
    with pytest.raises(ClptError, match=r'the run has parameters {"adaptation.gain": 0.001}'):
        clpt.theory.certificate(slow, 20.0, 0.0)


def a_gyre(U=0.3):
    return clpt.Block(
        "gyre",
        output=lambda t, x, u, p: {"flow_x": p.U * np.array([-np.sin(u.x[1]), np.sin(u.x[0])])},
        inputs={"x": 2, "phi_x": 3},
        outputs={"flow_x": 2},
        parameters={"U": U},
    )


def a_controller():
    return clpt.Block(
        "own",
        output=lambda t, x, u, p: {"v_x": p.k * np.tanh(u.zc - u.x)},
        inputs={"x": 2, "zc": 2, "phi_x": 3},
        outputs={"v_x": 2},
        parameters={"k": 2.0},
    )


OF_NO_TRUTH = {
    "true_flow": (a_gyre(), "flow_parameter_error", 0, "largest flow parameter error"),
    "vehicle_controller": (a_controller(), "gain_error", 1, "largest gain error"),
}


@pytest.mark.parametrize("part", OF_NO_TRUTH)
def test_what_stands_in_place_of_a_truth_leaves_no_error_to_tell(part, tmp_path):
    own, error, below, said = OF_NO_TRUTH[part]
    lines = {}
    for replace in ({}, {part: own}):
        loop = clpt.closed_loop(PAPER, replace=replace)
        run = clpt.simulate(loop)
        axes = clpt.simulation.learning_plot(run)
        lines[len(replace)] = len(axes[below].lines), axes[below].get_title(loc="left")
        clpt.report(run, tmp_path / "run.html")
        page = (tmp_path / "run.html").read_text("utf-8")
        assert (said in page) is not bool(replace)
        folder = tmp_path / f"many{len(replace)}"
        many = clpt.run_ensemble(loop, {"vehicle.position": [[0.0, 0.0]]}, out=folder)
        assert (error in many) is not bool(replace)
        clpt.report(folder, tmp_path / "many.html")
        page = (tmp_path / "many.html").read_text("utf-8")
        assert (f"{error.split('_')[-2]} error" in page) is not bool(replace)
    assert lines[1][0] * 2 == lines[0][0]  # a line that is learned, and that of its truth
    assert ("true" in lines[0][1], "true" in lines[1][1]) == (True, False)


def test_a_flow_that_the_scenario_does_not_hold_is_not_drawn():
    for replace in ({}, {"true_flow": a_gyre()}):
        run = clpt.simulate(clpt.closed_loop(PAPER, replace=replace))
        ax = clpt.simulation.track_plot(run)
        assert bool([one for one in ax.collections if isinstance(one, Quiver)]) is not bool(replace)
        texts = texts_of_the_end(run)
        assert ("true flow" in texts) is not bool(replace)
        kind = "learned" if replace else "true"
        assert [one for one in texts if one.startswith(f"longest {kind} arrow ")]


def texts_of_the_end(run):
    """Return the texts of the end of a run, as a film shows it."""
    _, ax = new_figure()
    next(draw_samples(ax, run, np.array([run.sizes["time"] - 1])))
    return [text.get_text() for text in ax.figure.findobj(Text)]


def test_a_flow_of_functions_that_the_scenario_does_not_hold_is_not_drawn(tmp_path):
    wide = {"output": lambda t, x, u, p: {"phi_x": p.s * np.array([1, u.x[0], u.x[1]])}}
    ports = {"inputs": {"x": 2}, "outputs": {"phi_x": 3}, "parameters": {"s": 0.1}}
    of_own = clpt.simulate(
        clpt.closed_loop(PAPER, replace={"basis_x": clpt.Block("b", **wide, **ports)})
    )
    for run in (of_own, clpt.simulate(PAPER, params={"basis_x.widths": np.ones(3)})):
        assert not any("arrow" in text for text in texts_of_the_end(run))
        clpt.report(run, tmp_path / "run.html")
        page = (tmp_path / "run.html").read_text("utf-8")
        assert "what was learned of it by the end" not in page


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


# --- the state at a time ----------------------------------------------------------------------


def test_a_run_goes_on_from_its_state():
    run = clpt.simulate(PAPER, **TIGHT)
    rest = clpt.simulate(clpt.closed_loop(PAPER), [20, 30], 0, clpt.state_at(run, 20), **TIGHT)
    np.testing.assert_allclose(clpt.state_at(rest, 30), clpt.state_at(run, 30), atol=1e-8)
    np.testing.assert_array_equal(clpt.state_at(run, 0), clpt.initial_state(PAPER))


def test_the_state_is_in_the_order_of_the_diagram():
    run, loop = clpt.simulate(PAPER), clpt.closed_loop(PAPER)
    assert run.state.values.tolist() == loop.state_labels
    np.testing.assert_array_equal(clpt.state_at(run, 7)[:2], run.position.sel(time=7))
    team = clpt.Team(members={"west": PAPER, "east": PAPER}, coupling=0.5)
    both = clpt.simulate(team, [0, 1])
    assert both.state.values.tolist() == clpt.team_loop(team).state_labels
    assert clpt.state_at(both, 1).shape == (28,)


@pytest.mark.parametrize(
    ("t", "said"),
    [
        (7.5, "nearest of its times is 7; simulate it with timepts"),
        (31, "nearest of its times is 30"),
        (np.nan, "t = nan"),
        ([1, 2], "a number"),
        ("noon", "a number"),
    ],
)
def test_a_time_without_a_sample_is_refused(t, said):
    run = clpt.simulate(PAPER)
    with pytest.raises(ClptError, match=said):
        clpt.state_at(run, t)
    with pytest.raises(DataError, match="carries no states"):
        clpt.state_at(run.drop_vars("states"), 7)
