"""Excitation: the paper's numbers, named parameters, recorded runs, closed forms, teams."""

import json
from functools import reduce

import numpy as np
import pytest
from error_sentences import says
from gridded_currents import uniform_field
from image_checks import inked
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from team_scenarios import team, vehicle

import clpt_control as clpt_package
from analysis.worst_disturbance import regressor_matrices
from clpt_control import gramian
from examples import mrac

KERNELS = {"exponential": (4.3331, 4.6692), "gaussian": (0.19002, 0.19353)}


PAPER = clpt_package.paper_scenario()


@pytest.mark.parametrize(("kernel", "expected"), KERNELS.items())
def test_the_smallest_eigenvalues_of_the_paper(true_paper, kernel, expected):
    found = gramian(true_paper.with_values({"basis.kernel": kernel}), 200.0, 200.0)
    if kernel == "exponential":
        np.testing.assert_allclose([*found.ceilings.values()], [5.48, 5.19], atol=0.005)
    least = [values[0] for values in found.eigenvalues.values()]
    np.testing.assert_allclose(least, expected, rtol=5e-5)
    assert (found.not_learnable, found.dimension) == ([], {"x1": 5, "x2": 5})


def test_the_second_function_is_not_learnable_in_gaussian_sigma(true_paper):
    found = gramian(
        true_paper.with_values({"basis.kernel": "gaussian-sigma"}), 200.0, 200.0
    )
    assert found.dimension == {"x1": 4, "x2": 4}
    names = [f"theta_{i}[2]" for i in (1, 2)]
    assert found.not_learnable == [
        f"{name} is not learnable on this track" for name in names
    ]
    for name, axis in zip(names, ("x1", "x2"), strict=True):
        assert 0 < found.eigenvalues[axis][0] < 1e-10
        assert found.least_excited[axis][name] == pytest.approx(1, abs=1e-6)
        basis = found.excited[axis]
        np.testing.assert_allclose(basis.T @ basis, np.eye(4), atol=1e-12)
        assert abs(basis[1]).max() < 1e-6


def test_equal_functions_are_learnable_only_together(true_paper):
    twice = [12.42, 10.42, 12.42]
    alike = {"centers": [[0, 0], [10, 10], [0, 0]], "widths": [5] * 3, "periods": twice}
    values = {f"basis.{key}": value for key, value in alike.items()}
    found = gramian(true_paper.with_values({**values, "run.duration": 200}), 200.0, 0.0)
    assert found.not_learnable == [
        f"theta_{i}[1] and theta_{i}[3] are not learnable one by one on this track"
        for i in (1, 2)
    ]
    assert found.dimension == {"x1": 4, "x2": 4}


@pytest.mark.parametrize(("step", "tolerance"), [(1.0, 2e-3), (0.7, 1e-3), (0.2, 1e-6)])
def test_a_recorded_run_gives_the_same(true_paper, step, tolerance):
    exact = gramian(true_paper, 200.0, 200.0).report
    run = clpt_package.simulate(true_paper.with_values({"run.output_step": step}))
    report = gramian(run, 200.0, 200.0).report
    assert report["trajectory"] == f"recorded run, sampled each {step:g} s"
    assert exact["trajectory"] == "simulated from the initial values"
    found, wanted = (
        [one["eigenvalues"][a] for a in ("x1", "x2")] for one in (report, exact)
    )
    deviation = np.max(np.abs(np.divide(found, wanted) - 1))
    assert deviation <= min(report["accuracy"] + 1e-12, tolerance)
    assert report["contraction"] == pytest.approx(exact["contraction"], rel=1e-3)


@pytest.mark.parametrize("step", [7.0, 20.0, 500.0])
def test_what_samples_far_apart_do_not_say_is_not_known(paper, step):
    """An eigenvalue is 25 % off or more, and of two samples none can be left out to find it."""
    scenario = paper.with_values({"run.output_step": step})
    measured = gramian(clpt_package.simulate(scenario), 200.0, 200.0)
    found, exact = (
        one.eigenvalues["x1"] for one in (measured, gramian(scenario, 200.0, 200.0))
    )
    assert np.max(np.abs(np.divide(found, exact) - 1)) > 0.25
    assert measured.report["accuracy"] is None
    *_, said, _ = measured.result.sentences
    assert said.startswith(
        "accuracy of the eigenvalues: not known: the samples are too far"
    )


