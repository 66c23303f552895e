"""A Lyapunov function of one's own: right ones are proved, wrong ones never are."""

from functools import partial

import control
import numpy as np
import pytest
import sympy
from lyapunov_cases import CASES, ENERGY, PENDULUM, half
from text_systems import written

import clpt_control as clpt
from clpt_control import lyapunov as judge
from clpt_control.paper.laws.table import LAWS
from clpt_control.theory.proofs import point_search
from clpt_control.theory.proofs.exact import factored
from clpt_control.theory.proofs.sums_of_squares import squares
from clpt_control.theory.proofs.theorem_loop import theorem_loop

lyapunov = partial(judge, points=50)  # at which the running blocks are called


EXACT = {  # V' in the user's own signals
    "MRAC": "-4*e**2",
    "backstepping": "-c*x1**2 - c*(c*x1 + h*x1**2 + x2)**2",
    "observer": "-(x1 - x_hat[0])**2 - (x2 - x_hat[1])**2",
    "pendulum": "-omega**2/10",
    "a spinning body": "-(x**2 + y**2 + z**2)/5",
    "van der Pol": "eps*y**2*(x - 1)*(x + 1)",
    "V of an arm, no sum of squares": "-v1**2 - v2**2",  # its masses divide by 2 - cos(q2)^2
}
LONG = ("no value at a point", "a pull of powers without a number", "a needle")


def test_a_point_that_refutes_is_not_near_the_equilibrium():
    """V' = -v (x + v/5) of V = v^2/2 + x^2 along x'' = -3 x - x'/5."""
    rates = lambda t, x, u, p: [x[1], -3.0 * x[0] - 0.2 * x[1]]  # noqa: E731
    spring = control.nlsys(rates, inputs=0, states=["x", "v"], name="spring")
    found = lyapunov(spring, lambda s: s.v**2 / 2 + s.x**2)
    assert found.status == "refuted"
    assert 1.0 < np.abs(found.point.x).max() <= point_search.LARGE_STATE
    x, v = found.point.x
    assert found.value == pytest.approx(-v * (x + v / 5))


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n in LONG else n for n in CASES]
)
def test_a_V_is_judged(name, monkeypatch):
    status, plant, V, *more = CASES[name]
    if status == "open":  # no point refutes it, and few draws look for one
        monkeypatch.setattr(point_search, "SEARCHES", 4)
    found = lyapunov(plant, V, **dict(*more))
    if status == "refuted":
        assert found.status.startswith(status), found.claim
        assert found.value is not None
    else:
        assert found.status == status, found.claim
    if status == "proved":
        assert found.point is None
        assert all(step.holds for step in found.steps)
    assert str(found.rate) == EXACT.get(name, str(found.rate))


def test_a_point_of_refutation_is_one_of_the_running_blocks():
    _, plant, V = CASES["van der Pol"]  # half the squares of x
    found = lyapunov(plant, V)
    t, x, u = found.point
    assert x @ plant.dynamics(t, x, u) == pytest.approx(found.value, rel=1e-6)
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
    found = lyapunov(
        clpt.connect([lag, clpt.Block("meter", **half_square)], external="w"), "V"
    )
    assert (found.status, found.inputs) == ("proved where w = 0", ("w",))


def test_a_claim_is_compared_exactly():
    plant = written("x' = -3*x")[0]
    assert lyapunov(plant, half, claim=lambda s: -3 * s.x**2).status == "proved"
    wrong = lyapunov(plant, half, claim=lambda s: -3.0001 * s.x**2)
    assert (wrong.status, str(wrong.rate)) == ("refuted", "-3*x**2")
    assert "not as claimed" in wrong.claim


SUMS = "x**2 + x*y + y**2; (y + x**3)**2 + x**2; k*(1 - cos(x)) + y**2; exp(x) - x - 1"
RISING = "x**2*exp(-y); x*atan(x) - log(1 + x**2)/2"
NO_SUMS = "x**2 + 3*x*y + y**2; x**4 - 2*x**3 + 0.999*x**2; x**3; x**2*y**2 - x*y"


