"""Studies against closed forms: margins, the worst disturbance, mean squares, headlines."""

import re
from dataclasses import replace

import control
import numpy as np
import pytest
from error_sentences import says
from geodesics import place_from
from image_checks import inked
from paths import DATA
from responses import response

import clpt_control as clpt
from analysis import against_adcp, laws, mean_square, shelf
from analysis import worst_disturbance as worst
from analysis.against_adcp import compared, read_adcp
from analysis.headlines import headline, main, record
from analysis.margins import KINDS, closed_form, margin
from analysis.mean_square import mean_square_bound, mean_square_sides
from analysis.worst_disturbance import (
    error_matrices,
    influences,
    peak_gains,
    regressor_matrices,
    worst_disturbance,
)
from clpt_control.ocean.gliders.usable_dives import usable
from clpt_control.theory.theorems.counterexamples import (
    exact_run,
    scalar_matrix,
    with_square_wave,
)
from examples import auv, mrac, pendulum, tank


def test_peak_gain_in_closed_form():
    """One lag: (1 - e^{-kt})/k; adaptation at 10 rad/s: near 4/pi."""
    lag = np.full((1000, 1, 1), -2.0)
    assert peak_gains(lag, 0.001, [1000]) == pytest.approx(
        (1 - np.exp(-2)) / 2, rel=1e-5
    )
    ringing = np.broadcast_to(scalar_matrix(1.0, gain=100.0), (2000, 2, 2))
    assert peak_gains(ringing, 0.01, [2000]) == pytest.approx(4 / np.pi, rel=3e-3)


@pytest.mark.long
def test_the_worst_disturbance_is_attained_by_the_closed_loop():
    """Bang-bang Delta = Dmax sign(c Phi b) in the wired diagram; (33) claims 1."""
    paper, step, end, size = clpt.paper_scenario(), 0.04, 161.0, 0.001
    A = regressor_matrices(paper, end, step)[0]
    influence = influences(A, step, [len(A)])[:, 0]
    predicted = peak_gains(A, step, [len(A)])[0]
    scenario = with_square_wave(paper, size, 3.5).with_values({"run.duration": end})
    loop, times = (
        clpt.closed_loop(scenario, external="delta"),
        np.linspace(0, end, len(influence)),
    )
    given = {"rtol": 1e-6, "atol": 1e-9, "initial_state": clpt.initial_state(scenario)}
    run = response(loop, times, inputs=[size * np.sign(influence), 0.0], **given)
    reached = abs(run.states[0, -1] - run.states[2, -1]) / size
    assert reached == pytest.approx(predicted, rel=0.01)
    assert reached > 2.5


@pytest.mark.slow
def test_the_worst_disturbance_of_the_second_and_later_cycles():
    found = worst_disturbance(clpt.paper_scenario(), 400.0, 800.0)
    assert found.peaks == pytest.approx((5.234, 4.744), rel=1e-3)


def test_mean_square_bound_along_the_papers_runs():
    paper = clpt.paper_scenario().with_values(
        {"run.duration": 200, "run.output_step": 0.02}
    )
    noise = {"kind": "noise", "amplitude": [0.1, 0.2], "period": 0.5, "seed": 3}
    disturbed = paper.with_values({"flow.disturbance": noise})
    for scenario in (paper, disturbed, with_square_wave(paper, 0.05, 3.5)):
        found = mean_square_bound(clpt.simulate(scenario), scenario)
        assert found.holds
        assert 0.01 < found.tightness < 1


