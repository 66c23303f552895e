"""Specifications of runs with answers in closed form: proved, refuted by a run, or open."""

import itertools
import math

import control
import numpy as np
import pytest

import clpt_control as clpt

K, Q, START = (0.9, 1.2), (0.7, 0.8), (0.0, 0.1)


def tank(**more):
    return clpt.Block(
        "tank",
        update=lambda t, x, u, p: {"level": p.q - p.k * x.level},
        states={"level": 1},
        parameters={"q": 0.75, "k": 1.0},
        **more,
    )


def level(k, q, start, t):
    return start * math.exp(-k * t) + q / k * (1 - math.exp(-k * t))


def judged(end=4.0, **specification):
    params = {"tank.k": K, "tank.q": Q}
    return clpt.verify(tank(), [0, end], None, [START], params, **specification)


HIGHEST = level(K[0], Q[1], START[1], 4.0)  # it rises to 8 / 9
LOWEST = level(K[1], Q[0], START[0], 4.0)


@pytest.mark.parametrize("form", ["text", "function", "never", "chain"])
def test_a_bound_of_a_level_is_decided_to_either_side(form):
    def specification(most):
        return {
            "text": {"always": f"level < {most!r}"},
            "function": {"always": lambda s: most - s.level},
            "never": {"never": f"level >= {most!r}"},
            "chain": {"always": f"-1 < level < {most!r}"},
        }[form]

    assert judged(**specification(HIGHEST + 0.02)).status == "proved"
    assert judged(**specification(HIGHEST + 1e-9), pieces=1).status == "open"
    margin = 1e-9
    refuted = judged(**specification(HIGHEST - margin))
    assert refuted.status == "refuted"
    # the run that is returned violates it, and is a member of the set
    assert float(refuted.run["level"].max()) > HIGHEST - 2 * margin
    member = {name: float(value) for name, value in refuted.member["params"].items()}
    assert K[0] <= member["tank.k"] <= K[1]
    assert Q[0] <= member["tank.q"] <= Q[1]
    assert START[0] <= refuted.member["initial_state"][0] <= START[1]


def test_a_target_by_a_time():
    lowest = level(K[1], Q[0], START[0], 3.0)
    verdict = judged(by=(3.0, f"level > {lowest - 0.06!r}"))
    assert verdict.status == "proved"
    assert level(K[1], Q[0], START[0], verdict.sure) > lowest - 0.06
    assert level(K[0], Q[1], START[1], verdict.possible) < lowest
    assert judged(by=(3.0, f"level > {lowest + 1e-9!r}")).status == "refuted"


def test_two_specifications_are_judged_together():
    both = {"always": "level < 0.95", "by": (2.0, "level > 0.4")}
    assert judged(**both).status == "proved"
    assert judged(**{**both, "never": "level > 0.5"}).status == "refuted"


def test_every_parameter_within_a_part():
    most = level(0.9 * 1.0, 1.1 * 0.75, 0.0, 4.0)
    verdict = clpt.verify(tank(), [0, 4], within=0.1, always=f"level < {most + 0.02!r}")
    assert verdict.status == "proved"
    verdict = clpt.verify(tank(), [0, 4], within=0.1, always=f"level < {most - 1e-9!r}")
    assert verdict.status == "refuted"
    assert verdict.conclusion == ""
    assert "level" in verdict.sentence


def test_what_a_run_does_between_its_times_counts():
    swing = control.nlsys(
        lambda t, x, u, p: [x[1], -x[0]], None, states=["a", "b"], name="swing"
    )
    for most, statuses in ((1.001, ["proved"]), (0.999, ["refuted"])):
        verdict = clpt.verify(swing, [0, 3], None, [0.0, 1.0], always=f"a < {most}")
        assert verdict.status in statuses
    # above the samples and below the peak
    verdict = clpt.verify(swing, [0, 3], None, [0.0, 1.0], always="a < 0.9999999")
    assert verdict.status != "proved"


def test_an_input_may_change_at_any_time():
    integrator = clpt.Block(
        "b", update=lambda t, x, u, p: u.d - x.x, states={"x": 1}, inputs={"d": 1}
    )
    end = 1 - math.exp(-2.0)
    arguments = integrator, [0, 2], {"d": (-1, 1)}, [0.0]
    assert clpt.verify(*arguments, always=f"abs(x) < {end + 0.02}").status == "proved"
    assert clpt.verify(*arguments, always=f"abs(x) < {end - 1e-9}").status == "refuted"