@pytest.mark.parametrize("chance", [1, 12, 16])
def test_what_has_no_factors_is_told_whatever_places_sympy_draws(chance):
    """With SymPy's own few places it took minutes or more after these."""
    a, b, c, x, y = sympy.symbols("a b c x y", real=True)
    of_x = (x**2 - 1) * (180 * x**2 - 200 * x * a - 189 * x * sympy.tanh(x))
    of_y = y * (b * y * (55 * y * sympy.cos(y) + 110 * sympy.sin(y) + 220))
    of_y += y * c * (50 * y * sympy.cos(y) + 100 * sympy.sin(y) + 200)
    whole = sympy.expand(of_x - of_y * sympy.exp(x**2))
    sympy.core.cache.clear_cache()
    sympy.core.random.seed(chance)
    assert sympy.expand(factored(whole) - whole) == 0


@pytest.mark.parametrize("text", f"{SUMS}; {RISING}; {NO_SUMS}".split("; "))
def test_sums_of_squares(text):
    names = {s: sympy.Symbol(s, real=True) for s in "xy"} | {
        "k": sympy.Symbol("k", positive=True)
    }
    V = sympy.nsimplify(sympy.sympify(text, locals=names), rational=True)
    found = squares(V, {names["k"]})
    assert (found is None) == (text in NO_SUMS.split("; "))
    if found is not None:
        assert sympy.simplify(sympy.Add(*found.terms) + found.constant - V) == 0
        random = np.random.default_rng(0)
        at = [
            dict(zip(names.values(), abs(random.normal(size=3)), strict=True))
            for _ in range(50)
        ]
        assert (
            min([float(term.subs(one)) for one in at for term in found.terms]) > -1e-9
        )


def test_the_papers_law_is_proved():
    loop = theorem_loop(2, "learned-flow")
    found = lyapunov(loop, "V")
    assert (found.status, found.inputs) == ("proved", ())
    KD = next(
        part for part in loop.syslist if part.name == "vehicle_controller"
    ).parameters.KD
    e = sympy.symbols("e[0] e[1]", real=True)
    wanted = -sum(sympy.Rational(str(k)) * one**2 for k, one in zip(KD, e, strict=True))
    assert sympy.expand(found.rate - wanted) == 0
    wrong = theorem_loop(
        2, "learned-flow", law_block=LAWS["learned-flow"].of(2, gain=-0.5)
    )
    assert lyapunov(wrong, "V").status == "refuted"


PLANT, _ = written("x' = -x")
DRIVEN = partial(control.nlsys, lambda t, x, u, p: [x[0] * (u[0] - 1e6)], states=["x"])
MISTAKES = {
    "has no 'W'": (PLANT, "W"),
    "no port 'q'": (PLANT, lambda s: s.q**2),
    "which returns a number and no block": (PLANT, lambda s: None),
    "is not a single number": (theorem_loop(1, "learned-flow"), "e"),
    "has no q as clpt": (PLANT, sympy.Symbol("q") ** 2),
    "V.output: .*'zeta'": (PLANT, sympy.zeta(sympy.Symbol("x", real=True))),
    "has no states": (
        control.nlsys(None, lambda t, x, u, p: u, inputs=1, outputs=1),
        "y",
    ),
    "at = {'x': nan}: must be": (PLANT, half, {"at": {"x": np.nan}}),
    "points = 0: must be a whole number, 1 or": (PLANT, half, {"points": 0}),
    "as they are x' has no value": written("x' = -x/k; k = 0"),
    "discrete time": (control.ss(0.5, 1, 1, 0, dt=True), half),
    **{
        f"has a {name}, as time or a function is called": (DRIVEN(inputs=[name]), half)
        for name in ("t", "sign", "inside", "clip", "Abs")
    },
}


@pytest.mark.parametrize("said", MISTAKES)
def test_a_mistake_is_one_sentence(said):
    plant, V, *more = MISTAKES[said]
    with pytest.raises(clpt.ClptError, match=said):
        lyapunov(plant, V, **dict(*more))


def test_a_result_says_itself():
    found = lyapunov(*written(f"{PENDULUM}; {ENERGY}"))
    assert repr(found).startswith(
        "<Verdict proved: V' = -omega**2/10 <= 0; V is positive"
    )
    assert "sampled" in found._repr_html_()


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
    assert lyapunov(lag).status == "proved where u = 0"
    plant, V = written(
        "a' = -a - (exp(a)*a*b + exp(b)*a**3); b' = -b + (exp(a)*a**2 + exp(b)*a*b); "
        "V = a**2 + b**2 + 0.1*a**4"
    )
    found = lyapunov(plant, V, within=dict.fromkeys("ab", (-0.5, 0.5)))
    assert found.status == "proved in a region"
