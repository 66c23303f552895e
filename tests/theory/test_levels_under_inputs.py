"""Levels of V under bounded inputs, against closed forms and runs at the worst inputs."""

import re
from functools import partial

import numpy as np
import pytest
import sympy
from coq_files import REALS, compiled
from text_systems import conclusion_of

import clpt_control as clpt


def loop(rates, states=1, **ports):
    """Return a block of one port x, with inputs and parameters."""
    inputs = ports.pop("inputs", {"d": 1})

    def update(t, x, u, p):
        return {"x": rates(x.x, u, p)}

    states = {"x": states}
    return clpt.Block("loop", update=update, states=states, inputs=inputs, **ports)


def half(s):
    return s.x**2 / 2


lag = loop(lambda x, u, p: -x + u.d)
cubic = loop(lambda x, u, p: -(x**3) + u.d)
scaled = loop(lambda x, u, p: -x + u.d * x)
gain = loop(lambda x, u, p: -p.a * x + u.d, parameters={"a": 2.0})
vector = loop(lambda x, u, p: -2 * x + u.d, 2, inputs={"d": 2})


spring = clpt.Block(
    "spring",
    update=lambda t, x, u, p: {"x": x.v, "v": -x.x - x.v + u.d},
    states={"x": 1, "v": 1},
    inputs={"d": 1},
)


def crossed(s):
    return 1.5 * s.x**2 + s.x * s.v + s.v**2


@pytest.mark.parametrize(
    ("system", "bounds", "level"),
    [
        (lag, (-3, 3), 9 / 2),
        (lag, (-1, 3), 9 / 2),
        (lag, (0, 3), 9 / 2),
        (gain, (-3, 3), (3 / 2) ** 2 / 2),
        (gain, (-1, 3), (3 / 2) ** 2 / 2),
        (cubic, (-2, 2), 2 ** (2 / 3) / 2),
    ],
)
def test_the_level_is_that_of_the_rest_at_the_largest_input(system, bounds, level):
    verdict = clpt.lyapunov(system, half, where={"d": bounds})
    assert verdict.conclusion == "ultimately bounded"
    # rounded up, to four digits
    assert level <= float(verdict.level) <= 1.001 * level
    assert "comes down to" in verdict.sentence


def test_the_sentence_names_the_bounds():
    sentence = clpt.lyapunov(lag, half, where={"d": (-1, 3)}).sentence
    assert sentence == "V' <= -V + 4.5, so V comes down to 4.5; where -1 <= d <= 3"


@pytest.mark.long
def test_corners_that_pull_unequally_give_a_higher_level():
    level = clpt.lyapunov(cubic, half, where={"d": (-1, 3)}).level
    # the least rate with the largest push: V at the rest is 3^(2/3)/2
    assert 3 ** (2 / 3) / 2 < level < 3 ** (2 / 3) * 3 ** (2 / 3) / 2 * 1.01


def test_a_vector_has_bounds_for_each_element():
    square = partial(clpt.lyapunov, vector, lambda s: s.x @ s.x / 2)
    # |x_j| comes to D_j/2
    verdict = square(where={"d[0]": (-1, 1), "d[1]": (-2, 2)})
    assert verdict.level == pytest.approx((0.5**2 + 1.0**2) / 2)
    assert square(where={"d[0]": (-1, 1)}).status == "open"


@pytest.mark.long
def test_a_v_with_cross_terms_bounds_the_worst_run():
    verdict = clpt.lyapunov(spring, crossed, where={"d": (-1, 1)})
    assert verdict.conclusion == "ultimately bounded"
    # V' = -x^2 - v^2 + d (x + 2 v): the input that raises V most
    x, worst = np.zeros(2), 0.0
    for _ in range(40_000):
        d = 1.0 if x[0] + 2 * x[1] >= 0 else -1.0
        x = x + 1e-3 * np.array([x[1], -x[0] - x[1] + d])
        worst = max(worst, 1.5 * x[0] ** 2 + x[0] * x[1] + x[1] ** 2)
    # at constant d = 1 the rest x = (1, 0) has V = 1.5
    assert 1.5 < worst <= verdict.level
    energy = clpt.lyapunov(spring, lambda s: s.x**2 + s.v**2, where={"d": (-1, 1)})
    assert energy.status == "open"


