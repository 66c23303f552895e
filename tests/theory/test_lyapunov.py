"""A Lyapunov function of one's own: right ones are proved, wrong ones never are."""

from functools import partial

import control
import numpy as np
import pytest
import sympy
from lyapunov_cases import CASES, ENERGY, MISSED, PENDULUM, half
from small_scenarios import paper_of
from text_systems import conclusion_of, written

import clpt_control as clpt

lyapunov = partial(clpt.lyapunov, points=50)  # at which the running blocks are called


def fields_of(verdict):
    """The conditions of a verdict: name -> of what."""
    named = {condition.name: condition.of for condition in verdict.conditions}
    named.pop("signs", None)  # tests/theory/test_signs.py
    return named | {"values": ""} if "values" in named else named


EXACT = {  # V' in the user's own signals
    "MRAC": "-4*e**2",
    "backstepping": "-c*x1**2 - c*(c*x1 + h*x1**2 + x2)**2",
    "observer": "-(x1 - x_hat[0])**2 - (x2 - x_hat[1])**2",
    "pendulum": "-omega**2/10",
    "a spinning body": "-(x**2 + y**2 + z**2)/5",
    "van der Pol": "eps*y**2*(x - 1)*(x + 1)",
}
LONG = (  # of a second or so: by `make test-slow`
    "a gradient's flow",
    "a pull of powers without a number",
    "a polynomial that just passes zero",
    "a spring stronger in each interval",
    "backstepping, a term forgotten",
    "wrong in a small region",
    "wrong in a smaller region",
)
MARKS = {
    **{name: [pytest.mark.slow] for name in LONG},
    **{
        name: [pytest.mark.xfail(strict=True, reason=reason)]
        for name, reason in MISSED.items()
    },
}


def test_a_point_that_refutes_is_not_near_the_equilibrium():
    """V' = -v (x + v/5) of V = v^2/2 + x^2 along x'' = -3 x - x'/5."""
    rates = lambda t, x, u, p: [x[1], -3.0 * x[0] - 0.2 * x[1]]  # noqa: E731
    spring = control.nlsys(rates, inputs=0, states=["x", "v"], name="spring")
    found = lyapunov(spring, lambda s: s.v**2 / 2 + s.x**2)
    assert found.status == "refuted"
    assert 1.0 < np.abs(found.point.x).max() <= 1e8
    x, v = found.point.x
    assert found.value == pytest.approx(-v * (x + v / 5))


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=MARKS.get(name, ())) for name in CASES]
)
def test_a_V_is_judged(name):
    case = CASES[name]
    found = lyapunov(case.plant, case.V, **case.more)
    assert found.status == case.status, found.claim
    if case.status == "refuted":
        assert found.value is not None
    else:
        assert found.point is None
    if case.status == "proved":
        assert conclusion_of(found) in case.conclusions
        assert fields_of(found) == case.conditions
    else:
        assert (found.conclusion, found.conditions, found.level) == ("", (), None)
        assert found.failed or found.point
    assert str(found.rate) == EXACT.get(name, str(found.rate))


def test_a_level_that_V_comes_down_to_is_said():
    """V' = -y (y + 1) of V = y^2/2 is at most 1/2 - V."""
    case = CASES["V of an output that is called as its state"]
    found = lyapunov(case.plant, case.V)
    assert found.level == 0.5
    assert found.sentence.endswith("so V comes down to 0.5")


def test_a_point_of_refutation_is_one_of_the_running_blocks():
    case = CASES["van der Pol"]  # half the squares of x
    found = lyapunov(case.plant, case.V)
    t, x, u = found.point
    assert x @ case.plant.dynamics(t, x, u) == pytest.approx(found.value, rel=1e-6)
    assert found.value > 0


def test_V_is_a_name_a_function_or_an_expression():
    plant = written("x' = -2*x")[0]
    x = clpt.equations(plant)["x"]
    assert (
        str(lyapunov(plant, half).rate)
        == str(lyapunov(plant, x**2 / 2).rate)
        == "-2*x**2"
    )
    assert (
        lyapunov(plant, x**2 / 3, claim=-sympy.Rational(4, 3) * x**2).status == "proved"
    )
    half_square = {
        "output": lambda t, x, u, p: u.q**2 / 2,
        "inputs": {"q": 1},
        "outputs": {"V": 1},
    }
    lag = control.tf(1, [1, 2], inputs="w", outputs="q", name="lag")
    meter = clpt.Block("meter", **half_square)
    found = lyapunov(clpt.connect([lag, meter], external="w"), "V")
    assert (found.status, found.inputs) == ("proved", ("w",))
    assert fields_of(found) == {"zero inputs": "w"}


