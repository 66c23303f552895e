"""Laws and V that look right on symbols, and do not hold in a run: none is proved."""

import control
import numpy as np
import pytest
import user_laws
from small_scenarios import paper_of
from text_systems import TICKS, whole_times
from user_laws import GAIN, LEARNED, V_of, beside, changed, driven, scaled

import clpt_control as clpt
from clpt_control import ClptError, lyapunov, prove

POINTS = 200
SIZES = {"alpha": 4, "K": 2, "Gamma": 2}
ONE = "(cos(r)**2 + sin(r)**2)"
NOT_SAID = pytest.mark.xfail(
    strict=True, reason="inputs that must be bounded are not said"
)
SUM = {"a": 0.1, "b": 0.2, "c": 0.3}


def counted(rate):
    """A block whose y is driven by the number of its interval between breakpoints."""
    return clpt.Block(
        "clocked",
        update=lambda t, x, u, p: {"x": -x.x, "y": -x.y + rate(p.interval)},
        states={"x": 1, "y": 1},
        **TICKS,
    )


def square_of_x(s):
    return s.x**2


def fields_of(verdict):
    """Status, conclusion, and conditions of a verdict: name -> of what."""
    conditions = {condition.name: condition.of for condition in verdict.conditions}
    return verdict.status, verdict.conclusion, conditions


# --- rounding ---------------------------------------------------------------------------------


@pytest.mark.long
def test_a_gain_that_rounding_turns_is_not_proved():
    """g (1 - 1e16 (cos^2 r + sin^2 r - 1)) is g on symbols, and negative in floating point."""
    law = scaled(f"(1 - ({ONE} - 1)*1e16)", parameters=GAIN | {"r": 0.08})
    verdict = prove(law(), points=POINTS)
    assert verdict.status == "open"
    assert verdict.claim.startswith("V' <= -e^T KD e, N = 2")  # within its rounding


@pytest.mark.parametrize("rest", ["(a + b - c)*1e17*s**2", "0*exp(s**2)"])
def test_rates_of_states_outside_V_are_compared_with_the_blocks(rest):
    law = beside(f"s' = 1 - s + {rest}", {"s": 1}, GAIN | SUM)
    assert prove(law(), points=POINTS).status == "open"
    plant = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {
            "x": -x.x,
            "y": -x.y + (p.a + p.b - p.c) * 1e17 * x.y**2,
        },
        states={"x": 1, "y": 1},
        parameters=SUM,
    )
    assert lyapunov(plant, square_of_x).status == "open"


# --- states that V does not contain ---------------------------------------------------------


@pytest.mark.parametrize("rate", [lambda k: k, np.exp])
def test_an_interval_is_no_constant(rate):
    verdict = lyapunov(counted(rate), square_of_x)
    assert fields_of(verdict) == ("proved", "goes to zero", {"outside V": "y is"})


def test_an_interval_has_no_margin():
    """k counts the intervals, so that 5 - k falls below any number."""
    block = clpt.Block(
        "clocked",
        update=lambda t, x, u, p: {"x": -(5 - p.interval) * x.x},
        states={"x": 1},
        **TICKS,
    )
    assert lyapunov(block, square_of_x).status != "proved"


@pytest.mark.long
def test_a_state_whose_rate_grows_with_the_interval_may_grow():
    law = beside(
        "s' = interval*s + e[:1]",
        {"s": 1},
        GAIN | TICKS["parameters"],
        breakpoints=whole_times,
    )
    verdict = prove(law(), points=POINTS)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert "s is not held by V, and not known to be bounded" in verdict.sentence


def driven_by(source):
    """A plant whose y is driven by an opaque source of time."""
    made = clpt.Block(
        "source",
        output=lambda t, x, u, p: {"w": source(t)},
        outputs={"w": 1},
        opaque=True,
    )
    plant = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"x": -x.x, "y": u.w},
        states={"x": 1, "y": 1},
        inputs={"w": 1},
    )
    return clpt.connect([made, plant])


def test_a_state_that_an_opaque_source_drives_is_not_known_exactly_to_exist():
    verdict = lyapunov(driven_by(lambda t: 1 / (1 - t)), square_of_x)
    (step,) = [step for step in verdict.steps if "exist" in step.claim]
    assert (verdict.status, step.how) == ("proved", "sampled")
    assert step.claim.endswith("if w is bounded")


@NOT_SAID
def test_a_source_that_must_be_bounded_is_a_condition():
    """Where w = 1/(1 - t) y ends at t = 1, and x with it."""
    verdict = lyapunov(driven_by(lambda t: 1 / (1 - t)), square_of_x)
    conditions = fields_of(verdict)[2]
    assert conditions["outside V"] == "y is"
    assert conditions["bounded inputs"] == "w is"


def test_a_state_outside_V_is_bounded_where_its_input_is():
    """y' = -y + w, w any input."""
    plant = control.nlsys(
        lambda t, x, u, p: [-x[0], -x[1] + u[0]],
        states=["x", "y"],
        inputs=["w"],
        outputs=0,
        name="plant",
    )
    wanted = {"outside V, bounded": "y is", "bounded inputs": "w is"}
    verdict = lyapunov(plant, square_of_x)
    assert fields_of(verdict) == ("proved", "goes to zero", wanted)