@pytest.mark.sampled
@pytest.mark.parametrize("amplitude", [1.0, 3.0])
def test_no_run_ends_above_the_level(amplitude):
    level = clpt.lyapunov(cubic, half, where={"d": (-amplitude, amplitude)}).level
    timepts = np.linspace(0.0, 30.0, 301)
    for d in (amplitude, -amplitude, amplitude * np.sign(np.sin(timepts))):
        run = clpt.simulate(cubic, timepts, {"d": d}, {"x": 5.0})
        assert float(run.states[-1].item()) ** 2 / 2 <= level + 1e-6


def test_an_input_that_multiplies_the_state():
    judged = partial(clpt.lyapunov, scaled, half)
    # V' = -(1 - d) x^2
    for least in (-0.5, -5):
        found = judged(where={"d": (least, 0.5)})
        assert found.implies("exponentially stable")
        assert f"{found.decay}" == "V(0)*exp(-t)"
    assert judged(where={"d": (-1, 1)}).conclusion == "stable"
    assert judged(where={"d": (-2, 2)}).status == "open"


def test_two_inputs_of_which_one_is_bounded():
    both = loop(lambda x, u, p: -x + u.d * x + u.e, inputs={"d": 1, "e": 1})
    judged = partial(clpt.lyapunov, both, half)
    assert judged(where={"d": (-0.5, 0.5)}).status == "open"
    # x' = -x/2 + 1 rests at 2
    verdict = judged(where={"d": (-0.5, 0.5), "e": (-1, 1)})
    assert verdict.level == pytest.approx(2.0**2 / 2)


def test_a_claim_within_bounds():
    judged = partial(clpt.lyapunov, lag, half, where={"d": (-3, 3)})
    # x d <= x^2/2 + d^2/2, but a claim is for inputs of any size
    assert judged(lambda s: 4.5 - s.x**2 / 2).status == "open"
    assert judged(lambda s: 4.4 - s.x**2 / 2).status == "open"


@pytest.mark.parametrize(
    "rates",
    [
        lambda x, u, p: -np.sin(x) + u.d,
        lambda x, u, p: x + u.d,
        lambda x, u, p: -x + np.abs(u.d),
        lambda x, u, p: x * np.abs(x) + u.d,
        lambda x, u, p: x * (u.d**2 - 0.1),
        lambda x, u, p: -x * np.abs(x) + 3 * u.d * x**2,
    ],
    ids=["V does not bound", "unstable", "kink", "away", "grows", "as fast"],
)
def test_open_where_no_level_is_known(rates):
    verdict = clpt.lyapunov(loop(rates), half, where={"d": (-0.5, 0.5)})
    assert verdict.status == "open"


@pytest.mark.parametrize(
    ("bounds", "message"),
    [
        ((3, -3), "Give two numbers, the lower first"),
        ((-np.inf, np.inf), "of an input"),
        ((None, None), "of an input"),
        ((-1e155, 1e155), "between 1e-100 and 1e100"),
        ((0, 1e-162), "between 1e-100 and 1e100"),
        ((1, 2, 3), "Give two numbers"),
        ((np.nan, 1), "where"),
        (("a", "b"), "where"),
        ("ab", "where"),
    ],
)
def test_bounds_that_are_none_are_refused(bounds, message):
    with pytest.raises(clpt.ClptError, match=message):
        clpt.lyapunov(lag, half, where={"d": bounds})


