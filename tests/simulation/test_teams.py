"""Teams against closed forms and identities: one flow, learned over a graph."""

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson
from scipy.linalg import expm
from team_scenarios import DIFFERENT, FILE, PAPER, ROW, team, vehicle

import clpt_control as clpt

VARIABLES = (
    "position",
    "predicted_position",
    "alpha",
    "feedback_gain",
    "feedforward_gain",
)


def same(run, other):
    for name in VARIABLES:
        found, wanted = run[name].values, other[name].values
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-8, err_msg=name)


def test_identical_vehicles_are_as_one():
    one = vehicle(learning_position=[0.4, -0.2])
    run, alone = clpt.simulate(team(a=one, b=one, c=one)), clpt.simulate(one)
    for name in "abc":
        same(run.sel(vehicle=name), alone)
    assert float(abs(run.alpha - run.alpha[0]).max()) == 0.0
    np.testing.assert_allclose(run.lyapunov, 3 * alone.lyapunov, rtol=1e-7)


def test_without_coupling_each_is_alone(reported):
    """And has the CLPE that it has alone, however few samples are recorded."""
    run = clpt.simulate(team(0.0, ROW, **DIFFERENT))
    seldom = {
        name: one.with_values({"run.output_step": 4}) for name, one in DIFFERENT.items()
    }
    found, short = reported(team(0.0, ROW, **seldom))
    assert short.sizes["time"] == 4
    for name, scenario in DIFFERENT.items():
        same(run.sel(vehicle=name), clpt.simulate(scenario))
        alone, _ = reported(seldom[name])
        for key in ("clpe_rms", "clpe_rms_last_quarter"):
            assert found[key][name] == pytest.approx(alone[key], rel=2e-3)


GAINS = {  # the values of a vehicle, and gamma
    "one": ({}, 0.8),
    "each": (
        {
            "gain": None,
            "gains": {"parameters": 1.3, "feedback": 0.2, "feedforward": 0.5},
        },
        1.3,
    ),
    "held true": ({"adapt_gains": False}, 0.8),
}


@pytest.mark.parametrize("gains", GAINS)
def test_V_falls_by_what_is_claimed(gains):
    """V(s) - V(t) is the integral of sum e^T KD e + kappa/gamma sum over edges |apart|^2."""
    (values, gamma), kappa, members = GAINS[gains], 0.6, {}
    for name, one in DIFFERENT.items():
        true = {
            "feedback": one.vehicle.feedback,
            "feedforward": one.vehicle.feedforward,
        }
        own = values | true if gains == "held true" else values
        tight = {"run.rtol": 1e-12, "run.atol": 1e-13}
        members[name] = one.with_values(
            tight | {f"learning.{k}": v for k, v in own.items()}
        )
    times = np.linspace(0.0, 12.0, 2401)  # each jump is a sample of even number
    run, falls = clpt.simulate(team(kappa, ROW, **members), times), np.zeros(len(times))
    for name, one in members.items():
        falls += run.clpe.sel(vehicle=name).values ** 2 @ np.array(one.vehicle.feedback)
    for a, b in ROW:
        apart = run.alpha.sel(vehicle=a).values - run.alpha.sel(vehicle=b).values
        falls += kappa / gamma * (apart**2).sum((1, 2))
    fallen = cumulative_simpson(falls, x=times, initial=0.0)
    V = run.lyapunov.values
    np.testing.assert_allclose(V[0] - V[::2], fallen[::2], rtol=0, atol=1e-9 * V[0])
    assert np.ptp(V) > 0.1 * V[0]


@pytest.mark.parametrize(
    ("edges", "connectivity"), [("ab bc", 1.0), ("ab bc ca", 3.0), ("ab ac ad", 1.0)]
)
def test_where_nothing_is_seen_the_disagreement_falls_by_the_laplacian(
    edges, connectivity
):
    """phi = 0 and e = 0: alpha(t) = exp(-kappa L t) alpha(0), on a row, a circle and a star."""
    edges = [tuple(edge) for edge in edges.split()]
    names = sorted({name for edge in edges for name in edge})
    starts, kappa = np.random.default_rng(3).standard_normal((len(names), 2, 3)), 0.35
    far = {
        "basis_kernel": "gaussian",
        "basis_centers": [[1e3, 0.0]] * 3,
        "run_rtol": 1e-11,
    }
    far |= {"learning_feedback": [1, 1], "learning_feedforward": [1, 1]}
    far["learning_adapt_gains"] = False
    pairs = zip(names, starts, strict=True)
    of = team(
        kappa,
        edges,
        **{n: vehicle(**far, learning_parameters=start) for n, start in pairs},
    )
    assert of.connectivity == pytest.approx(connectivity)
    run, L = clpt.simulate(of), np.zeros((len(names),) * 2)
    assert float(abs(run.clpe).max()) == 0.0
    for edge in edges:
        a, b = np.eye(len(names))[[*map(names.index, edge)]]
        L += np.outer(a - b, a - b)
    for t in (0.0, 2.5, 12.0):
        exact = np.einsum("vw,wik->vik", expm(-kappa * L * t), starts)
        np.testing.assert_allclose(
            run.alpha.sel(time=t).values, exact, rtol=0, atol=1e-9
        )
    mean = run.alpha.mean("vehicle")
    assert float(abs(mean - mean[0]).max()) < 1e-9
    apart = np.sqrt(((run.alpha - mean) ** 2).sum(("vehicle", "axis", "basis")).values)
    bound = apart[0] * np.exp(-kappa * connectivity * run.time.values)
    assert np.all(apart <= bound * (1 + 1e-7) + 1e-9)