# --- names ----------------------------------------------------------------------------------


def test_a_state_called_as_an_error_is_another_symbol():
    law = beside(
        "e_1' = 0*e_1; K' = dK + stack([10*(u.e[0] - e_1[0]), 0*u.e[0]])", {"e_1": 1}
    )
    assert prove(law(), points=POINTS).status != "proved"


def test_a_state_called_as_the_time_is_refused():
    with pytest.raises(
        ClptError, match="own: has a t, as time, V or a function is called"
    ):
        prove(beside("t' = 0*t", {"t": 1})(), points=POINTS)


def test_two_names_of_one_identifier_are_refused():
    parts = [
        control.nlsys(
            lambda t, x, u, p: -x,
            None,
            inputs=0,
            states=["a_x"],
            outputs=["a_x"],
            name="b",
        ),
        clpt.Block(
            "a",
            update=lambda t, x, u, p: {"x": -x.x},
            states={"x": 1},
            output=lambda t, x, u, p: {"y": x.x},
            outputs={"y": 1},
        ),
        clpt.Block(
            "c",
            update=lambda t, x, u, p: {"x": -x.x},
            states={"x": 1},
            output=lambda t, x, u, p: {"z": x.x},
            outputs={"z": 1},
        ),
    ]
    with pytest.raises(ClptError, match=r"a\.x and a_x are both s\.a_x"):
        lyapunov(clpt.connect(parts), lambda s: s.a_x**2)


# --- invariants -----------------------------------------------------------------------------

LEVEL = V_of("e @ e/2 + off/(2*gain)")

KEPT = {"losses": lambda s, p, truth: [], "points": POINTS}


def test_an_invariant_that_the_start_violates_proves_nothing():
    """A gain g (2 s - 1) is right from s = 1 on, and wrong from s = 0."""
    ports = ("alpha", "K", "Gamma")
    law = beside(
        "; ".join(f"{p}' = (2*s[0] - 1)*d{p}" for p in ports) + "; s' = 0*s", {"s": 1}
    )
    kept = {"invariants": lambda s, p, truth: {"s": np.array([1.0])}, **KEPT}
    verdict = prove(law(), LEVEL, **kept)
    assert verdict.status == "open"
    assert "s_1 = 1 does not hold at the start, where it is 0" in verdict.claim
    assert prove(law(), LEVEL, **kept, start={"s": 1.0}).status == "proved"


def test_invariants_that_contradict_each_other_prove_nothing():
    law = beside("a' = 0*a; b' = 0*b", {"a": 1, "b": 1})
    both = {"invariants": lambda s, p, truth: {"a": s["b"], "b": s["a"] + 1}}
    for start in ({}, {"b": 1.0}, {"a": 1.0}):
        with pytest.raises(ClptError, match="the relation -1 = 0 cannot be solved"):
            prove(law(), LEVEL, **both, **KEPT, start=start)


@pytest.mark.parametrize(
    ("rate", "status"), [("-2*a + b", "open"), ("-b", "proved"), ("-a", "proved")]
)
def test_an_invariant_that_repels_proves_nothing(rate, status):
    """(a - b)' = a - b keeps a = b on symbols, and rounding takes a run away from it."""
    law = beside(f"a' = phi_x[:1]**2 - a; b' = phi_x[:1]**2 + {rate}", {"a": 1, "b": 1})
    kept = {"invariants": lambda s, p, truth: {"b": s["a"]}, **KEPT}
    verdict = prove(law(), LEVEL, **kept)
    assert verdict.status == status
    assert ("repel" in verdict.claim) == (status == "open")


# --- laws that were refused by an error -----------------------------------------------------


@pytest.mark.long
@pytest.mark.parametrize("functions", [1, 2, 7])
def test_a_whole_number_among_the_parameters_changes_no_verdict(functions):
    given = user_laws.MATRIX | {"functions": functions}
    law = changed("alpha' = -outer(e, M @ phi_x)", given)
    assert prove(law(), points=POINTS).status == "proved"


def test_a_law_that_does_not_read_zc_gets_a_verdict():
    law = clpt.Block(
        "own",
        update=lambda t, x, u, p: {
            "alpha": -p.gain * np.outer(u.e, u.phi_x),
            "K": -p.gain * u.z * u.e,
            "Gamma": 0 * x.Gamma,
        },
        inputs={"e": 2, "phi_x": "N", "z": 2},
        parameters=GAIN,
        sizes={"N": 2},
        states=LEARNED,
    )
    assert prove(law, points=POINTS).status == "refuted"


@pytest.mark.parametrize("gain", [1e150, 1e-150])
def test_a_gain_beyond_all_numbers_says_why_it_is_open(gain):
    verdict = prove(user_laws.with_numbers(driven("e"), gain=gain)(), points=POINTS)
    assert verdict.status == "open"
    assert "scale states and gains" in verdict.claim