@pytest.mark.long  # 2 s of CPU: a set that one piece does not decide
def test_pieces_are_spent_until_it_is_decided():
    def rates(t, x, u, p):
        return {"a": x.w, "w": -np.sin(x.a) - x.w}

    pendulum = clpt.Block("p", update=rates, states={"a": 1, "w": 1})
    start = {"a": (-0.9, 0.9), "w": (-0.9, 0.9)}
    one, many = (
        clpt.verify(
            pendulum, [0, 6], None, start, by=(5.5, "hypot(a, w) < 0.19"), pieces=n
        )
        for n in (1, 16)
    )
    assert one.status == "open"
    assert "not decided" in one.sentence
    assert one.run is not None
    assert many.status == "proved"


def test_discrete_time_and_outputs_by_name():
    account = clpt.Block(
        "account",
        update=lambda t, x, u, p: 0.5 * x.x + u.d,
        output=lambda t, x, u, p: {"pair": [x.x[0], -x.x[0]], "square": x.x[0] ** 2},
        states={"x": 1},
        inputs={"d": 1},
        outputs={"pair": 2, "square": 1},
        dt=1.0,
    )
    arguments = account, [0, 3], {"d": (-1, 1)}, [0.0]  # |x| = 1, 1.5, 1.75
    assert clpt.verify(*arguments, always="pair[1] > -1.7500001").status == "proved"
    assert clpt.verify(*arguments, always="pair[0] < 1.7499").status == "refuted"
    assert clpt.verify(*arguments, always="square <= 3.0626").status == "proved"


BAD = {
    "levl < 1": "Did you mean 'level'?",
    "level": "is no comparison",
    "level == 1": "other than <",
    "level < 1 or level > 2": "is no comparison",
    "import os": "is no formula",
    "__import__('os').getpid() < 1": "is not read",
    "floor(level) < 1": "jumps",
}


@pytest.mark.parametrize("text", BAD)
def test_a_bad_specification_gets_a_sentence(text):
    with pytest.raises(clpt.ArgumentError, match=BAD[text].replace("?", r"\?")):
        judged(always=text)


@pytest.mark.parametrize(
    ("specification", "why"),
    [
        ({}, "has no specification"),
        ({"by": (9.0, "level < 1")}, "is no time of the run"),
        ({"by": "level < 1"}, "must be"),
        ({"always": 3.0}, "must be a text, a function"),
        ({"always": "level < 1", "within": 2.0}, "between 0 and 1"),
        ({"always": lambda s: s.level < 1}, "jumps"),
        ({"always": lambda s: math.sin(s.level)}, "is no number"),
    ],
)
def test_a_bad_argument_gets_a_sentence(specification, why):
    with pytest.raises(clpt.ArgumentError, match=why):
        judged(**specification)


def test_members_of_ends_with_labels_are_ends():
    verdict = clpt.verify(
        tank(), [0, 4], None, ({"level": 0.0}, {"level": 0.1}), always="level < 0.7"
    )
    assert verdict.status == "refuted"
    assert {*itertools.chain(verdict.member["initial_state"].values())} <= {0.0, 0.1}


def lag(state="x", name="lag"):
    return control.nlsys(
        lambda t, x, u, p: [-p["k"] * x[0]],
        None,
        states=[state],
        outputs=[state],
        inputs=0,
        params={"k": 1.0},
        name=name,
    )


def test_a_part_of_parameters_leaves_those_that_are_given_by_any_name():
    for name in ("k", "lag.k"):
        given = {"params": {name: (2.0, 3.0)}, "within": 0.1}
        fast = clpt.verify(lag(), [0, 1], None, [1.0], **given, always="x > 0.0499")
        assert fast.status == "refuted"  # exp(-3) = 0.0498
        assert 2.0 <= float(fast.member["params"][name]) <= 3.0
        slow = clpt.verify(lag(), [0, 1], None, [1.0], **given, by=(1, "x < 0.14"))
        assert slow.status == "proved"  # exp(-2) = 0.1353


def test_a_signal_with_the_name_of_the_time_is_refused():
    with pytest.raises(clpt.ArgumentError, match="a signal has the name t"):
        clpt.verify(lag("t"), [0, 1], None, [7.0], always="t < 2")


def test_a_margin_without_a_value_is_said():
    verdict = clpt.verify(lag(), [0, 2], None, [1.0], always="sqrt(x - 0.5) > -1")
    assert verdict.status == "open"
    claims = [step.claim for step in verdict.steps if not step.holds]
    assert any("has no value at t = 0.7 of a run" in claim for claim in claims)
    verdict = clpt.verify(lag(), [0, 2], None, [1.0], never="sqrt(x - 5) > 0.9")
    assert verdict.status == "open"
    assert not any(" inf" in step.claim for step in verdict.steps)