def test_names_and_a_v_of_inputs_are_refused():
    with pytest.raises(clpt.ClptError, match="there is no q"):
        clpt.lyapunov(lag, half, where={"q": (0, 1)})
    with pytest.raises(clpt.ClptError, match=r"at: there is no q\. It has x"):
        clpt.lyapunov(lag, half, at={"q": 0})
    with pytest.raises(clpt.ClptError, match="V depends on input d"):
        clpt.lyapunov(lag, lambda s: (s.x - s.d) ** 2 / 2, where={"d": (0, 1)})
    same = clpt.Block(
        "same", update=lambda t, x, u, p: {"x": -x.x}, states={"x": 1}, inputs={"x": 1}
    )
    with pytest.raises(clpt.ClptError):
        clpt.lyapunov(same, half, where={"x": (0, 1)})


def in_steps(rates):
    """Return a loop in discrete time."""
    ports = {"states": {"x": 1}, "inputs": {"d": 1}}
    update = lambda t, x, u, p: {"x": rates(x.x, u.d)}  # noqa: E731
    return clpt.Block("step", update=update, dt=1.0, **ports)


def test_V_of_the_next_time_is_largest_at_a_corner():
    """x+ = x/2 + d, |d| <= 1: |x| comes down to 2."""
    step = in_steps(lambda x, d: x / 2 + d)
    verdict = clpt.lyapunov(step, lambda s: s.x**2, where={"d": (-1, 1)})
    assert verdict.conclusion == "ultimately bounded"
    assert 4 <= verdict.level <= 8


@pytest.mark.parametrize(
    ("rates", "bounds"),
    [
        (lambda x, d: x + d, (-1, 1)),
        (lambda x, d: -x + d, (-1, 1)),
        (lambda x, d: 1.1 * x + d, (-1, 1)),
        (lambda x, d: x / 2 + d * x, (-1, 1)),
        (lambda x, d: x**2 + d, (-1, 1)),
        (lambda x, d: x / 2 + d, (0, None)),
        (lambda x, d: x / 2 - 1.6 * d**2 * x, (-1, 1)),
    ],
)
def test_no_level_in_discrete_time(rates, bounds):
    V = lambda s: s.x**2  # noqa: E731
    verdict = clpt.lyapunov(in_steps(rates), V, where={"d": bounds})
    assert verdict.status == "open"


@pytest.mark.parametrize(
    ("rates", "V", "level"),
    [
        (lambda x, u, p: -x + u.d, lambda s: s.x**4 / 4, 1 / 4),
        (lambda x, u, p: -x * np.abs(x) + u.d, half, 1 / 2),
        (lambda x, u, p: -(x**3) + u.d, lambda s: s.x**4 / 4, 1 / 4),
        (lambda x, u, p: -x + u.d**2, half, 1 / 2),
        (lambda x, u, p: -x - 2 * x**3 + (1 + x**2) * u.d**2, half, 0.2731),
    ],
)
def test_V_and_its_loss_have_different_degrees(rates, V, level):
    """At the level x' = 0 with d = 1: the last has 1 + x^2 = x + 2 x^3 at x = 0.739."""
    verdict = clpt.lyapunov(loop(rates), V, where={"d": (-1, 1)})
    assert verdict.conclusion == "ultimately bounded"
    assert level <= verdict.level <= 1.05 * level


SATURATED = {  # rates, |d|, the largest |x| that is reached, or None
    "tanh": (lambda x, u, p: -np.tanh(x) + u.d, 0.5, np.arctanh(0.5)),
    "tanh, as strong": (lambda x, u, p: -np.tanh(x) + u.d, 1.0, None),
    "clip": (lambda x, u, p: -2 * np.clip(10 * x, -1, 1) + u.d, 1.0, 0.05),
    "a layer": (lambda x, u, p: -2 * x / (np.abs(x) + 0.1) + u.d, 1.0, 0.1),
    "a dead zone": (lambda x, u, p: np.clip(x, -1, 1) - x + u.d, 0.5, 1.5),
    "fades far off": (lambda x, u, p: -2 * x / (1 + x**2) + u.d, 0.5, None),
}