# --- one form of V --------------------------------------------------------------------------


def of_squares(s):
    off = np.sum((s.alpha + s.theta) ** 2) + np.sum((s.K - s.KD) ** 2)
    return s.e @ s.e / 2 + (off + np.sum((s.Gamma - s.GammaD) ** 2)) / (2 * s.gain)


def test_a_V_of_a_law_is_a_function_of_signals():
    verdict = prove(user_laws.paper(), of_squares, points=POINTS)
    assert (verdict.status, verdict.for_every_N) == ("proved", True)
    with pytest.raises(ClptError, match=r"V needs s\.q; s has .*alpha.*theta"):
        prove(user_laws.paper(), lambda s: s.e @ s.e + s.q)


def test_a_V_that_makes_a_block_is_refused_of_a_diagram():
    loop = clpt.closed_loop(clpt.paper_scenario())
    with pytest.raises(ClptError, match="returns a number and no block"):
        lyapunov(loop, LEVEL)


@pytest.mark.long
def test_a_law_of_python_control_is_judged_as_a_block_is():
    def update(t, x, u, params):
        e, phi, z, zc = u[:2], u[2:4], u[4:6], u[6:8]
        gain = params["gain"]
        return np.concatenate(
            [(-gain * np.outer(e, phi)).ravel(), -gain * z * e, gain * zc * e]
        )

    states = [f"{port}[{k}]" for port, n in SIZES.items() for k in range(n)]
    inputs = [f"{port}[{k}]" for port in ("e", "phi_x", "z", "zc") for k in range(2)]
    renamed = [label.replace("alpha", "a") for label in states]  # y = x all the same
    for gain, labels, status in (
        (0.5, states, "proved"),
        (-0.5, states, "refuted"),
        (0.5, renamed, "proved"),
    ):
        law = control.nlsys(
            update,
            inputs=inputs,
            states=labels,
            outputs=states,
            params={"gain": gain},
            name="own",
        )
        verdict = prove(law, points=POINTS)
        assert (verdict.status, verdict.for_every_N) == (status, False)


def test_a_hedged_loop_says_its_condition():
    limits = {"vehicle.max_speed": 1.5, "learning.hedging": True}
    loop = clpt.closed_loop(clpt.paper_scenario().with_values(limits))
    verdict = prove(loop, points=POINTS)
    assert verdict.status == "proved"
    assert "slower flow" in fields_of(verdict)[2]
    assert "where the flow stays slower than the vehicle" in verdict.sentence


# --- inputs ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("inputs", "conditions"), [(0, {}), (["torque"], {"zero inputs": "torque"})]
)
def test_a_V_is_searched_for_with_inputs_of_0(inputs, conditions):
    def swing(t, x, u, params):
        torque = u[0] if inputs else 0
        return [x[1], -9.81 * np.sin(x[0]) - 0.1 * x[1] + torque]

    pendulum = control.nlsys(
        swing, states=["angle", "rate"], inputs=inputs, outputs=2, name="p"
    )
    verdict = fields_of(lyapunov(pendulum))
    assert verdict == ("proved", "comes to rest", conditions)


def test_where_no_V_is_found_none_is_shown():
    unstable = control.nlsys(
        lambda t, x, u, p: [x[0] + u[0]],
        states=["x"],
        inputs=["u"],
        outputs=1,
        name="p",
    )
    verdict = lyapunov(unstable)
    assert (verdict.status, verdict.V) == ("open", None)
    assert "with u = 0" in verdict.claim


@pytest.mark.long
def test_a_wrong_law_is_refuted_by_both():
    law = clpt.laws()["learned-flow"].of(1, gain=0.5)
    rates = law.update_function

    def wrong(t, x, u, p):
        """Eqs. (21)-(23), one sign turned."""
        signs = np.array([[-1.0], [1.0]])
        right = rates(t, x, u, p)
        return right | {"alpha": signs * right["alpha"]}

    bad = user_laws.law(wrong, law.parameters._asdict(), n=1)
    assert prove(bad, points=POINTS).status == "refuted"
    loop = clpt.closed_loop(paper_of(1), law=bad, external=["zc"])
    assert lyapunov(loop, of_squares, points=50).status == "refuted"


@pytest.mark.sampled
@pytest.mark.parametrize(
    ("angle", "conclusion"), [(np.pi, "stable"), (3.0, "asymptotically stable")]
)
def test_a_damping_that_rounding_leaves_is_no_damping(angle, conclusion):
    """1 + cos(pi) is 0 as machines round it, and 7e-33 of the rounded pi exactly."""

    def swing(t, x, u, p):
        return {"q": x.v, "v": -x.q - (1 + np.cos(p.angle)) * x.v}

    states, parameters = {"q": 1, "v": 1}, {"angle": angle}
    loop = clpt.Block("swing", update=swing, states=states, parameters=parameters)
    verdict = lyapunov(loop, lambda s: (s.q**2 + s.v**2) / 2)
    assert (verdict.status, verdict.conclusion) == ("proved", conclusion)