@pytest.mark.parametrize(
    "margin",
    [
        lambda s: None,
        lambda s: "x",
        lambda s: [2 - s.x, s.x + 1],
        lambda s: 1 / 0,
        "z < 2",
    ],
)
def test_a_margin_that_is_no_number_gets_a_sentence(margin):
    model = clpt.Block(
        "s", update=lambda t, x, u, p: {"x": -x.x, "z": -x.z}, states={"x": 1, "z": 2}
    )
    with pytest.raises(clpt.ArgumentError, match=r"is no number|several values"):
        clpt.verify(model, [0, 1], None, [1.0, 1.0, 1.0], always=margin)


def test_a_port_of_one_element_has_its_label():
    assert clpt.verify(tank(), [0, 4], always="level[0] < 1").status == "proved"


@pytest.mark.long  # 2 s of CPU: the run from 1 ends, so do its boxes
def test_runs_that_end_before_the_last_time_are_open():
    model = clpt.Block("b", update=lambda t, x, u, p: x.x**2, states={"x": 1})
    verdict = clpt.verify(model, [0, 1.5], None, [1.0], always="x > 0")
    assert verdict.status == "open"
    assert any("a run ends" in step.claim for step in verdict.steps)


def test_parameters_of_a_loop_of_blocks_vary_each():
    plant = control.nlsys(
        lambda t, x, u, p: [-p["k"] * x[0] + u[0]],
        lambda t, x, u, p: [x[0]],
        states=["x"],
        inputs=["u"],
        outputs=["y"],
        params={"k": 1.0},
        name="P",
    )
    law = control.nlsys(
        None,
        lambda t, x, u, p: [p["g"] * u[0]],
        inputs=["e"],
        outputs=["u"],
        params={"g": 3.0},
        name="C",
    )
    error = control.summing_junction(["r", "-y"], "e", name="S")
    loop = clpt.connect([plant, law, error], external="r")
    for most, status in ((0.79, "proved"), (0.785, "refuted")):  # 3.3 / 4.2
        verdict = clpt.verify(loop, [0, 2], [1.0], within=0.1, always=f"y < {most}")
        assert verdict.status == status


def test_a_part_of_parameters_that_have_no_interval_is_refused():
    asks = clpt.Block(
        "asks",
        update=lambda t, x, u, p: {"x": 1.0 if p.n < 3.2 else 5.0},
        states={"x": 1},
        parameters={"n": 3.0},
    )
    with pytest.raises(clpt.ArgumentError, match=r"asks\.n: can have no interval"):
        clpt.verify(asks, [0, 1], within=0.1, always="x < 2")
    given = clpt.verify(
        asks, [0, 1], params={"asks.n": 3.0}, within=0.1, always="x < 2"
    )
    assert given.status == "proved"
    plain = control.ss(-1, 1, 1, 0, name="q", inputs="u", outputs="y")
    with pytest.raises(clpt.ArgumentError, match="there is no parameter"):
        clpt.verify(plain, [0, 1], [1.0], within=0.1, always="y < 2")


def test_a_margin_that_changes_from_call_to_call_is_refused():
    rng = np.random.default_rng(0)
    with pytest.raises(clpt.ArgumentError, match="differs from call to call"):
        judged(always=lambda s: s.level + rng.random())


def test_bounds_that_count_and_bounds_that_do_not_are_read_together():
    assert judged(always="-0.1 <= level < 1").status == "proved"
    assert judged(always="0 <= level < 0.8").status == "refuted"
    still = clpt.Block("s", update=lambda t, x, u, p: 0 * x.x, states={"x": 1})
    # at the bound itself neither is shown
    verdict = clpt.verify(still, [0, 1], None, [1.0], always="0 <= x < 1")
    assert verdict.status != "proved"


def test_a_time_of_samples_is_found_to_its_rounding():
    integrator = clpt.Block(
        "b", update=lambda t, x, u, p: u.d, states={"x": 1}, inputs={"d": 1}
    )
    times = np.arange(0.0, 1.0, 0.1)  # 0.3 is 0.30000000000000004
    ones = np.ones((1, len(times)))
    arguments = integrator, times, ones, [0.0]
    assert clpt.verify(*arguments, by=(0.3, "x > 0.2999")).status == "proved"
    with pytest.raises(clpt.ArgumentError, match="is no time of the run"):
        clpt.verify(*arguments, by=(0.35, "x > 0.2999"))