def test_a_claim_is_an_upper_bound():
    """V' = -3 x^2: what is above is true, what is below is refuted at a point."""
    plant = written("x' = -3*x")[0]
    for factor in (3, 2, 0.5):
        found = lyapunov(plant, half, claim=lambda s, k=factor: -k * s.x**2)
        assert found.implies("asymptotically stable")
        assert f"{found.decay}" == f"V(0)*exp({sympy.sympify(f'-{2 * factor:g}*t')})"
    wrong = lyapunov(plant, half, claim=lambda s: -3.0001 * s.x**2)
    assert (wrong.status, str(wrong.rate)) == ("refuted", "-3*x**2")
    assert "V' is above the claim" in wrong.claim
    x = float(wrong.point.x[0])
    assert -3 * x**2 > -3.0001 * x**2


def test_a_claim_of_either_sign_says_no_more_than_it_shows():
    """V' = x^2 <= 2 x^2 is true, and V does not fall."""
    plant = written("x' = x")[0]
    found = lyapunov(plant, half, claim=lambda s: 2 * s.x**2)
    assert (found.status, found.conclusion) == ("proved", "V' is at most the claim")
    assert lyapunov(plant, half).status == "refuted"
    assert lyapunov(plant, half, claim=0).status == "refuted"


def papers_loop(values=None, **gains):
    """The paper's closed loop of one function, its waypoints an input."""
    scenario = paper_of(1, **(values or {}))
    law = clpt.laws()["learned-flow"].of(1, **{"gain": scenario.learning.gain, **gains})
    return clpt.closed_loop(scenario, law=law, external=["zc"])


def eq_24(s):
    off = np.sum((s.alpha + s.theta) ** 2) + np.sum((s.K - s.KD) ** 2)
    return s.e @ s.e / 2 + (off + np.sum((s.Gamma - s.GammaD) ** 2)) / (2 * s.gain)


KNOWN = {"model.parameters": [[0.1], [-0.1]]}  # the model is true, so F is not in x'
NO_BOUND = pytest.mark.xfail(strict=True, reason="exp(-|x|) is not known to be bounded")


@pytest.mark.long
@pytest.mark.parametrize("values", [KNOWN, pytest.param({}, marks=NO_BOUND)])
def test_the_papers_law_is_proved(values):
    """V' = -e^T KD e of Eq. (24), whatever KD is."""
    found = lyapunov(papers_loop(values), eq_24)
    assert str(found.rate) == "-KD[0]*e[0]**2 - KD[1]*e[1]**2"
    assert (found.status, found.conclusion) == ("proved", "goes to zero")
    assert found.inputs == ()
    assert fields_of(found) == {
        "outside V, bounded": "x is",
        "bounded inputs": "zc is",
        "values": "",
    }


@pytest.mark.long
def test_a_wrong_law_of_the_paper_is_refuted():
    wrong = papers_loop(gain=-0.5)
    found = lyapunov(wrong, lambda s: eq_24(s) + s.alpha[0] @ s.alpha[0])
    assert found.status == "refuted"


PLANT, _ = written("x' = -x")
DRIVEN = partial(control.nlsys, lambda t, x, u, p: [x[0] * (u[0] - 1e6)], states=["x"])
TWO = clpt.Block("two", update=lambda t, x, u, p: {"e": -x.e}, states={"e": 2})
MISTAKES = {
    r"V = 'W': is no signal\. It has x": (PLANT, "W"),
    r"V = 'x\*\*2': is no signal\. Give a function in NumPy: lambda s: s\.x\*\*2$": (
        PLANT,
        "x**2",
    ),
    "asks for s.q. It has s.x, s.t": (PLANT, lambda s: s.q**2),
    r"asks for s\[1\]": (PLANT, lambda s: s[1] ** 2),
    "takes one argument": (PLANT, lambda t, x: x[0] ** 2),
    "Signals have names": (PLANT, lambda x: x @ x),
    "which returns a number and no block": (PLANT, lambda s: None),
    "^plant: V is a function of signals here": (PLANT, PLANT),
    "is not a single number": (TWO, "e"),
    r"V: has shape \(2,\); must be one number. two has s.e \(2,\)": (
        TWO,
        lambda s: s.e**2,
    ),
    "has no q as clpt": (PLANT, sympy.Symbol("q") ** 2),
    "V.output: .*'zeta'": (PLANT, sympy.zeta(sympy.Symbol("x", real=True))),
    "has no states": (
        control.nlsys(None, lambda t, x, u, p: u, inputs=1, outputs=1),
        "y",
    ),
    "at = {'x': nan}: must be": (PLANT, half, {"at": {"x": np.nan}}),
    "points = 0: must be a whole number, 1 or": (PLANT, half, {"points": 0}),
    "as they are x' has no value": written("x' = -x/k; k = 0"),
    "leave `claim` out": (PLANT, half, {"claim": 0, "within": {"x": (-1, 1)}}),
    **{
        f"has a {name}, as time, V or a function is called": (
            DRIVEN(inputs=[name]),
            half,
        )
        for name in ("t", "V", "sign", "inside", "clip", "Abs")
    },
}