@pytest.mark.long
@pytest.mark.parametrize(("rates", "d", "most"), SATURATED.values(), ids=SATURATED)
def test_saturated_control_against_a_disturbance(rates, d, most):
    """|x| comes down to where the rate at the largest input is 0."""
    verdict = clpt.lyapunov(loop(rates), half, where={"d": (-d, d)})
    if most is None:
        assert verdict.status == "open"
    else:
        assert verdict.conclusion == "ultimately bounded"
        assert most**2 / 2 <= verdict.level <= 1.02 * most**2 / 2
        with pytest.raises(clpt.ClptError, match=r"no push less|has pieces"):
            verdict.coq()


TWO_STATES = {  # rates of x and v, V, a level that is reached at d = 1
    "cascade": (
        lambda x, v, d: (-(x**3) + v, -v + d),
        lambda s: s.x**4 / 4 + s.v**2 / 2,
        0.75,
    ),
    "Duffing": (
        lambda x, v, d: (v, -v - x - x**3 + d),
        lambda s: s.v**2 / 2 + 0.75 * s.x**2 + s.x**4 / 4 + s.x * s.v / 2,
        0.75 * 0.6823**2 + 0.6823**4 / 4,
    ),
}


@pytest.mark.long
@pytest.mark.parametrize(("rates", "V", "least"), TWO_STATES.values(), ids=TWO_STATES)
def test_a_cascade_and_a_hard_spring_have_levels(rates, V, least):
    """The rest at d = 1 is x = v = 1, and x + x^3 = 1, v = 0."""
    block = clpt.Block(
        "loop",
        update=lambda t, x, u, p: dict(zip("xv", rates(x.x, x.v, u.d), strict=True)),
        states={"x": 1, "v": 1},
        inputs={"d": 1},
    )
    verdict = clpt.lyapunov(block, V, where={"d": (-1, 1)})
    assert verdict.conclusion == "ultimately bounded"
    assert least <= verdict.level <= 8 * least
    assert "Theorem verdict" in verdict.coq()


@pytest.mark.long
def test_an_e_modification_with_a_disturbance_has_a_level():
    """V' <= -|e| (|e| + sg z^2/(2 g) - 1 - sg th^2/(2 g)), z = h - th."""
    law = clpt.Block(
        "law",
        update=lambda t, x, u, p: {
            "e": -x.e + (p.th - x.h) * u.r + u.d,
            "h": p.g * x.e * u.r - p.sg * np.abs(x.e) * x.h,
        },
        states={"e": 1, "h": 1},
        inputs={"r": 1, "d": 1},
        parameters={"th": 1.0, "g": 2.0, "sg": 0.5},
    )
    V = lambda s: s.e**2 / 2 + (s.h - s.th) ** 2 / (2 * s.g)  # noqa: E731
    verdict = clpt.lyapunov(law, V, where={"d": (-1, 1)})
    assert verdict.conclusion == "bounded"
    # the corner e = 0: z^2/(2 g) = (1 + sg th^2/(2 g))/sg
    assert float(verdict.level) == pytest.approx(2.25)


def root(x):
    return np.sign(x) * np.sqrt(np.abs(x))


FINITE = {  # rates, |d|, start, the time at which x is 0 at the worst d, or None
    "a root": (lambda x, u, p: -2 * root(x), 0, 4.0, 2.0),
    "a root and a lag": (lambda x, u, p: -x - root(x), 0, 1.0, 2.0),
    "sliding": (lambda x, u, p: -3 * np.sign(x) + u.d, 1, 5.0, 2.5),
    "a lag": (lambda x, u, p: -x, 0, 1.0, None),
    "a cube": (lambda x, u, p: -(x**3), 0, 1.0, None),
    "sliding, as strong": (lambda x, u, p: -np.sign(x) + u.d, 1, 1.0, None),
}