@pytest.mark.long
def test_a_disturbed_run_is_not_said_to_learn_as_fast_as_another(paper):
    """A learner that begins true has V = 0, which Delta raises: V falls to no share of itself."""
    push = {"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0.1]}}
    pushed = paper.with_values(push).started_true()
    before, after = clpt_package.simulate(pushed, [0.0, 200.0]).lyapunov.values
    assert after > before
    said = repr(gramian(pushed, 200.0, 0.0).certificate())
    assert "at worst, t = 0 to 200, but for what the disturbance adds" in said
    said = gramian(pushed, 200.0, 0.0).result.sentences
    assert "V and errors fall so but for what the disturbance adds to them" in said
    assert not gramian(paper, 200.0, 0.0).report["disturbed"]


@pytest.mark.long
def test_the_known_flow_law_has_a_certificate_of_its_gains(paper):
    known = {"learning.law": "known-flow", "learning.parameters": None}
    estimate = {"learning.theta_estimate": [[1, 0.4, 0.8], [0.9, 0.4, 0.8]]}
    report = gramian(paper.with_values(known | estimate), 200.0, 200.0).report
    assert 0 < report["drop"] < 1


def test_a_gridded_field_needs_no_theta(tmp_path):
    uniform_field(tmp_path / "field.nc", v=0.2, end=400.0)
    flow = {"flow": {"field": str(tmp_path / "field.nc")}, "run.duration": 100}
    scenario = PAPER.with_values(flow)
    assert len(gramian(scenario, 50.0, 20.0).eigenvalues["x1"]) == 5
    says(clpt_package.ScenarioError, "gridded", scenario.started_true)
    stopped = scenario.with_values({"flow.outside": "stop", "reference.radius": 30})
    says(
        clpt_package.ScenarioError,
        "the run ended before: stopped",
        gramian,
        stopped,
        50.0,
        20.0,
    )
    run = clpt_package.simulate(stopped.with_values({"run.output_step": 0.01}))
    assert len(gramian(run).eigenvalues["x2"]) == 5


@pytest.mark.parametrize(
    ("window", "start"),
    [(0, 0), (-1, 0), (500, 0), (200, 300), (10, -1), (np.inf, 0), (10, np.inf)],
)
def test_a_window_outside_the_run_is_refused(paper, window, start):
    says(
        clpt_package.ScenarioError,
        "within the run, 0 to 400 s",
        gramian,
        paper,
        window,
        start,
    )


def test_the_sliding_window_agrees_with_single_windows(paper):
    starts, eigenvalues = gramian(paper, 50.0).sliding(count=8)
    assert starts[[0, -1]].tolist() == [0.0, 350.0]
    for k in (0, 3, 7):
        for axis, values in gramian(paper, 50.0, float(starts[k])).eigenvalues.items():
            np.testing.assert_allclose(
                eigenvalues[axis][k], values, rtol=1e-5, atol=1e-12
            )


@pytest.mark.long
def test_the_figure_shows_what_is_not_learnable(true_paper, tmp_path):
    scenario = true_paper.with_values(
        {"basis.kernel": "gaussian-sigma", "run.duration": 100}
    )
    found = gramian(scenario, 60.0, 10.0)
    _, eigenvalues = found.sliding()
    (top, _), (bottom, _) = found.plot()
    top.figure.savefig(tmp_path / "excitation.png")
    drawn = {line.get_label(): line.get_ydata() for line in top.get_lines()}
    smallest = np.fmax(eigenvalues["x1"][:, 0], 1e-16 * eigenvalues["x1"].max())
    drawn_smallest = drawn[r"$\kappa_1$, smallest"]
    np.testing.assert_allclose(drawn_smallest, smallest, rtol=1e-12)
    least = found.least_excited["x1"]
    assert [bar.get_height() for bar in bottom.patches] == list(least.values())


def test_a_rate_of_the_window_is_said_of_the_window():
    """A regressor exp(-t/4): the window 0 to 4 repeated halves errors every 4 ln 2 / ln 1/rho.

    The run to 40, repeated, needs eight times as long.
    """
    fading = clpt_package.Block(
        "fading",
        update=lambda t, x, u, p: {
            "e": -x.e + np.exp(-t / 4) * x.th,
            "th": -np.exp(-t / 4) * x.e,
        },
        states={"e": 1, "th": 1},
    )
    verdict = clpt_package.lyapunov(fading, lambda s: s.e**2 / 2 + s.th**2 / 2)
    run = clpt_package.simulate(fading, np.linspace(0, 40, 401), None, [1.0, 1.0])
    found = clpt_package.gramian(run, 4.0, 0.0, of=verdict)

    def rates(t, y):
        w = np.exp(-t / 4)
        return (np.array([[-1, w], [-w, 0]]) @ y.reshape(2, 2)).ravel()

    ends = solve_ivp(rates, (0, 4), np.eye(2).ravel(), rtol=1e-11, atol=1e-13).y[:, -1]
    radius = max(abs(np.linalg.eigvals(ends.reshape(2, 2))))
    true = -4 * np.log(2) / np.log(radius)
    assert true <= found.certificate().half_life < 1.1 * true
    assert "if the window repeats" in repr(found)
    found.plot()  # one direction only


def test_places_on_a_circle_excite_both_axes_alike(paper):
    """sum p p^T = n r^2/2 I of n > 2 places, radius 3; of two the rank is 1."""
    for n in range(3, 25):
        points = paper.with_values({"reference.count": n}).waypoints
        np.testing.assert_allclose(
            points.T @ points, n * 9.0 / 2 * np.eye(2), atol=5e-11
        )
    two = paper.with_values({"reference.count": 2}).waypoints
    assert np.linalg.matrix_rank(two, tol=1e-9) == 1


@pytest.mark.long
def test_the_command_prints_the_report(printed, tmp_path, true_paper):
    clpt_package.save_scenario(true_paper, tmp_path / "true.toml")
    words = (tmp_path / "true.toml", "--window", "200", "--start", "200")
    found = printed("excitation", *words, "--figure", tmp_path / "true.png")
    report = gramian(true_paper, 200.0, 200.0).report
    assert report["eigenvalues"]["x1"] == sorted(report["eigenvalues"]["x1"])
    assert 0 < report["drop"] == pytest.approx(1 - report["contraction"])
    assert (report["time_to_tenth"] % 200, report["not_learnable"]) == (0, [])
    assert {key: found[key] for key in report} == json.loads(json.dumps(report))
    names = [*(f"theta_1[{k}]" for k in (1, 2, 3)), "K_1", "Gamma_1"]
    assert list(found["least_excited"]["x1"]) == names
    assert inked(tmp_path / "true.png") > 0.01


# --- signals of any run ---------------------------------------------------------------------------

TIMES = np.linspace(0, 40, 4001)


@pytest.fixture(scope="module")
def own_run():
    """A run of the adaptive loop of the examples, r = sin t."""
    return clpt_package.simulate(mrac.loop(), TIMES, np.sin(TIMES))


def test_signals_of_an_own_loop_have_the_gramian_computed_by_hand(own_run):
    found = gramian(own_run, 20.0, 20.0, signals=["r", "y"])
    w = np.stack([np.sin(TIMES), own_run.y.values.ravel()])[:, 2000:]
    by_hand = np.trapezoid(w[:, None] * w[None], TIMES[2000:], axis=-1)
    np.testing.assert_allclose(found.gramians["w"], by_hand, rtol=1e-9)
    # int sin^2 from 20 to 40
    exact = 10 - (np.sin(80) - np.sin(40)) / 4
    assert found.gramians["w"][0, 0] == pytest.approx(exact, rel=1e-4)
    assert found.names == {"w": ["r", "y"]}
    assert found.accuracy < 1e-4
    assert repr(found) == "<Excitation from 20 to 40: excited 2 of 2 along w>"
    json.dumps(found.report)


def test_a_diagram_is_simulated_as_its_run(own_run):
    inputs = {"timepts": TIMES, "inputs": np.sin(TIMES)}
    found = gramian(mrac.loop(), signals=["r", "y"], **inputs)
    again = gramian(own_run, signals=["r", "y"])
    assert found.eigenvalues["w"].tolist() == again.eigenvalues["w"].tolist()
    assert (found.start, found.window) == (0.0, 40.0)


def test_a_signal_that_repeats_another_is_not_learnable():
    """The regressor (r, 2 r) excites one direction."""
    double = clpt_package.Block(
        "double", output=lambda t, x, u, p: 2 * u.r, inputs={"r": 1}, outputs={"s": 1}
    )
    options = {"timepts": TIMES, "inputs": np.sin(TIMES)}
    found = gramian(double, signals=["r", "s"], **options)
    assert found.dimension == {"w": 1}
    share = 1 / np.sqrt(5)
    assert found.least_excited["w"] == pytest.approx({"r": 2 * share, "s": -share})
    assert found.not_learnable == ["r and s are not learnable one by one on this track"]


def test_sliding_windows_of_signals_begin_between_samples(own_run):
    """At 3 samples a second the windows begin and end within a sample's time."""
    run = own_run.isel(time=slice(None, None, 33))
    found = gramian(run, 10.1, signals=["r", "y"])
    starts, eigenvalues = found.sliding(count=7)
    for start, values in zip(starts, eigenvalues["w"], strict=True):
        alone = gramian(run, 10.1, float(start), signals=["r", "y"])
        np.testing.assert_allclose(values, alone.eigenvalues["w"], rtol=1e-3)
    (top,), _ = found.plot()
    assert top.get_xlabel() == "start of the window"  # times of a diagram have no unit
    low, high = top.get_ylim()
    assert high > 1.5 * low


def test_signals_of_the_papers_run_are_those_of_the_joint_regressor(true_paper):
    run = clpt_package.simulate(
        clpt_package.closed_loop(true_paper),
        np.linspace(0, 400, 4001),
        initial_state=clpt_package.initial_state(true_paper),
    )
    own = gramian(
        run,
        200.0,
        200.0,
        signals=["phi_x", "predicted_position axis 1", "reference axis 1"],
    )
    exact = gramian(true_paper, 200.0, 200.0).eigenvalues["x1"]
    np.testing.assert_allclose(own.eigenvalues["w"], exact, rtol=0.05)


SIGNALS = [
    (None, "signals: is required for a diagram. Name signals of the diagram"),
    (["r", "q"], r"signals = \['q'\]: must be signals of the run: .*y, .*r"),
    ([], "must be signals of the run"),
    ("ym", "must be a list of texts"),
]


@pytest.mark.parametrize(("signals", "said"), SIGNALS, ids=repr)
def test_signals_that_are_missing_or_unknown_are_refused(own_run, signals, said):
    says(clpt_package.ArgumentError, said, gramian, own_run, signals=signals)


def test_a_diagram_without_signals_is_refused_before_it_is_simulated(own_run):
    says(clpt_package.ArgumentError, "signals: is required", gramian, mrac.loop())
    said = "must be finite in the window"
    undefined = own_run.assign(r=own_run.r * np.nan)
    says(clpt_package.DataError, said, gramian, undefined, signals=["r"])


# --- directions that are learned within the run ---------------------------------------------------


def test_wide_functions_are_excited_but_not_learned_within_the_run():
    """Nine functions, wider than the track: all are excited, three directions are learned."""
    grid = np.linspace(-8.0, 8.0, 3)
    values = {
        "basis": {
            "kernel": "gaussian",
            "centers": [[a, b] for a in grid for b in grid],
            "widths": [8.0] * 9,
            "periods": [np.inf] * 9,
        },
        "flow.parameters": np.random.default_rng(1).normal(size=(2, 9)).round(2),
        "model.parameters": None,
        "learning.parameters": None,
    }
    found = gramian(PAPER.with_values(values))
    assert found.dimension == {"x1": 11, "x2": 11}
    assert found.certificate().learned == {"x1": 3, "x2": 3}
    assert found.certificate().time_to_tenth > 1e10
    assert "excited 11 of 11 along x1, 11 of 11 along x2" in repr(found)
    assert (
        "can be learned within the run, 2000 s: 3 of 11 along x1, 3 of 11 along x2"
        in repr(found)
    )
    assert "falls to a tenth: at most 4.5" in repr(found)


@pytest.mark.parametrize("duration", [400, 1000, 3000])
def test_learned_directions_are_those_of_the_error_system(true_paper, duration):
    """Eq. (28) over one window, by matrix exponentials, as often as the window fits."""
    step = 0.05
    A = regressor_matrices(true_paper, 400.0, step)[:, int(200 / step) :]
    exponentials = expm(step * A)
    scenario = true_paper.with_values({"run.duration": duration})
    found = gramian(scenario, 200.0, 200.0).certificate()
    gain = true_paper.learning.gain
    scale = np.diag([1.0, *[gain**-0.5] * 5])
    for axis, count in enumerate(found.learned.values()):
        window = reduce(lambda product, factor: factor @ product, exponentials[axis])
        power = scale @ np.linalg.matrix_power(window, duration // 200)
        power = power @ np.linalg.inv(scale)
        lengths = np.linalg.svd(power[:, 1:], compute_uv=False)
        assert count == np.sum(lengths <= 0.1)
    if min(found.learned.values()) == 5:
        assert found.time_to_tenth <= duration


def test_the_known_flow_law_learns_its_two_gains(paper):
    known = {"learning.law": "known-flow", "learning.parameters": None}
    estimate = {"learning.theta_estimate": [[1, 0.4, 0.8], [0.9, 0.4, 0.8]]}
    long = {"run.duration": 20000}
    found = gramian(paper.with_values(known | estimate | long), 200.0, 200.0)
    assert max(found.certificate().learned.values()) == 2
    assert "of 5 along x1" in repr(found)


def test_the_ceiling_is_an_identity_of_the_blocks():
    """w^T c = x' + KD e, at random states of the running diagram."""
    run = PAPER.with_values(
        {
            "model.parameters": [[0.3, 0.1, 0.2], [0.2, 0.7, 0.4]],
            "vehicle.feedback": [1.5, 0.7],
        }
    )
    truth, loop = (
        gramian(run.started_true(), 20.0, 100.0).truth,
        clpt_package.closed_loop(run),
    )
    rng, own = np.random.default_rng(2), [f"vehicle_x[{i}]" for i in range(2)]
    for t in rng.uniform(0, 100, 20):
        state = rng.normal(size=loop.nstates)
        rate = dict(zip(loop.state_labels, loop.dynamics(t, state, []), strict=True))
        seen = dict(zip(loop.output_labels, loop.output(t, state, []), strict=True))
        for i, c in enumerate(truth.values()):
            w = [seen[f"phi_x[{k}]"] for k in range(3)] + [
                seen[f"z[{i}]"],
                seen[f"zc[{i}]"],
            ]
            pulled = run.vehicle.feedback[i] * seen[f"e[{i}]"]
            assert w @ c == pytest.approx(rate[own[i]] + pulled)


MOVED = [
    ("vehicle.max_speed", 1.0),
    ("flow.disturbance", {"kind": "constant", "amplitude": [0.1, 0.0]}),
]


@pytest.mark.parametrize(("key", "value"), MOVED)
def test_where_something_else_moves_the_vehicle_there_is_no_ceiling(key, value):
    scenario = PAPER.with_values({"run.duration": 60, key: value})
    assert gramian(scenario, 20.0, 20.0).ceilings == {}


ALIKE = team(a=vehicle(), b=vehicle())


NOT_POOLED = [
    (3, (), "must be a Scenario, a Team, an xarray.Dataset or a diagram"),
    (ALIKE, (50.0,), "window 50 from 0: must be positive and lie"),
    (ALIKE, (-1.0, 0.0), "window -1 from 0: must be positive"),
]


@pytest.mark.parametrize(
    ("source", "arguments", "said"), NOT_POOLED, ids=["number", "too long", "negative"]
)
def test_what_has_no_pooled_gramian(source, arguments, said):
    says(clpt_package.ClptError, said, gramian, source, *arguments)


def test_the_certificate_of_one_vehicle_takes_no_team():
    for group in (ALIKE, clpt_package.simulate(ALIKE, [0.0, 1.0, 2.0])):
        excitation = clpt_package.gramian(group, 1.0, 0.0)
        with pytest.raises(
            clpt_package.DataError, match="A team and signals have Gramians only"
        ):
            excitation.certificate()
        for measured in (excitation, excitation.vehicles["a"]):
            said = "A team and its vehicles have Gramians of one window"
            says(clpt_package.DataError, said, measured.plot)


LINE = {
    "basis.kernel": "gaussian",
    "basis.centers": [[0, 3], [0, -3]],
    "basis.widths": [4, 4],
    "basis.periods": [np.inf, np.inf],
    "flow.parameters": [[0.5, 0.1], [0.2, -0.2]],
    "reference": {"kind": "waypoints", "points": [[-4, 0], [4, 0]], "dwell": 20},
    "basis.phases": [0, 0],
    "model.parameters": [[0, 0], [0, 0]],
    "learning.parameters": [[0, 0], [0, 0]],
    "learning.adapt_gains": False,
    "run.duration": 400,
}
NOISE = {"localization.noise": 0.05, "localization.noise_period": 1}


@pytest.mark.parametrize("noise", [{}, NOISE])
def test_a_straight_track_shows_two_mirrored_functions_together(noise):
    """phi_1 = phi_2 where x2 = 0; noise moves the vehicle off that line by chance."""
    scenario = PAPER.with_values(LINE | noise)
    found = gramian(scenario)
    assert found.dimension == {"x1": 1, "x2": 1}
    assert found.not_learnable == [
        f"theta_{i}[1] and theta_{i}[2] are not learnable one by one on this track"
        for i in (1, 2)
    ]
    share = {axis: v[0] / v[-1] for axis, v in found.eigenvalues.items()}
    assert all((1e-6 < s < 1e-3) if noise else s < 1e-9 for s in share.values())
    of_run = gramian(clpt_package.simulate(scenario)).not_learnable
    assert of_run == found.not_learnable
    assert ("without noise" in found._repr_html_()) == bool(noise)


@pytest.mark.parametrize("adapts", [True, False])
def test_gains_that_are_held_have_no_direction(adapts):
    values = {"learning.adapt_gains": adapts, "run.duration": 400}
    found = gramian(PAPER.with_values(values))
    flow, gains = [f"theta_1[{k}]" for k in (1, 2, 3)], ["K_1", "Gamma_1"]
    assert [*found.least_excited["x1"]] == flow + gains * adapts
    assert [G.shape for G in found.gramians.values()] == [(3 + 2 * adapts,) * 2] * 2


def test_the_decay_of_V_with_gains_that_are_held():
    """The law is e' = -e + eta phi, eta' = -0.8 e phi: transition by expm on short pieces."""
    held = {"learning.adapt_gains": False, "run.duration": 400}
    held |= {"learning.feedback": [1, 1], "learning.feedforward": [1, 1]}
    scenario = PAPER.with_values(held)
    found = gramian(scenario, 100.0, 100.0).certificate()
    step, n = 0.01, 10_000
    middle = 100 + step * (np.arange(n) + 0.5)
    run = clpt_package.simulate(scenario, [0.0, *middle])
    x = run.position.values[1:]
    centers, widths = np.array([[0, 0], [10, 10], [5, 5]]), 5.0
    distance = np.linalg.norm(x[:, None] - centers, axis=-1)
    waves = np.cos(2 * np.pi * middle[:, None] / [12.42, 10.42, 24.42])
    phi = np.exp(-distance / (2 * widths)) * waves * np.sqrt(0.8)
    Phi = np.eye(4)
    for w in phi:
        A = np.block([[-np.ones((1, 1)), w[None]], [-w[:, None], np.zeros((3, 3))]])
        Phi = expm(step * A) @ Phi
    contraction = np.linalg.norm(Phi, 2) ** 2
    assert found.contraction == pytest.approx(contraction, rel=1e-3)


def test_the_time_to_a_tenth_is_of_the_norm_of_all_errors():
    """A parameter that begins almost true takes up errors of others, and stays off."""
    almost = [[0, -0.399, 0], [0, 0, 0]]
    scenario = PAPER.with_values({"learning.parameters": almost, "run.duration": 4000})
    time = gramian(scenario, 200.0, 200.0).certificate().time_to_tenth
    run = clpt_package.simulate(scenario, [0.0, time])
    error = (run.flow_parameters_estimate - run.flow_parameters).values
    gains = [run[f"feed{way}_gain"].values - 1 for way in ("back", "forward")]
    errors = np.concatenate([error.reshape(2, -1), *gains], axis=1)
    start, end = np.linalg.norm(errors, axis=1)
    assert end <= start / 10
    assert abs(error[1, 0, 1]) > 0.9 * abs(error[0, 0, 1])
    said = repr(gramian(scenario, 200.0, 200.0))
    assert "the root of V falls to a tenth" in said
