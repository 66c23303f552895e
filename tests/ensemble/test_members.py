"""Members of an ensemble: each is its own run, whatever runs beside it, however fast it may go."""

import numpy as np
import pytest
from law_blocks import HELD
from small_scenarios import FIXES

import clpt_control as clpt
from clpt_control.engine.solver.batch import Batch
from clpt_control.engine.solver.solver_layout import Status
from clpt_control.ensemble.ensemble_statistics import ensemble_summary
from clpt_control.ensemble.members import Ensemble
from clpt_control.ensemble.results import STATUS
from clpt_control.ensemble.varied_scenario import VariedScenario
from clpt_control.simulation.summary import run_and_report


def members_of(count):
    random = np.random.default_rng(5)
    return {
        "learning.gain": random.uniform(0.2, 2.0, count),
        "flow.parameters": random.normal(0.5, 0.2, (count, 2, 3)),
        "reference.dwell": random.choice([7.0, 13.0, 21.0], count),
        "basis.periods": random.uniform(5.0, 30.0, (count, 3)),
        "learning.parameters": random.normal(0, 0.1, (count, 2, 3)),
    }


def ensemble_of(values, lanes, duration=60, **changes):
    scenario = PAPER.with_values({"run.duration": duration, **changes})
    ensemble = Ensemble(VariedScenario(scenario), values)
    ensemble.lanes = ensemble.lanes if lanes else 1
    return ensemble


TIMES = np.array([0.0, 3.3, 3.4, 17.0, 42.0, 60.0])
PAPER = clpt.paper_scenario()


COMPOSITE = (
    "composite-least-squares",
    "composite-memory",
    "least-squares",
    "normalised-gradient",
)
NOISE = {"noise": 0.05, "noise_period": 0.5, "seed": 3}
WINDOW = {"learning.law": "concurrent", "learning.concurrent": {"window": 1.0}}
VARIED = {  # what is not as in the paper's scenario, and what differs from member to member
    "waypoints": ({}, members_of(5)),
    "noise": (
        {"localization": NOISE},
        {
            "noise": np.linspace(0.0, 0.1, 9),
            "noise_period": np.tile([0.5, 0.7, 1.1], 3),
        },
    ),
    "fixes": (
        {"learning.law": "fix-regression", **FIXES, "localization.noise": 0.01},
        {
            "interval": np.tile([5.0, 7.0, 20.0], 3),
            "latency": np.repeat([0.0, 1.0, 4.5], 3),
            "noise": np.linspace(0.0, 0.05, 9),
            "dropouts": np.linspace(0.0, 0.5, 9),
        },
    ),
    "windows": (WINDOW, {"learning.concurrent.window": np.array([0.5, 1.0, 3.0])}),
    **{  # whose filters begin where the vehicle does
        law: ({"learning.law": law, **HELD}, {"vehicle.position": np.diag([2.0, -1.0])})
        for law in COMPOSITE
    },
}


@pytest.mark.parametrize("lanes", [False, True])
@pytest.mark.parametrize("case", VARIED)
def test_members_equal_single_runs(case, lanes):
    changes, values = VARIED[case]
    values = {
        k if "." in k else f"localization.{k}": each for k, each in values.items()
    }
    ensemble = ensemble_of(values, lanes, **changes)
    if case == "waypoints":
        assert sorted(ensemble.one_by_one) == ["basis.periods", "reference.dwell"]
    found = ensemble.run(ensemble.members(values), TIMES)
    assert (found.status == 1).all()
    # code of its own: the compiler may join a product and a sum elsewhere
    tolerance = 1e-10
    for m in range(len(found.status)):
        own = ensemble.varied.scenario.with_values(
            {key: value[m] for key, value in values.items()}
        )
        run = clpt.simulate(own, TIMES)
        alpha = found.states[m][:, ensemble.varied.columns["alpha"]].reshape(-1, 2, 3)
        np.testing.assert_allclose(
            found.states[m, :, :2], run.position, rtol=0, atol=tolerance
        )
        np.testing.assert_allclose(alpha, run.alpha, rtol=0, atol=tolerance)
        assert found.counts[m, 0] == run.attrs["solver_steps"]


@pytest.mark.long
@pytest.mark.parametrize("lanes", [False, True])
def test_a_member_has_the_same_bits_in_any_company(lanes):
    values = members_of(21)
    ensemble = ensemble_of(values, lanes)
    whole = ensemble.run(ensemble.members(values), TIMES)
    order = np.random.default_rng(1).permutation(21)
    for part in (order, slice(0, 1), slice(3, 12), slice(20, 21)):
        own = ensemble.members({key: value[part] for key, value in values.items()})
        np.testing.assert_array_equal(
            ensemble.run(own, TIMES).states, whole.states[part]
        )