@pytest.mark.parametrize(("rates", "d", "x", "time"), FINITE.values(), ids=FINITE)
def test_the_time_after_which_v_is_zero(rates, d, x, time):
    where = {"d": (-d, d)} if d else None
    found = clpt.lyapunov(loop(rates), half, where=where).sentence
    text = re.search(r"V is 0 after the time ([^,]*)", found)
    assert bool(text) == (time is not None)
    if text:
        of_start = sympy.sympify(text[1].replace("V(0)", f"({x**2 / 2})"))
        assert float(of_start) == pytest.approx(time)


@pytest.mark.parametrize(
    "V",
    [
        lambda s: s.x**2 / 2 + s.x**4 / 4,
        lambda s: s.x**2 / 2 + 1,
        lambda s: np.maximum(s.x, 0) ** 2 / 2,
    ],
    ids=["two powers", "not zero at the rest", "zero on one side"],
)
def test_no_time_is_said_of_another_v(V):
    found = clpt.lyapunov(loop(lambda x, u, p: -root(x), inputs={}), V)
    assert "after the time" not in found.sentence


@pytest.mark.parametrize("gain", [np.pi, np.e, 1 / np.pi, np.sqrt(3), 1e-9 * np.pi])
@pytest.mark.parametrize("power", [0.0, 1 / 3, 0.5, np.pi / 10])
def test_the_time_is_rounded_up(gain, power):
    """x' = -g |x|^a sign x is 0 at |x|^(1 - a)/(g (1 - a)), at most 0.1 % below what is said."""

    def rates(x, u, p):
        return -gain * np.sign(x) * (np.abs(x) ** power if power else 1.0)

    found = clpt.lyapunov(loop(rates, inputs={}), half)
    (text,) = re.findall(r"V is 0 after the time ([^,]*)", found.sentence)
    for x in (1.0, 1e60):
        V = f"(Rational({x!r})**2/2)"
        said = float(sympy.N(sympy.sympify(text.replace("V(0)", V)), 30))
        true = x ** (1 - power) / (gain * (1 - power))
        assert true * (1 - 1e-12) <= said < 1.001 * true
    (claim,) = [s.claim for s in found.steps if "after the time" in s.claim]
    assert text in claim


@pytest.mark.parametrize("power", [1 - 1.23456789e-10, 1 - 2e-15, 1 - 1.23456789e-6])
def test_an_exponent_near_one_is_no_whole_number_and_gives_no_time(power):
    rates = lambda x, u, p: -np.sign(x) * np.abs(x) ** power  # noqa: E731
    found = clpt.lyapunov(loop(rates, inputs={}), half)
    assert found.implies("asymptotically stable")
    assert f"Abs(x)**{power!r} <= 0" in found.sentence
    assert "after the time" not in found.sentence
    assert f"{power!r}"[:12] in found.latex()


def test_a_rest_that_v_reaches_in_a_time_is_asymptotically_stable():
    """Of sign(x^3) no form is lost; the sliding gain 1.1 is above |d| <= 1."""
    for rates, where in (
        (lambda x, u, p: -np.sign(x**3), None),
        (lambda x, u, p: -1.1 * np.sign(x) + u.d, {"d": (-1, 1)}),
    ):
        inputs = {"d": 1} if where else {}
        found = clpt.lyapunov(loop(rates, inputs=inputs), half, where=where)
        assert "V is 0 after the time" in found.sentence
        assert found.implies("asymptotically stable")


@pytest.mark.long
def test_sliding_control_overcomes_its_disturbance():
    sliding = loop(lambda x, u, p: -2 * np.sign(x) + u.d)
    conclusions = [
        clpt.lyapunov(sliding, half, where={"d": (-d, d)}).conclusion for d in (1, 2, 3)
    ]
    assert conclusions == ["asymptotically stable", "square-integrable", ""]