def random_runs(rng, count):
    """Random regressors and disturbances; half of these push where e already is."""
    k, gain = 10 ** rng.uniform(-1, 1, 2)
    scale = rng.choice([0.1, 1.0, 5.0], count)[:, None]
    start = state = rng.normal(size=(count, 4)) * rng.choice([0.0, 1.0], count)[:, None]
    pushing = rng.random(count) < 0.5
    end, times, states, drives = 0.0, [], [], []
    for _ in range(12):
        phi, z, zc = (rng.normal(size=(count, n)) * scale for n in (1, 2, 2))
        drive = np.zeros((count, 4))
        push = np.where(state[:, 0] < 0, -1.0, 1.0) * 2 * k
        drive[:, 0] = np.where(pushing, push, rng.normal(size=count))
        A = error_matrices(phi, z, zc, [k, k], gain)[0]
        duration = rng.uniform(0.1, 2)
        each = zip(A, drive, state, strict=True)
        runs = [exact_run([(duration, *one, 100)], own) for *one, own in each]
        piece_times, reached = runs[0][0], np.stack([run for _, run in runs], axis=1)
        times.append(end + piece_times)
        states.append(reached)
        drives.append(np.broadcast_to(drive, reached.shape))
        end, state = times[-1][-1], reached[-1]
    V0 = (start[:, 0] ** 2 + np.sum(start[:, 1:] ** 2, axis=1) / gain) / 2
    e, delta = (np.concatenate(values)[..., :1] for values in (states, drives))
    return np.concatenate(times), e, delta, V0, k