@pytest.mark.parametrize("lanes", [False, True])
def test_a_stiff_member_does_not_hold_up_the_rest(lanes):
    values = {"learning.gain": np.array([0.01, 1e9, 0.01])}
    ensemble = ensemble_of(values, lanes, 5)
    members = ensemble.members(values)
    rows = members.x0, members.P, np.array([0.0, 5.0]), members.schedules, members.group
    runs = Batch(ensemble.native.callee(ensemble.lanes), *rows)
    runs.finish(ensemble.options, most=40)
    assert list(runs.status) == [
        Status.FINISHED,
        Status.TOO_MANY_STEPS,
        Status.FINISHED,
    ]
    assert runs.counts[1, [0, 3]].sum() == 40
    assert np.isnan(runs.out[1, -1]).all()


SHARE = "share_in_faster_flow (1)"


@pytest.mark.long
def test_a_flow_faster_than_a_member_is_told(tmp_path, printed):
    scenario = PAPER.with_values({"vehicle.max_speed": 1.5, "run.duration": 200})
    data = clpt.run_ensemble(scenario, "vehicle.max_speed=[0.9, 1.5, 9.0]", 3)
    for m, speed in enumerate(data["vehicle.max_speed"].values):
        alone = scenario.with_values({"vehicle.max_speed": float(speed)})
        faster = run_and_report(alone).summary["speed"]["faster_flow"] or {"share": 0.0}
        assert float(data.share_in_faster_flow[m]) == pytest.approx(
            faster["share"], abs=2e-4
        )
    low, *_, high = ensemble_summary(data)["summaries"][SHARE]
    shares = np.sort(data.share_in_faster_flow)  # none, some, most of the time
    np.testing.assert_allclose([low, high], [0.1 * shares[1], shares @ [0, 0.1, 0.9]])
    clpt.save_scenario(
        scenario.with_values({"run.duration": 100}), tmp_path / "slow.toml"
    )
    given = (
        "ensemble",
        tmp_path / "slow.toml",
        "--members",
        2,
        "--out",
        tmp_path / "e.zarr",
    )
    report = printed(*given, "--vary", "vehicle.max_speed=[1.0, 9.0]")
    assert report["summaries"][SHARE][0] < 0.1 < report["summaries"][SHARE][-1]
    free = clpt.run_ensemble(
        PAPER.with_values({"run.duration": 20}), "learning.gain=1:2", 2
    )
    assert SHARE not in ensemble_summary(free)["summaries"]


def test_every_way_in_which_a_member_ends_has_a_name():
    assert [Status(k).label for k in range(len(STATUS))] == [*STATUS]
    vary = "vehicle.position=[[0, 0], [1e200, 0], [0, 0]]"
    data = clpt.run_ensemble(PAPER.with_values({"run.duration": 20}), vary, 3, "grid")
    assert (
        len(data.status.flag_values)
        == len(data.status.flag_meanings.split())
        == len(STATUS)
    )
    assert np.isfinite(data.clpe_rms_whole).values.tolist() == [True, False, True]
    assert float(data.end[1]) < 20 == float(data.end[0])
    assert data.gain_error[0].values.tobytes() == data.gain_error[2].values.tobytes()
    data.status[1] = Status.CHATTERING
    summary = ensemble_summary(data)
    wanted = {"ended": {"finished": 2, "chatters": 1}, "first_failed": 1}
    assert summary | wanted == summary


@pytest.mark.long
def test_kernels_vary_as_numbers_do(tmp_path):
    kernels = ["gaussian", "exponential", "gaussian"]
    scenario = PAPER.with_values({"run.duration": 60})
    vary = {"basis.kernel": kernels[:2], "learning.gain": [0.5, 1.0, 1.5]}
    runs = {"chunk": 2, "out": tmp_path / "kernels.zarr"}
    for data in (
        clpt.run_ensemble(scenario, vary),
        clpt.run_ensemble(scenario, vary, **runs),
        clpt.run_ensemble(scenario, vary, **runs),  # read again
    ):
        grid = data.unstack()["flow_parameter_error"].isel(mark=-1)
        for kernel in vary["basis.kernel"]:
            for gain in vary["learning.gain"]:
                values = {"basis.kernel": kernel, "learning.gain": gain}
                run = clpt.simulate(scenario.with_values(values))
                estimate = run["flow_parameters_estimate"].isel(time=-1)
                error = np.abs(estimate - scenario.flow.parameters).max()
                assert np.isclose(grid.sel(values), error, rtol=1e-9)
    drawn = clpt.run_ensemble(
        scenario, {"basis.kernel": kernels, "learning.gain": "1:2"}, 9
    )
    assert sorted(drawn["basis.kernel"].values) == sorted(kernels * 3)
    assert np.all(drawn["status"] == 1)
    page = tmp_path / "kernels.html"
    clpt.report(drawn, page)
    assert "basis.kernel" in page.read_text()