AS = "asymptotically stable"
SLIDING = {  # rates of x and v, where |d| <= 1: conclusion
    "linear terms too": (lambda x, v, d: (v - x, -x - 2 * np.sign(v) - v + d), AS),
    "both slide": (lambda x, v, d: (v - 2 * np.sign(x), -x - 2 * np.sign(v) + d), AS),
    "too weak": (lambda x, v, d: (v - x, -x - 0.9 * np.sign(v) - 0.1 * v + d), None),
    "as strong": (lambda x, v, d: (-x, -np.sign(v) + d), "goes to zero"),
    "of another state": (lambda x, v, d: (v - x, -x - 2 * np.sign(x) + d), None),
    "friction alone": (
        lambda x, v, d: (v, -x - 2 * np.sign(v) - v + d),
        "goes to zero",
    ),
    "one state less": (lambda x, v, d: (v, -x - 2 * np.sign(v) + d), "goes to zero"),
    "a push that grows": (
        lambda x, v, d: (v - x, -x - 2 * np.sign(v) + d * (1 + v)),
        None,
    ),
    "another way": (lambda x, v, d: (v - x, -x + 2 * np.sign(v) - v + d), None),
    "with time": (
        lambda x, v, d: (v - x, -x - (2 * np.sign(v) - d) * v**2 * x**2),
        None,
    ),
}


@pytest.mark.long
@pytest.mark.parametrize("name", SLIDING)
def test_sliding_and_linear_terms_together(name):
    """x or v sticks off the rest, or is pushed away, where no conclusion is a rest."""
    rates, conclusion = SLIDING[name]
    block = clpt.Block(
        "loop",
        update=lambda t, x, u, p: dict(zip("xv", rates(x.x, x.v, u.d), strict=True)),
        states={"x": 1, "v": 1},
        inputs={"d": 1},
    )
    found = clpt.lyapunov(block, lambda s: (s.x**2 + s.v**2) / 2, where={"d": (-1, 1)})
    assert conclusion_of(found) == conclusion or (
        conclusion is None and conclusion_of(found) != AS
    )


IN_BOUNDS = {  # rates, bounds of d, conclusion
    "a divisor": (lambda x, u, p: -x / (2 - u.d), (-1, 1), "asymptotically stable"),
    "a divisor that vanishes": (lambda x, u, p: -x / (1 - u.d), (-1, 1), ""),
    "a root": (lambda x, u, p: -x * (2 - np.sqrt(u.d)), (0, 1), "asymptotically stable"),
    "a root that stops it": (lambda x, u, p: -x * (2 - np.sqrt(u.d)), (0, 4), "stable"),
    "a root that is too large": (lambda x, u, p: -x * (2 - np.sqrt(u.d)), (0, 5), ""),
    "a root of what is negative": (lambda x, u, p: -x * np.sqrt(u.d), (-1, 1), ""),
    "one bound": (lambda x, u, p: -x * (1 + u.d), (0, None), "asymptotically stable"),
    "the other bound": (lambda x, u, p: -x * (1 + u.d), (None, 0), ""),
    "a loss that fades": (lambda x, u, p: -x * u.d, (0, None), "stable"),
    "a divisor that grows": (lambda x, u, p: -x / u.d, (1, None), "square-integrable"),
    "one value": (lambda x, u, p: x * (u.d - 1), (0, 0), "asymptotically stable"),
    "the critical value": (lambda x, u, p: x * (u.d - 1), (1, 1), "stable"),
    "a value too large": (lambda x, u, p: x * (u.d - 1), (2, 2), ""),
}  # fmt: skip


@pytest.mark.parametrize(
    ("rates", "bounds", "conclusion"), IN_BOUNDS.values(), ids=IN_BOUNDS
)
def test_bounds_are_used_for_values(rates, bounds, conclusion):
    verdict = clpt.lyapunov(loop(rates), half, where={"d": bounds})
    assert conclusion_of(verdict) == conclusion, verdict


def test_an_input_of_one_value_stands_as_its_value():
    verdict = clpt.lyapunov(loop(lambda x, u, p: -x * u.d), half, where={"d": (2, 2)})
    assert verdict.sentence.startswith("V' = -2*x**2 <= 0, so the rest is")
    assert verdict.sentence.endswith("; where d = 2")
    rising = clpt.lyapunov(loop(lambda x, u, p: x * u.d), half, where={"d": (2, 2)})
    assert (rising.status, rising.point.u[0]) == ("refuted", 2)