@pytest.mark.long  # seconds: the boxes of a whole loop
def test_times_of_a_scenario_are_those_of_its_run():
    scenario = clpt.paper_scenario().with_values({"run.duration": 2.0})
    with pytest.raises(clpt.ArgumentError, match="is no time of the run"):
        clpt.verify(scenario, by=(1.5, "e[0] < 9"))


def test_a_margin_may_have_limits():
    for margin in (
        lambda s: 1.1 - np.clip(s.level, 0, 2),
        lambda s: np.clip(s.level, 0.5, None) - 0.49,
    ):
        assert clpt.verify(
            tank(), [0, 1], None, [(0.5, 1.0)], always=margin
        ).status == ("proved")


@pytest.mark.long  # 6 s of CPU: a diagram that runs in Python
def test_a_part_of_a_parameter_that_a_diagram_gives_by_its_long_name():
    """a(1) = e^-k, k = 2 within 10 %, is from 0.1108 to 0.1653."""

    both = clpt.connect([lag("a", "A"), lag("b", "B")], name="both")
    both.params = {"A.k": 2.0}
    for always, status in (("a > 0.12", "refuted"), ("a > 0.1107", "proved")):
        found = clpt.verify(both, [0, 1], None, [1.0, 1.0], within=0.1, always=always)
        assert found.status == status


def test_a_figure_of_a_verdict_has_the_bound_and_the_run():
    found = clpt.verify(tank(), [0, 1], None, [(0.5, 1.0)], always="level < 0.9")
    panel = np.ravel(found.plot())[0]
    assert panel.get_title(loc="left") == "margin of always level < 0.9"
    words = [text.get_text() for text in panel.get_legend().get_texts()]
    assert {"bound", "run"} <= {*words}
    # the run that begins at 1 has the margin -0.1 there
    lines = {line.get_label(): line.get_ydata() for line in panel.lines}
    assert lines["run"][0] == pytest.approx(-0.1, abs=0.05)
    assert not np.any(lines["bound"])
    proved = clpt.verify(tank(), [0, 1], None, [(0.5, 0.8)], always="level < 0.9")
    labels = [line.get_label() for line in np.ravel(proved.plot())[0].lines]
    # boxes that explode, of x' = x^2 towards 1/(1 - t), leave the run in sight
    growing = clpt.Block("growing", update=lambda t, x, u, p: [x.x**2], states={"x": 1})
    times = np.linspace(0, 0.96, 49)
    wide = clpt.verify(growing, times, None, [(0.5, 1.0)], always="x < 1.9", pieces=1)
    margin = wide.margins[next(iter(wide.margins))]
    low, high = np.ravel(wide.plot())[0].get_ylim()
    assert high - low <= 7.5 * np.ptp([*margin, 0.0])
    assert {"bound", "run"}.intersection(labels) == {"bound"}


@pytest.mark.long  # 2 s of CPU: a limited loop of 20 s
@pytest.mark.parametrize("times", [[0, 20], np.linspace(0, 20, 41)])
@pytest.mark.parametrize("rain", [(0.0, 0.2), {"wanted": 1.0, "rain": (0.0, 0.2)}])
def test_an_input_that_changes_once_may_violate(times, rain):
    """The integral of a limited law is that of no rain when 0.2 comes: 1.08 at rest, then less."""
    tank = clpt.Block(
        "tank",
        update=lambda t, x, u, p: {"level": u.valve + u.rain - 0.5 * x.level},
        inputs={"valve": 1, "rain": 1},
        states={"level": 1},
    )
    law = clpt.parts.pid(2.0, 0.4, low=0, high=1, r="wanted", y="level", u="valve")
    loop = clpt.connect([law, tank], external=["wanted", "rain"])
    inputs = rain if isinstance(rain, dict) else [1.0, rain]
    found = clpt.verify(
        loop, times, inputs, {"tank_level": (0.0, 0.3)}, always="level < 1.027"
    )
    assert found.status == "refuted"
    assert float(found.run.level.max()) > 1.027
    held = clpt.simulate(loop, np.linspace(0, 20, 201), [1.0, 0.2], {"tank_level": 0.0})
    assert float(held.level.max()) < 1.0  # with rain all along


def test_a_bound_near_a_rest_holds_between_few_times():
    """level = 2 (1 - exp(-t / 4)) is below 2; boxes hold over intervals of long steps."""
    filled = clpt.Block(
        "tank",
        update=lambda t, x, u, p: {"level": (1 - 0.5 * x.level) / 2},
        states={"level": 1},
    )
    assert clpt.verify(filled, [0, 50], None, [0.0], always="level < 2").status == (
        "proved"
    )