def test_none_sees_the_whole_flow_yet_the_team_learns_it():
    """Issue: each smallest eigenvalue below 1e-6, all parameters to 1e-3 together."""
    of = clpt.load_scenario(FILE)
    theta, end = np.array(of.first.flow.parameters), of.run.duration
    run = clpt.simulate(of, [0.0, end])
    assert float(abs(run.flow_parameters_estimate[:, -1] - theta).max()) < 1e-3
    for scenario in of.members.values():
        joint = clpt.gramian(scenario, end, 0.0).eigenvalues
        assert max(float(values[0]) for values in joint.values()) < 1e-6
        alone = clpt.simulate(scenario, [0.0, end]).flow_parameters_estimate[-1]
        assert float(abs(alone - theta).max()) > 0.5
    together = clpt.gramian(of, end, 0.0)
    assert max(together.vehicles[name].smallest for name in ("west", "east")) < 1e-6
    assert (together.smallest > 1.0, together.not_learnable) == (True, [])


def test_a_team_is_a_diagram_of_python_control():
    of = team(0.6, ROW, **DIFFERENT)
    loop, run = clpt.closed_loop(of), clpt.simulate(of, [0.0, 1.0])
    assert loop.nstates == 3 * 14
    assert "b/alpha[0]" in loop.output_labels
    start = np.concatenate([clpt.initial_state(one) for one in DIFFERENT.values()])
    ran = clpt.simulate(loop, [0.0, 1.0], 0, start)
    np.testing.assert_allclose(ran["c/x"][-1], run.position[2, -1], rtol=0, atol=1e-7)
    steered = clpt.simulate(
        loop, [0.0, 1.0], 0, start, params={"b/consensus.coupling": 0.0}
    )
    assert abs(steered.states[-1] - ran.states[-1]).max() > 1e-4


def test_one_vehicle_may_have_a_limit_of_speed():
    """What the other has no limit of is flown as commanded; no gap is filled with NaN."""
    of = team(slow=vehicle(vehicle_max_speed=0.5), free=PAPER)
    run = clpt.simulate(of)
    assert (
        "; slow: the flow was faster than the vehicle (0.5 m/s)" in run.attrs["message"]
    )
    assert "free:" not in run.attrs["message"]
    speed = np.hypot(*np.moveaxis(run.velocity.values, -1, 0))
    assert speed[0].max() <= 0.5 + 1e-12 < speed[1].max()
    np.testing.assert_array_equal(run.velocity[1], run.commanded_velocity[1])
    assert all(np.isfinite(run[name]).all() for name in run.data_vars)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"initial_state": [1.0]}, "initial_state, params: a team has its own"),
        (
            {"params": {"a/adaptation.gain": 1.0}},
            r"params: a team has its own.*closed_loop\(team\)",
        ),
    ],
)
def test_what_a_team_cannot_take(arguments, said):
    with pytest.raises(clpt.ClptError, match=rf"\A.*{said}.*\Z"):
        clpt.simulate(team(a=PAPER, b=PAPER), **arguments)


@pytest.mark.parametrize(
    "names", [[np.zeros(0), np.ones(3)], ["a", "c"], [1.0, 2.0]], ids=str
)
def test_the_names_of_vehicles_may_be_anything_in_a_file(names):
    run = clpt.simulate(team(a=vehicle(), b=vehicle()))
    others = np.empty(2, dtype=object)
    others[:] = names
    with pytest.raises(clpt.DataError, match="the run's vehicles are not a, b"):
        clpt.report(run.assign_coords(vehicle=others), "never.html")


def test_the_run_of_one_vehicle_is_a_run_of_its_scenario(tmp_path):
    """Its map, figure and file are those of a single vehicle, with the same numbers."""
    of = {"run_duration": 20.0}
    system = team(0.5, west=vehicle(**of), east=vehicle(reference_radius=2.0, **of))
    run = clpt.simulate(system)
    west = run.sel(vehicle="west")
    assert west.clpt.scenario == system.members["west"]
    for part in (west, run.sel(vehicle=["east", "west"])):
        with pytest.raises(clpt.DataError, match="holds a team's whole run"):
            clpt.save_run(part, tmp_path / "west.nc")
    flow = clpt.flow_map(west)
    assert flow.u.shape == (1, 41, 41)
    west.clpt.plot()
    with pytest.raises(clpt.DataError, match=r"run.sel\(vehicle='west'\)"):
        clpt.flow_map(run)