REGIONS = {  # x' = -d x + x^3 falls where x^2 < d
    "a value": (lambda x, u, p: -x * u.d + x**3, (0.25, 0.25), 0.125),
    "bounds": (lambda x, u, p: -x * u.d + x**3, (0.25, 4), 0.125),
    "bounds with 0": (lambda x, u, p: -x * u.d + x**3, (0, 4), None),
    "a push": (lambda x, u, p: -x + x**3 + u.d, (-0.01, 0.01), None),
    "a push of one value": (lambda x, u, p: -x + x**3 + u.d - 1, (1, 1), 0.405),
}


@pytest.mark.parametrize(("rates", "bounds", "level"), REGIONS.values(), ids=REGIONS)
def test_a_region_for_inputs_between_bounds(rates, bounds, level):
    box = {"x": (-0.9, 0.9)}
    verdict = clpt.lyapunov(loop(rates), half, within=box, where={"d": bounds})
    assert (verdict.status == "proved") == (level is not None)
    if level is not None:
        assert 0.995 * level < verdict.level <= level


def test_a_region_takes_no_sets_of_states():
    with pytest.raises(clpt.ClptError, match="bounds of inputs alone"):
        clpt.lyapunov(
            loop(lambda x, u, p: -x),
            half,
            within={"x": (-1, 1)},
            where={"x": (0, None)},
        )


@pytest.mark.parametrize("gain", [1.5, 4.0, 1e3])
def test_the_status_under_a_push_does_not_depend_on_the_seed(gain):
    plant = loop(lambda x, u, p: x * (u.d - gain))
    verdicts = [
        clpt.lyapunov(plant, half, seed=seed, points=1 + seed) for seed in range(4)
    ]
    assert len({(verdict.status, verdict.conclusion) for verdict in verdicts}) == 1


@pytest.mark.parametrize(
    ("low", "status"), [(0, "proved"), (-1, "open")], ids=["kept", "not kept"]
)
def test_a_bounded_input_keeps_a_set(low, status):
    """q' = d - q keeps q >= 0 for d >= 0."""
    plant = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"q": u.d - x.q, "x": -x.q * x.x},
        states={"q": 1, "x": 1},
        inputs={"d": 1},
    )
    where = {"d": (low, 3), "q": (0, None)}
    assert clpt.lyapunov(plant, half, where=where).status == status


@pytest.mark.parametrize(
    ("gain", "status"),
    [
        (lambda t: np.sqrt(1 + t), "proved"),
        (lambda t: np.log(2 + t), "proved"),
        (lambda t: np.sqrt(t - 1), "open"),
        (lambda t: np.log(t + 0.5), "refuted"),
    ],
)
def test_time_that_is_not_negative_has_roots_and_logarithms(gain, status):
    plant = clpt.Block(
        "lag", update=lambda t, x, u, p: {"x": -x.x * gain(t)}, states={"x": 1}
    )
    verdict = clpt.lyapunov(plant, half)
    assert verdict.status == status
    assert verdict.sentence.endswith("for t >= 0") == (status == "proved")