@pytest.mark.long
def test_the_mean_square_bound_holds_for_random_disturbances():
    rng = np.random.default_rng(11)
    violated, tightest = [], []
    for _ in range(3):
        times, e, delta, V0, k = random_runs(rng, 50)
        found = mean_square_sides(times, e, delta, V0, k)
        assert found.holds
        tightest.append(found.tightness)
        largest = np.abs(delta[..., 0]).max(0) / k
        violated += [*(np.abs(e[len(times) // 2 :, :, 0]).max(0) > largest)]
    assert len(violated) == 150
    assert 0.3 < max(tightest) < 1
    assert sum(violated) > 15, "the same runs violate Eq. (33)"


def test_the_mean_square_bound_is_tight():
    """Slow adaptation, Delta held: int e^2 comes as near as one likes; twice is too much."""
    A = scalar_matrix(1.0, gain=1e-9)
    times, states = exact_run([(200.0, A, np.array([1.0, 0.0]), 4000)], np.zeros(2))
    delta = np.ones((len(times), 1))
    assert 0.98 < mean_square_sides(times, states[:, :1], delta, 0.0, 1.0).tightness < 1
    assert not mean_square_sides(times, 1.1 * states[:, :1], delta, 0.0, 1.0).holds


def test_learned_speed_and_current_are_those_of_the_adcp(facts):
    dives, skipped = clpt.gliders.read_dives(facts / "glider" / "sg171_dives.csv")
    found = compared(dives, read_adcp(facts / "glider" / "sg171_adcp.csv"))
    assert (len(dives), skipped) == (10, [])
    assert 1.3 < found.measured < 1.6
    assert abs(found.learned - found.measured) < found.standard_error < 0.15
    assert found.learned == pytest.approx(1.48, abs=0.11)
    assert found.current < 0.012 < 0.03 < found.in_file


# --- margins -------------------------------------------------------------------------------------


FIRST, *MORE = KINDS


@pytest.mark.long
@pytest.mark.parametrize(
    "kind", [FIRST, *(pytest.param(k, marks=pytest.mark.slow) for k in MORE)]
)
def test_where_w_is_held_the_margin_is_the_closed_form(kind):
    """A steady flow and one waypoint, where the vehicle stands; 3 % are the bisection's."""
    still = {"basis.periods": [float("inf")] * 3, "basis.kernel": "gaussian"}
    still |= {"reference": {"kind": "waypoints", "points": [[3, 2]], "dwell": 20}}
    still |= {"run.duration": 200, "run.output_step": 0.25}
    scenario = clpt.paper_scenario().with_values(still)
    end = clpt.simulate(scenario).position.values[-1]
    scenario = scenario.with_values({"vehicle.position": end})
    along = clpt.gramian(scenario.started_true(), 20.0, 20.0)
    g = 0.8 * np.max(np.sum(along.w**2, axis=-1))
    assert margin(scenario, kind) == pytest.approx(closed_form(kind, 1.0, g), rel=0.055)


@pytest.mark.parametrize(("k", "g"), [(1.0, 5.0), (0.4, 2.0), (2.0, 30.0)])
def test_the_closed_forms_are_where_a_pole_crosses(k, g):
    """The poles of the linear loops, a hair below and above."""
    plant = control.tf([g], [1, k, 0])
    for share, stable in ((0.98, True), (1.02, False)):
        tau, late, step = (
            share * closed_form(one, k, g) for one in ("lag", "delay", "sampler")
        )
        for behind in (control.tf([1], [tau, 1]), control.tf(*control.pade(late, 6))):
            assert (control.feedback(plant * behind).poles().real.max() < 0) == stable
        a = np.exp(-k * step)
        held = np.array([[a, (1 - a) / k], [-g * step, 1.0]])
        assert (np.abs(np.linalg.eigvals(held)).max() < 1) == stable
    assert closed_form("lag", 2.0, 3.0) == np.inf


def rohrs(w, unmodelled):
    """Rohrs' loop: y_p = 2/(s+1) 229/(s^2+30s+229) u, model 3/(s+3), both gains adapted by 1."""

    reference = control.nlsys(
        None,
        lambda t, x, u, p: [0.3 + 1.85 * np.sin(w * t)],
        inputs=0,
        outputs=["r"],
        name="ref",
    )
    lag = control.tf([229], [1, 30, 229]) if unmodelled else 1
    plant = control.ss(
        control.tf([2], [1, 1]) * lag, inputs=["u"], outputs=["y"], name="plant"
    )
    model = control.ss(
        control.tf([3], [1, 3]), inputs=["r"], outputs=["ym"], name="model"
    )
    adaptation = control.nlsys(
        lambda t, x, u, p: [-(u[1] - u[2]) * u[0], -(u[1] - u[2]) * u[1]],
        lambda t, x, u, p: [x[0] * u[0] + x[1] * u[1], x[0], x[1]], states=2, name="law",
        inputs=["r", "y", "ym"], outputs=["u", "kr", "ky"],
    )  # fmt: skip
    parts = [reference, plant, model, adaptation]
    loop = control.interconnect(parts, outputs=["y", "ym", "kr", "ky"], inputs=[])
    start = np.zeros(loop.nstates)
    start[["law" in name for name in loop.state_labels]] = [1.14, -0.65]
    return clpt.simulate(loop, np.linspace(0, 40, 801), initial_state=start)


def test_rohrs_example_loses_stability_by_the_lag_alone():
    """At the frequency where the unmodelled phase is 180 degrees ky drifts until all is lost."""
    assert np.all(np.abs(rohrs(16.1, False).y.values) < 3)
    says(
        clpt.SimulationError, r"the integration stopped at t = 2\d\.", rohrs, 16.1, True
    )


# --- the judge of a replay's headline ------------------------------------------------------------

DIVES = clpt.gliders.sample_dives()


def test_a_fix_on_the_ellipse_is_one_half_axis_away():
    replay = clpt.replay.replay_dives(DIVES[:6])
    said = replay.next_dive().as_dict()
    turn = np.radians(said["ellipse_bearing"])
    along, across = np.array(
        [[np.sin(turn), np.cos(turn)], [-np.cos(turn), np.sin(turn)]]
    )
    for way in (said["ellipse_long"] * along, said["ellipse_short"] * across):
        lat, lon = place_from(said["latitude"], said["longitude"], *way)
        found = headline(replay, replace(DIVES[6], lat_gpse=lat, lon_gpse=lon))
        assert found.away == pytest.approx(1.0, rel=1e-3)
        assert found.miss == pytest.approx(np.hypot(*way), rel=1e-6)
    assert found.size**2 == pytest.approx(said["ellipse_long"] * said["ellipse_short"])


def test_a_pair_with_dives_missing_between_is_left_out():
    whole = record(DIVES[:6])
    holed = record(usable([*DIVES[:3], *DIVES[4:6]])[0])
    assert (len(whole), len(holed)) == (5, 3)
    assert holed[:2] == pytest.approx(whole[:2], nan_ok=True)


def test_the_table_has_a_row_for_each_vehicle(tmp_path, capsys):
    main(out=tmp_path)
    lines = (tmp_path / "headlines.md").read_text().splitlines()
    assert capsys.readouterr().out.splitlines() == lines
    assert [line.split(" | ")[:2] for line in lines[2:]] == [["| SG542", "13"]]
    assert inked(tmp_path / "headlines.png") > 0.005


# --- examples ------------------------------------------------------------------------------------

NUMBER = re.compile(r"-?\d[\d.]*(e[-+]\d+)?")


def rows(said):
    """The rows of a table, by their first cell, without its head."""
    lines = [line for line in said.splitlines() if line.startswith("| ")]
    cells = [
        [cell.strip(" `") for cell in line.strip("|").split("|")] for line in lines
    ]
    return {
        row[0]: [float(c) if NUMBER.fullmatch(c) else c for c in row[1:]]
        for row in cells[1:]
    }


@pytest.fixture
def run(tmp_path, capsys):
    """Run an example, which draws a figure; give what it prints and the table in it."""

    def made(example):
        example.main(tmp_path / "figure.png")
        assert inked(tmp_path / "figure.png") > 0.005
        said = capsys.readouterr().out
        return said, rows(said)

    return made


@pytest.mark.long
def test_mrac_is_proved_and_learns(run):
    said, table = run(mrac)
    assert "V' = -2*e**2: proved" in said
    assert table["5"][1] < 0.2 * table["0.2"][1]
    assert table["5"][2] == pytest.approx(4, abs=0.4)


@pytest.mark.long
def test_the_pendulum_is_caught_from_near_angles_alone(run):
    caught, after, *_ = zip(*run(pendulum)[1].values(), strict=True)
    assert caught == ("yes", "yes", "yes", "no")
    assert max(after) <= 20


@pytest.mark.long
def test_the_tank_does_not_overflow_with_anti_windup(run):
    table = run(tank)[1]
    with_it, without = table["with anti-windup"], table["without"]
    assert with_it[0] < 0.01 < 0.1 < without[0]
    assert with_it[2] < min(without[2], table["gains of a shorter pipe"][2])


def test_a_late_thruster_overshoots(run):
    table = run(auv)[1]
    over = [row[0] for row in table.values()]
    assert over == sorted(over)
    assert table["0.1"][2] == pytest.approx(0.8, abs=1e-3)


def test_the_shelf_has_a_panel_for_each_part():
    assert sorted(one.__name__ for one in shelf.PANELS) == sorted(clpt.parts.__all__)


@pytest.mark.slow
def test_panels_of_the_shelf_are_near_closed_forms(tmp_path):
    shelf.main(tmp_path)
    table = rows((tmp_path / "parts.md").read_text("utf-8"))
    assert len(table) == len(shelf.PANELS)
    off = [row[1] for row in table.values() if row[1] != ""]
    assert len(off) >= 12
    assert max(off) < 1e-8
    assert inked(tmp_path / "parts.png") > 0.01


@pytest.mark.long
def test_each_study_leaves_a_table_and_a_figure(tmp_path):
    mean_square.main(tmp_path)
    worst.main(tmp_path, end=30.0)
    glider = DATA / "glider"
    against_adcp.main([glider / "sg171_dives.csv"], glider / "sg171_adcp.csv", tmp_path)
    for name in ("mean_square", "worst_disturbance", "against_adcp"):
        table = (tmp_path / f"{name}.md").read_text("utf-8")
        assert re.fullmatch(r"\| .*\n.*\n(\| .*\n?){2,}", table)
        assert inked(tmp_path / f"{name}.png") > 0.005
    assert "False" not in (tmp_path / "mean_square.md").read_text("utf-8")


@pytest.mark.long
def test_which_law_when_compares_fast_laws_with_the_papers():
    paper, clear = clpt.paper_scenario(), laws.PAPER["as assumed"]
    both = [
        {**laws.candidates(paper)[name], **clear}
        for name in (laws.PRINTED, "composite-memory")
    ]
    printed, memory = (laws.on_papers_scenario(paper, values, 4) for values in both)
    assert np.all(printed.error[1:] > 0.05)
    assert memory.error[2] < 0.01 * printed.error[1]
    assert memory.clpe[2] < 0.01 * printed.clpe[1]