@pytest.mark.parametrize("said", MISTAKES)
def test_a_mistake_is_one_sentence(said):
    plant, V, *more = MISTAKES[said]
    with pytest.raises(clpt.ClptError, match=said):
        lyapunov(plant, V, **dict(*more))


def test_a_result_says_itself():
    found = lyapunov(*written(f"{PENDULUM}; {ENERGY}"))
    assert repr(found) == (
        "<Verdict proved: V' = -omega**2/10 <= 0, so every run comes to rest and "
        "omega, sin(theta) go to zero; where g > 0>"
    )
    assert "sampled" in found._repr_html_()


@pytest.mark.long
def test_a_limit_at_infinity_is_none():
    loop = clpt.connect([clpt.parts.pid(1, 0.1), clpt.parts.lag(10.0)], external="r")
    assert not any(
        rate.has(sympy.oo)
        for port in clpt.equations(loop).rates.values()
        for rate in port.flat
    )
    assert lyapunov(loop).status == "proved"  # it is linear and stable
    assert (
        str(clpt.equations(clpt.parts.saturation(0.0, np.inf)))
        == "y = maximum(u(t), low)"
    )


def test_a_linear_system_says_nothing_of_params():
    """Nor is a number that is too large a warning of NumPy's: here each would be an error."""
    lag = control.ss([[0, 1], [-1, -2]], [[0], [1]], [[1, 0]], 0, name="lag")
    found = lyapunov(lag)
    assert found.implies("asymptotically stable")
    assert fields_of(found)["zero inputs"] == "u"
    plant, V = written(
        "a' = -a - (exp(a)*a*b + exp(b)*a**3); b' = -b + (exp(a)*a**2 + exp(b)*a*b); "
        "V = a**2 + b**2 + 0.1*a**4"
    )
    found = lyapunov(plant, V, within=dict.fromkeys("ab", (-0.5, 0.5)))
    assert found.conclusion == "asymptotically stable in a region"


def test_a_difference_of_an_increasing_function_is_read():
    """(x - y)(exp(x) - exp(y)) >= 0: exp increases."""

    def pulled(t, x, u, p):
        pull = np.exp(x[0]) - np.exp(x[1])
        return [-pull - x[0], pull - x[1]]

    plant = control.nlsys(
        pulled, None, states=["x", "y"], inputs=0, outputs=["x", "y"], name="plant"
    )
    found = clpt.lyapunov(plant, lambda s: (s.x**2 + s.y**2) / 2, points=20)
    assert found.status == "proved"


@pytest.mark.parametrize(
    ("text", "root"),  # where V' = 0 farthest from the rest
    [
        ("x' = 2*x - x**3", 2**0.5),
        ("x' = 8 - x**3", 2.0),
        ("x' = x + 2*x**2 - x**3", 1 + 2**0.5),
        ("x' = -(x**2 - 1)*(x**2 - 4)*(x**2 - 9)*x", 3.0),
        ("x' = 1e6*x - 1e4*x**3", 10.0),
        ("x' = a*x - b*x**3; a = 3; b = 0.5", 6**0.5),
        ("y' = 4*(y - 1) - (y - 1)**3; V = (y - 1)**2/2; at y = 1", 2.0),
        ("x' = -y - x; y' = x + 8 - y**3; V = (x**2 + y**2)/2", None),
    ],
)
def test_a_polynomial_of_one_state_comes_down_to_its_farthest_root(text, root):
    plant, V, *rest = written(text)
    found = clpt.lyapunov(plant, V, **dict(*rest))
    assert (found.status, found.conclusion) == ("proved", "ultimately bounded")
    if root:
        assert root**2 / 2 * (1 - 1e-9) <= found.level <= root**2 / 2 * 1.002


@pytest.mark.parametrize(
    ("rate", "V"),
    [
        (lambda t, x, u, p: [-x[0]], lambda s: -np.log(1 - s.x**2)),
        (lambda t, x, u, p: [1 - x[0]], lambda s: s.x - np.log(s.x)),
    ],
)
def test_no_point_refutes_where_V_has_no_value(rate, V):
    """Right barriers, of which V' is positive where the logarithm has no value."""
    loop = control.nlsys(rate, states=["x"], inputs=0, name="loop")
    assert clpt.lyapunov(loop, V).status == "open"