pulled = loop(lambda x, u, p: -(2.0 + u.d) * x)
pushed = loop(lambda x, u, p: -np.tanh(x) - 2 * x + u.d + u.e, inputs={"d": 1, "e": 1})
FILES = {  # loop, V, bounds
    "a lag": (lag, half, {"d": (-1, 3)}),
    "a spring": (spring, crossed, {"d": (-1, 1)}),
    "a cube": (cubic, half, {"d": (-2, 2)}),
    "a product": (pulled, half, {"d": (-1, 1)}),
    "two inputs": (pushed, half, {"d": (-1, 1), "e": (0, 2)}),
    "away from zero": (lag, half, {"d": (2, 3)}),
    "a name of a lemma": (
        loop(lambda x, u, p: -x + u.exp, inputs={"exp": 1}),
        half,
        {"exp": (-1, 0)},
    ),
}
# a text of the file, another one for it
ALTERED = [
    ("a lag", "<= V i t", "<= V i t - 1"),
    ("a lag", "9/2 + (V i 0 - (9/2))", "8/2 + (V i 0 - (8/2))"),
    ("a lag", "Rmax (V i 0) (9/2)", "Rmax (V i 0) (8/2)"),
    ("a lag", "-1 <= r_d t <= 3", "-1 <= r_d t <= 4"),
    ("a lag", "r_d t <= 3", "r_d t <= 3 \\/ True"),
    ("a lag", "(fun t => (r_d t) - (r_x t))", "(fun t => (r_d t) + (r_x t))"),
    ("a spring", "-1 <= r_d t <= 1", "-2 <= r_d t <= 2"),
    ("two inputs", "0 <= r_e t <= 2", "0 <= r_e t <= 3"),
]


def file_of(name):
    system, V, bounds = FILES[name]
    verdict = clpt.lyapunov(system, V, where=bounds)
    return verdict, verdict.coq()


@pytest.mark.parametrize("name", FILES)
def test_file_assumes_the_bounds_and_states_the_level(name):
    verdict, file = file_of(name)
    last = file[file.index("Theorem verdict") :]
    for d, (low, high) in FILES[name][2].items():
        assert f"{low} <= r_{d} t <= {high}" in file
    if verdict.conclusion == "ultimately bounded":
        assert "exp (-" in last
        assert "Rmax (V i 0)" in last
        level = re.search(r"Rmax \(V i 0\) \(([^)]*)\)", last)[1]
        assert float(sympy.Rational(level)) <= verdict.level


@pytest.mark.sampled
@pytest.mark.coq
@pytest.mark.parametrize("name", FILES)
def test_file_compiles(name, tmp_path):
    accepted, axioms = compiled(tmp_path, file_of(name)[1])
    assert accepted
    assert axioms <= REALS


@pytest.mark.sampled
@pytest.mark.coq
@pytest.mark.parametrize(("name", "text", "other"), ALTERED)
def test_altered_file_is_refused(name, text, other, tmp_path):
    _, file = file_of(name)
    start = file.index("Section Loop.")
    altered = file[start:].replace(text, other)
    assert altered != file[start:]
    assert compiled(tmp_path, file[:start] + altered)[0] is False


@pytest.mark.long
def test_letters_of_a_sentence_are_none_of_the_loop():
    """Lorenz with its own r: V comes down to 4 b r^2 s/min(1, b, s)."""
    s, r, b = 10.0, 28.0, 8 / 3
    loop = clpt.Block(
        "lorenz",
        update=lambda t, x, u, p: {
            "x": p.s * (x.y - x.x),
            "y": p.r * x.x - x.y - x.x * x.z,
            "z": x.x * x.y - p.b * x.z,
        },
        states={"x": 1, "y": 1, "z": 1},
        parameters={"s": s, "r": r, "b": b},
    )
    V = lambda s: s.r * s.x**2 + s.s * s.y**2 + s.s * (s.z - 2 * s.r) ** 2  # noqa: E731
    verdict = clpt.lyapunov(loop, V)
    assert "V' <= -r_1 V + c, c = 4*b*r**2*s, r_1 = Min(1, b, s)" in verdict.sentence
    assert "so V comes down to c/r_1" in verdict.sentence
    assert verdict.level == pytest.approx(4 * b * r**2 * s, rel=1e-3)


def test_a_large_level_is_printed_by_its_power():
    lag = clpt.Block(
        "lag",
        update=lambda t, x, u, p: {"x": -x.x + u.d},
        states={"x": 1},
        inputs={"d": 1},
    )
    verdict = clpt.lyapunov(lag, lambda s: s.x**2, where={"d": (-1e30, 1e30)})
    assert "V' <= -V + 1e60, so V comes down to 1e60;" in verdict.sentence
