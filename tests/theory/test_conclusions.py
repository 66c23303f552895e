"""Conclusions and conditions of verdicts: LaSalle, Barbalat, levels, discrete time."""

import re

import control
import numpy as np
import pytest
from model_reference import V, gradient, leaky, leaky_with_error, loop
from small_scenarios import paper_of
from text_systems import conclusion_of, signals, written

import clpt_control as clpt
from clpt_control import Block, lyapunov, prove

POINTS = 50


def fields_of(verdict):
    """Status, conclusion, and conditions: name -> of what."""
    conditions = {condition.name: condition.of for condition in verdict.conditions}
    return verdict.status, verdict.conclusion, conditions


def of(text, **more):
    """Judge what is written."""
    plant, level, *rest = written(text)
    return lyapunov(plant, level, points=POINTS, **dict(*rest), **more)


def missing(reason):
    """Mark what is right and is not done yet."""
    return pytest.mark.xfail(strict=True, reason=reason)


# --- LaSalle: exactly, of polynomials and sines --------------------------------------------------

ENERGY = "V = w**2/2 + k*(1 - cos(th))"
SPRINGS = "x' = v; v' = -x - c*v; c = 0.3"
CHAIN = "x' = v; p' = q; v' = p - 2*x - v; q' = x - 2*p"
LASALLE = {  # the text, its conclusion, what goes to zero
    "a pendulum": (
        f"th' = w; w' = -k*sin(th) - 0.3*w; k = 9.8; {ENERGY}",
        "comes to rest", "w, sin(th) go",
    ),
    "a mass, a spring and a damper": (SPRINGS, "asymptotically stable", "v, x go"),
    "two masses, one damper": (  # the spring between them lets nothing swing
        f"{CHAIN}; V = (v**2 + q**2)/2 + x**2 + p**2 - x*p", "asymptotically stable", None,
    ),
    "two masses, a damper between": (  # what both do alike is not damped
        "x' = v; p' = q; v' = -x - (v - q); q' = -p - (q - v)", "goes to zero", None,
    ),
    "a damper that a parameter takes away": (  # c = 0
        "x' = v; v' = -x - c*v; c = 0", "stable", "",
    ),
    "a cubic damper": ("x' = v; v' = -x - v**3", "asymptotically stable", "v, x go"),
    "an adaptive gain without reference": (
        "e' = -e - k*e; k' = e**2", "comes to rest", "e goes",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", LASALLE)
def test_what_is_left_where_V_stands_still(name):
    text, conclusion, going = LASALLE[name]
    found = of(text)
    assert (found.status, found.conclusion) == ("proved", conclusion)
    assert found.of == (found.of if going is None else going)
    rests = [
        step for step in found.steps if "V' = 0 for good nothing moves" in step.claim
    ]
    assert bool(rests) == (conclusion in ("asymptotically stable", "comes to rest"))
    assert all(step.how == "exact" and step.holds for step in rests)


@pytest.mark.parametrize(
    "name", ["a mass, a spring and a damper", "two masses, one damper"]
)
def test_a_run_comes_to_the_rest_that_is_proved(name):
    plant, _ = written(LASALLE[name][0])
    start = [1.0, -0.5, 0.3, 0.2][: plant.nstates]
    last = clpt.simulate(plant, [0.0, 200.0], 0, start).states[-1]
    assert np.abs(last).max() < 1e-6


def test_in_a_box_the_energy_is_enough():
    """Where V' = -w^2 alone; V of the edge, 1 - cos(2), is the highest level."""
    box = {"th": (-2, 2), "w": (-2, 2)}
    text = f"th' = w; w' = -k*sin(th) - w; k = 1; {ENERGY}"
    found = of(text, within=box)
    assert (found.status, found.conclusion) == (
        "proved",
        "asymptotically stable in a region",
    )
    assert 0.99 * (1 - np.cos(2)) < found.level <= 1 - np.cos(2)


# --- Barbalat: e' is bounded ---------------------------------------------------------------------


def slope(t):
    """The slope of pulses that become narrower, which is not bounded."""
    q = t**2 * np.sin(np.pi * t)
    dq = 2 * t * np.sin(np.pi * t) + np.pi * t**2 * np.cos(np.pi * t)
    return 8 / (1 + q**2) - 8 * (1 + t) * 2 * q * dq / (1 + q**2) ** 2


def pulsed(beyond, **parameters):
    """Make a law with alpha = a + s(t) b D phi^T, D what of e is beyond: V' = -D^T KD e."""

    def update(t, x, u, p):
        D, g = beyond(u.e, p), p.gain
        return {
            "a": -g * np.outer(D, u.phi_x),
            "k": -g * u.z * D,
            "G": g * u.zc * D,
            "b": -g * slope(t) * (D @ D) * (u.phi_x @ u.phi_x),
        }

    def output(t, x, u, p):
        pulse = slope(t) * x.b[0] * np.outer(beyond(u.e, p), u.phi_x)
        return {"alpha": x.a + pulse, "K": x.k, "Gamma": x.G, "a": x.a, "b": x.b}

    def level(v):
        D = beyond(v.e, v)
        off = np.sum((v.theta + v.a) ** 2) + np.sum((v.K - v.KD) ** 2)
        off += np.sum((v.Gamma - v.GammaD) ** 2) + v.b @ v.b
        return D @ D / 2 + off / (2 * v.gain)

    law = Block(
        "own",
        update=update,
        output=output,
        parameters={"gain": 0.5, **parameters},
        sizes={"N": 2},
        inputs={"e": 2, "phi_x": "N", "z": 2, "zc": 2},
        states={"a": (2, "N"), "k": 2, "G": 2, "b": 1},
        outputs={"alpha": (2, "N"), "K": 2, "Gamma": 2, "a": (2, "N"), "b": 1},
    )
    return law, level


@pytest.mark.long
def test_narrower_pulses_leave_an_integral():
    """CLPE of a run comes back to 2 m in each 12 s, `shared/cases/theory/t1_barbalat`."""
    found = prove(*pulsed(lambda e, p: e), points=POINTS)
    assert (found.status, found.conclusion) == ("proved", "square-integrable")
    assert "so the integral of e^T KD e is at most V(0)" in found.sentence
    (step,) = found.failed[-1:]
    assert step.claim == "the rate of CLPE is bounded where V is"
    assert "it holds t, not known to be bounded" in step.detail


@pytest.mark.long
def test_narrower_pulses_come_to_no_zone():
    """The same with a dead zone of 0.1."""
    zone = np.array([0.1, 0.1])
    beyond = lambda e, p: e - np.clip(e, -p.zone, p.zone)  # noqa: E731
    found = prove(*pulsed(beyond, zone=zone), points=POINTS)
    assert found.conclusion != "comes to a zone"


def test_what_an_input_weighs_goes_to_zero_where_its_rate_is_bounded():
    """Of ever narrower pulses r, height 1, th stays and th r comes back to th."""
    found = of("th' = -r**2*th; input r")
    assert (found.status, found.conclusion) == ("proved", "square-integrable")


@pytest.mark.parametrize(
    ("gain", "weight"),
    [("(2 + sin(t))", "e**2/2"), ("(2 - exp(-t))", "e**2/2"), ("(1 + t)", "e**2/2")],
)
def test_an_integral_does_not_need_a_bounded_rate(gain, weight):
    """V' = -gain e^2; with 1 + t the rate of e is not bounded where V is, and e falls still."""
    found = of(f"e' = -{gain}*e; V = {weight}")
    assert found.implies("asymptotically stable")
    assert fields_of(found)[2] == {"t >= 0": ""}


# --- levels and means ----------------------------------------------------------------------------


def fading(t, x, u, p):
    """A leak that fades: nothing pulls K back in the end."""
    k = 0.1 * np.exp(-t)
    return {
        "alpha": -p.gain * np.outer(u.e, u.phi_x) - k * x.alpha,
        "K": -p.gain * u.z * u.e - k * x.K,
        "Gamma": p.gain * u.zc * u.e - k * x.Gamma,
    }


@pytest.mark.long
def test_where_a_mean_is_known_no_level_is_said():
    law = Block(
        "own",
        update=fading,
        inputs={"e": 2, "phi_x": "N", "z": 2, "zc": 2},
        states={"alpha": (2, "N"), "K": 2, "Gamma": 2},
        parameters={"gain": 0.8},
        sizes={"N": 1},
    )
    found = prove(law, points=POINTS)
    assert (found.status, found.conclusion) == ("proved", "bounded in the mean")
    assert found.level is None
    assert "for t >= 0" in found.sentence


def test_the_package_s_own_loop_with_a_known_flow_is_taken():
    found = prove(clpt.closed_loop(paper_of(1, "known-flow")), points=POINTS)
    assert (found.status, found.conclusion) == ("proved", "bounded in the mean")


SOON = ("learned-flow", "sigma", "projection", "kalman-flow", "composite-least-squares")


def marks_of(name):
    """Mark a law whose own loop is refused, and all but a few as slow."""
    reason = "its parameters have other signs than its row's, and then other names"
    marks = [] if name in SOON else [pytest.mark.slow]
    return [*marks, *[missing(reason)] * (name == "composite-least-squares")]


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=marks_of(name)) for name in clpt.laws()]
)
def test_each_law_of_the_table_is_proved_in_its_own_loop(name):
    found = prove(clpt.closed_loop(paper_of(1, name)), points=POINTS)
    assert found.status == "proved"


@pytest.mark.long
@pytest.mark.parametrize("sigma", [0.1, 1.0])
def test_a_leak_in_an_own_loop_has_a_level(sigma):
    """V' <= -am e^2 + sigma b (kr kr* + ky ky* - kr^2 - ky^2): V <= push/rate in the end."""
    found = lyapunov(loop(leaky, sigma=sigma), V, points=POINTS)
    assert (found.status, found.conclusion) == ("proved", "ultimately bounded")
    a, b, am, bm, gamma = 1.0, 3.0, 4.0, 4.0, 2.0
    ideal = (bm / b) ** 2 + ((am + a) / b) ** 2
    push, rate = sigma * b * ideal / 2, min(gamma * sigma, am)
    assert float(found.level) == pytest.approx(push / rate, rel=1e-3)
    assert float(found.level) >= push / rate  # rounded outward


def test_no_run_of_the_leak_stays_above_its_level():
    plant, level = loop(leaky, sigma=0.1), 3.4167
    t = np.linspace(0, 200, 2001)
    run = clpt.simulate(plant, t, np.sign(np.sin(t)), [5.0, 0.0, 4.0, -3.0])
    y, ym, kr, ky = run.states.values.T
    values = (y - ym) ** 2 / 2 + 0.75 * ((kr - 4 / 3) ** 2 + (ky - 5 / 3) ** 2)
    assert values[0] > level
    assert values[len(t) // 2 :].max() <= level


@pytest.mark.long
@pytest.mark.parametrize("nu", [0.1, 3.0])
def test_a_leak_that_e_weighs_has_a_ceiling(nu):
    """V' <= -|e| (am |e| + nu b |k - k*|^2/2 - c), c = nu b |k*|^2/2: the corners bound V."""
    found = lyapunov(loop(leaky_with_error, nu=nu), V, points=POINTS)
    status, conclusion, conditions = fields_of(found)
    assert (status, conclusion) == ("proved", "bounded")
    assert "zero inputs" not in conditions
    b, am, gamma, ideal = 3.0, 4.0, 2.0, (4**2 + 5**2) / 9
    c = nu * b * ideal / 2
    level = max(c**2 / (2 * am**2), b * ideal / (2 * gamma))
    assert level <= float(found.level) == pytest.approx(level, rel=1e-3)


def test_where_e_weighs_a_leak_V_falls_above_the_ceiling():
    plant, level = loop(leaky_with_error, nu=3.0), 13.2
    random = np.random.default_rng(2)
    points = random.normal(size=(4000, 5)) * 10 ** random.uniform(-1, 1, (4000, 1))
    points[::2, 1] = points[::2, 0] + 0.3 * random.normal(size=2000)  # e is small
    for *x, r in points:
        y, ym, kr, ky = x
        dy, dym, dkr, dky = plant.dynamics(0, x, [r])
        e, off = y - ym, (kr - 4 / 3, ky - 5 / 3)
        value = e**2 / 2 + 0.75 * (off[0] ** 2 + off[1] ** 2)
        slope = e * (dy - dym) + 1.5 * (off[0] * dkr + off[1] * dky)
        assert value < level or slope <= 1e-9 * (1 + value)


@pytest.mark.long
def test_what_e_adds_to_the_gains_is_refuted():
    plant = loop(leaky_with_error, nu=-0.1)
    found = lyapunov(plant, V, points=POINTS)
    assert found.status == "refuted"
    (y, ym, kr, ky), (dy, dym, dkr, dky) = found.point.x, plant.dynamics(*found.point)
    slope = (y - ym) * (dy - dym) + 1.5 * ((kr - 4 / 3) * dkr + (ky - 5 / 3) * dky)
    assert slope == pytest.approx(found.value, rel=1e-6)
    assert slope > 0


# --- claims --------------------------------------------------------------------------------------


@pytest.mark.long
@pytest.mark.parametrize("share", [1.0, 0.5, 0.1])
def test_a_claim_that_is_weaker_is_proved(share):
    claim = lambda s: -share * s.am * (s.y - s.ym) ** 2  # noqa: E731
    found = lyapunov(loop(gradient), V, claim=claim, points=POINTS)
    assert (found.status, found.conclusion) == ("proved", "goes to zero")


@pytest.mark.long
def test_the_exact_rate_of_a_leak_is_no_wrong_claim():
    def rate(s):
        apart = s.kr * (s.kr - s.bm / s.b) + s.ky * (s.ky - (s.am + s.a) / s.b)
        return -s.am * (s.y - s.ym) ** 2 - s.sigma * s.b * apart

    found = lyapunov(loop(leaky, sigma=0.1), V, claim=rate, points=POINTS)
    assert (found.status, found.conclusion) == ("proved", "ultimately bounded")


# --- conditions ----------------------------------------------------------------------------------


def test_a_search_whose_V_misses_a_state_is_open():
    double = control.ss([[0, 1], [0, 0]], [[0], [1]], [[1, 0]], 0, name="double")
    found = lyapunov(double)
    assert (found.status, found.conclusion) == ("open", "")
    assert found.claim.startswith("no V was found, with u = 0, that is proved")


@pytest.mark.sampled
@pytest.mark.parametrize("lag", [1.0, 1.9])
def test_a_delay_is_said_to_be_a_stand_in(lag):
    """x' = -x(t - 1.9) leaves its rest, beyond pi/2; its Pade approximation does not."""
    late = clpt.parts.delay(lag, 1)
    names = {"inputs": late.output_labels[0], "outputs": late.input_labels[0]}
    found = lyapunov(
        clpt.connect([control.ss(0, -1, 1, 0, name="plant", **names), late])
    )
    assert found.status == "proved"
    assert "of the Padé approximation of order 1" in found.sentence


def test_time_is_said_to_be_positive():
    found = of("x' = -t*x; V = x**2")
    assert (found.status, fields_of(found)[2]) == ("proved", {"t >= 0": ""})
    assert "for t >= 0" in found.sentence


@pytest.mark.long
def test_a_V_that_a_state_leaves_is_not_refuted():
    """From 0 to 1 V' = -2 x^2 - (1 - t^2) y^2; after t = 1 V is x^2 alone, and y grows."""
    plant, _ = written("x' = -x; y' = y/2")
    level = lambda s: s.x**2 + (np.clip(1 - s.t, 0, 1) * s.y) ** 2  # noqa: E731
    found = lyapunov(plant, level, points=POINTS)
    assert found.status in ("open", "proved")
    assert found.conclusion not in ("asymptotically stable", "stable", "comes to rest")


def test_a_folder_of_another_package_changes_nothing(tmp_path, monkeypatch):
    (tmp_path / "z3").mkdir()
    monkeypatch.syspath_prepend(tmp_path)
    plant, _ = written("x' = -x")
    found = lyapunov(plant, lambda s: np.sqrt(np.abs(s.x)), points=POINTS)
    assert found.status in ("open", "proved")


def test_a_bound_is_not_rounded_beyond_what_was_asked():
    found = clpt.certify(clpt.paper_scenario(), 0.05, error=0.01)
    assert found.said.startswith("CLPE is at most 0.01 m after ")


# --- right ones ----------------------------------------------------------------------------------

SQUARES = signals(None, ["x", "y"])
MOTZKIN = "x**4*y**2 + x**2*y**4 + 1 - 3*x**2*y**2"
STRONGER = {  # the strongest true conclusion, and what is shown at least
    "a gain of 2 - exp(-t)": (
        "e' = -e + th*r; th' = -(2 - exp(-t))*e*r; V = e**2 + th**2/(2 - exp(-t)); input r",
        "goes to zero", None,
    ),
    "a sum of squares of degree 6": (
        "x' = -x**5; y' = -y**5; V = x**6 + y**6 - x**3*y**3", "asymptotically stable", None
    ),
    "a power of 1.5": ("x' = -x; V = abs(x)**1.5", "asymptotically stable", None),
    "the larger of two": (
        "x' = -x; y' = -y; V = maximum(abs(x), abs(y))", "asymptotically stable", "stable"
    ),
    "the sum of two sizes": (
        "x' = -2*x + y; y' = -2*y + x; V = abs(x) + abs(y)", "asymptotically stable", None
    ),
    "Motzkin's polynomial": (  # zero at |x| = |y| = 1, where V' = -y^2
        f"x' = -x*({MOTZKIN}); y' = -y", "asymptotically stable", "stable"
    ),
    "a control that is limited": (
        "x' = y; y' = -clip(x, -1, 1) - y; "
        "V = y**2/2 + where(abs(x) <= 1, x**2/2, abs(x) - 0.5)",
        "asymptotically stable", None,
    ),
}  # fmt: skip
WEAKER = {
    "asymptotically stable": ("comes to rest", "goes to zero", "stable"),
    "comes to rest": ("stable",),
    "goes to zero": ("stable",),
}


@pytest.mark.parametrize("name", STRONGER)
def test_a_right_V_is_proved(name):
    text, strongest, least = STRONGER[name]
    found = of(text)
    assert found.status == "proved"
    weaker = WEAKER[strongest] if least else ()
    assert conclusion_of(found) in (strongest, *weaker)


@pytest.mark.sampled
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=missing("a weaker conclusion is shown"))
        for name, (_, strongest, least) in STRONGER.items()
        if least not in (None, strongest)
    ],
)
def test_the_strongest_conclusion_is_shown(name):
    text, strongest, _ = STRONGER[name]
    assert of(text).conclusion == strongest


IN_A_BOX = {
    "a cube": ("x' = -x**3; V = x**2", 1.0),
    "V of a fourth power": ("x' = -x; V = x**4", 1.0),
    "a sign": ("x' = -sign(x); V = x**2", 1.0),
    "an adaptive cube": ("x' = -x + x**2; V = x**2", 1.0),
}


@pytest.mark.parametrize("name", IN_A_BOX)
def test_in_a_box_the_level_is_that_of_the_edge(name):
    text, level = IN_A_BOX[name]
    found = of(text, within={"x": (-1, 1)})
    assert (found.status, found.conclusion) == (
        "proved",
        "asymptotically stable in a region",
    )
    assert 0.99 * level <= found.level <= level


# --- discrete time -------------------------------------------------------------------------------


def stepped(update, states, inputs=0, **params):
    """A system of discrete time."""
    more = {"inputs": inputs, "params": params, "dt": 0.1, "name": "steps"}
    return control.nlsys(
        lambda t, x, u, p: update(x, u, p), states=[*states], outputs=[*states], **more
    )


STEPS = {  # x(t + dt), its states, V' = V(x+) - V(x), and what follows
    "half": (lambda x, u, p: [x[0] / 2], "x", "-3*x**2/4", "asymptotically stable"),
    "a turn": (lambda x, u, p: [-x[0]], "x", "0", "stable"),
    "a turn of two": (lambda x, u, p: [x[1], -x[0] / 2], "xy", "-3*x**2/4",
                      "asymptotically stable"),  # where x = 0 for good y = 0
    "one turns on": (lambda x, u, p: [x[0] / 2, -x[1]], "xy", "-3*x**2/4", "goes to zero"),
}  # fmt: skip


@pytest.mark.parametrize("name", STEPS)
def test_what_V_loses_in_a_step(name):
    update, states, change, conclusion = STEPS[name]
    system = stepped(update, states)
    level = lambda s: sum(getattr(s, one) ** 2 for one in states)  # noqa: E731
    found = lyapunov(system, level, points=POINTS)
    assert str(found.rate) == change
    assert fields_of(found) == ("proved", conclusion, {"steps": ""})
    x = np.random.default_rng(1).normal(size=len(states))
    after = system.dynamics(0, x, [])
    values = dict(zip(states, x, strict=True))
    wanted = after @ after - x @ x
    at = {s: values[s.name] for s in found.rate.free_symbols}
    assert float(found.rate.subs(at)) == pytest.approx(wanted, abs=1e-12)


def test_a_level_in_discrete_time():
    """x+ = x/2 + 1 comes to 2, V = 4: V(x+) - V <= -3/8 V + 5/3."""
    found = lyapunov(stepped(lambda x, u, p: [x[0] / 2 + 1], "x"), lambda s: s.x**2)
    assert (found.status, found.conclusion) == ("proved", "ultimately bounded")
    assert 4.0 <= float(found.level) < 5.0


def test_a_state_beside_V_grows_in_discrete_time():
    plant = stepped(lambda x, u, p: [x[0] / 2, 3 * x[1]], "xy")
    found = lyapunov(plant, lambda s: s.x**2)
    conditions = {"steps": "", "outside V": "y is"}
    assert fields_of(found) == ("proved", "goes to zero", conditions)


@pytest.mark.parametrize("factor", [1.1, -1.01])
def test_what_grows_in_discrete_time_is_refuted(factor):
    plant = stepped(lambda x, u, p: [p["a"] * x[0]], "x", a=factor)
    found = lyapunov(plant, lambda s: s.x**2)
    assert found.status == "refuted"
    (x,), (after,) = found.point.x, plant.dynamics(*found.point)
    assert after**2 - x**2 == pytest.approx(found.value)


def test_a_step_that_an_input_makes_too_long_is_refuted():
    """1 - 2.5 r^2/(1 + r^2) comes to -1.5."""
    rates = lambda x, u, p: [x[0] - p["g"] * u[0] ** 2 / (1 + u[0] ** 2) * x[0]]  # noqa: E731
    for g, status in ((1.0, "proved"), (2.5, "refuted")):
        plant = stepped(rates, "x", ["r"], g=g)
        assert lyapunov(plant, lambda s: s.x**2).status == status


@pytest.mark.parametrize(
    "level", [lambda s: s.x**2 * (1 + s.t), lambda s: (s.x - s.w) ** 2]
)
def test_a_V_of_time_or_inputs_is_refused_in_discrete_time(level):
    plant = stepped(lambda x, u, p: [x[0] / 2 + u[0]], "x", ["w"])
    with pytest.raises(clpt.DiagramError, match="give a V of its states alone"):
        lyapunov(plant, level)


def test_a_sampled_law_is_judged_in_discrete_time():
    """x+ = x + h b (k y), a gain that adapts by a normalised step, e = a x - k x."""

    def update(x, u, p):
        """The error of a gain, k - a, with the regressor r: V falls by 1 - (1 - g)^2."""
        step = p["g"] * u[0] ** 2 / (1 + u[0] ** 2)
        return [x[0] - step * x[0]]

    found = lyapunov(stepped(update, "k", ["r"], g=0.5), lambda s: s.k**2)
    assert (found.status, "zero inputs" in fields_of(found)[2]) == ("proved", False)


@pytest.mark.parametrize("argument", ["V", "claim"])
def test_a_function_that_is_NaN_is_refused(argument):
    plant, V = written("x' = -x; V = x**2")
    arguments = {"V": V, argument: lambda s: np.nan * s.x**2}
    with pytest.raises(clpt.DiagramError, match="NaN"):
        clpt.lyapunov(plant, **arguments)


def test_a_claim_that_rises_is_all_that_is_said():
    """V' = -2 x^2 <= x^2: the status is of the claim, and nothing follows from it."""
    plant, V = written("x' = -x; V = x**2")
    found = clpt.lyapunov(plant, V, claim=lambda s: s.x**2)
    assert (found.status, found.conclusion) == ("proved", "V' is at most the claim")


@pytest.mark.long
@pytest.mark.parametrize("m", [3.0, 1.0])
def test_a_ceiling_of_numbers_is_of_the_values_of_parameters(m):
    """V = (e^2 + w^2)/2 of e' = -2 e + w, w' = -e - |e| (w - m)/2 comes down to m^2/2."""

    def rates(t, x, u, p):
        return {"e": -2.0 * x.e + x.w, "w": -x.e - 0.5 * abs(x.e) * (x.w - p.m)}

    weighed = Block(
        "weighed", update=rates, states={"e": 1, "w": 1}, parameters={"m": m}
    )
    verdict = lyapunov(weighed, lambda s: (s.e**2 + s.w**2) / 2, points=POINTS)
    assert float(verdict.level) == pytest.approx(m**2 / 2)
    assert f"with the parameters' values m = {m:g}" in verdict.sentence


def test_a_level_of_a_region_is_told_once_and_not_above_it():
    def after(t, x, u, p):
        jump = 2 * np.pi * np.where(x.x > 0.5, 1.0, 0.0)
        return {"x": np.where(x.x > 6, x.x + 1, 0.5 * x.x + jump)}

    loop = clpt.Block("loop", update=after, states={"x": 1}, dt=1.0)
    verdict = clpt.lyapunov(loop, lambda s: 1 - np.cos(s.x), within={"x": (-1, 1)})
    levels = re.findall(r"V < ([\d.]+)", verdict.sentence)
    assert len(levels) == 1
    assert 0.9 * verdict.level < float(levels[0]) <= verdict.level < 1 - np.cos(0.5)
    assert "so what begins there comes to rest; with V' the change" in verdict.sentence


AS, LEVEL = "asymptotically stable", "ultimately bounded"
POSITIVE = {  # rates of states that stay at 0 or above, V: the conclusion, and the level
    "births and deaths": ("S' = 1 - S - 2*S*I; I' = 2*S*I - I", "S + I", LEVEL, 1),
    "a chemostat": ("s' = 2*(3 - s) - s*b; b' = s*b - 2*b", "s + b", LEVEL, 3),
    "weights": ("a' = 4 - a; b' = a/2 - b", "a + b", LEVEL, 8),
    "compartments": ("a' = -2*a + b; b' = 2*a - b - b/2", "a + b", AS, None),
    "an epidemic": ("S' = -2*S*I; I' = 2*S*I - I", "S + I", "comes to rest", None),
    "an enzyme": ("s' = -s/(2 + s)", "s", AS, None),
    "with a square": ("s' = -s; v' = -v", "s + v**2", AS, None),
    "no end of b": ("a' = -a; b' = b", "a", "goes to zero", None),
    "b may escape": ("a' = -a*b; b' = b**2", "a", "square-integrable", None),
    "a rate that fades": ("s' = -s*exp(-t)", "s", "stable", None),
    "a divisor that grows": (
        "s' = -s/(1 + b); b' = 1",
        "s",
        "V does not increase",
        None,
    ),
    "not kept": ("s' = -1", "s", "", None),
    "no way back": ("s' = -sqrt(s)", "s", "", None),
    "a difference": ("a' = -a; b' = -2*b", "a - b", "", None),
    "a growth": ("a' = a - b; b' = -b", "a + b", "", None),
    "a loss of the other": ("a' = 1; b' = -2*b", "a + b", "", None),
    "a rest at the end": ("s' = -s*(1 - s)", "s", "", None),
    "a product": ("a' = -a*b; b' = 0*b", "a + b", "comes to rest", None),
}


@pytest.mark.parametrize("name", POSITIVE)
def test_V_is_linear_in_states_that_stay_positive(name):
    rates, level, conclusion, most = POSITIVE[name]
    plant, V, *_ = written(f"{rates}; V = {level}")
    kept = {label: (0, None) for label in plant.state_labels if label != "v"}
    found = clpt.lyapunov(plant, V, where=kept)
    assert (found.conclusion, found.level) == (conclusion, most), found


def test_a_set_that_is_not_needed_is_no_condition():
    plant, V, *_ = written("x' = -x; q' = -q*x**2; V = x**2")
    alone = clpt.lyapunov(plant, V, where={"q": (0, None)})
    assert alone.sentence == clpt.lyapunov(plant, V).sentence
    plant, V, *_ = written("x' = -q*x; q' = 1 - q; V = x**2")
    needed = clpt.lyapunov(plant, V, where={"q": (0, None)})
    assert "q >= 0 at the start" in needed.sentence


LOST = {  # V' = -x^2 d^2 of V = x^2/2 + constant, or beside its least value
    "0": (lambda s: s.x**2 / 2, "V(0)"),
    "above": (lambda s: s.x**2 / 2 + 5, "V(0)"),
    "below": (lambda s: s.x**2 / 2 - 5, "V(0) + 5"),
    "a square": (lambda s: s.x**2 / 2 - 2.0**-10, "V(0) + 1/1024"),
}


@pytest.mark.parametrize(("V", "most"), LOST.values(), ids=LOST)
def test_what_V_loses_is_at_most_what_is_above_its_least_value(V, most):
    """The integral of x^2 d^2 is V(0) less the least value of V, at d = 1 from any start."""
    loop = clpt.Block(
        "loop",
        update=lambda t, x, u, p: -x.x * u.d**2,
        **{"states": {"x": 1}, "inputs": {"d": 1}},
    )
    verdict = clpt.lyapunov(loop, V)
    assert verdict.sentence.endswith(f"is at most {most}")


def test_a_pendulum_loses_at_most_its_energy_above_the_lowest_point():
    rod = clpt.Block(
        "rod",
        update=lambda t, x, u, p: {"th": x.w, "w": -np.sin(x.th) - u.d**2 * x.w},
        **{"states": {"th": 1, "w": 1}, "inputs": {"d": 1}},
    )
    verdict = clpt.lyapunov(rod, lambda s: s.w**2 / 2 - np.cos(s.th))
    assert verdict.sentence.endswith("is at most V(0) + 1")


# --- exponential stability: V' <= -k V, k by hand ------------------------------------------------

FALLS_EXPONENTIALLY = {
    "x' = -2*x; V = x**4": "8*t",
    "x' = -2*x - x**3; V = x**2": "4*t",
    "x' = 3 - x; V = (x - 3)**2/2; at x = 3": "2*t",
    "x' = -x*(1 + y**2); y' = -3*y": "2*t",
}
FALLS_SLOWER = [
    "x' = -x**3",
    "x' = -x*exp(-t)",
    "x' = -tanh(x)",
    "x' = -x*y**2; y' = -y",
    "x' = -x/(1 + x**2)",
    "x' = y; y' = -x - y",  # V' = -y^2
    "x' = -x; V = x**2 + x**4",  # two powers
    "x' = -x; y' = -2*y; V = abs(x) + y**2",
    # from (L, 0) y reaches about L^2/e: no multiple of |(x, y)(0)| bounds it
    "x' = -x + 2*y; y' = -y - 4*x**3; V = x**4 + y**2",
]


@pytest.mark.parametrize("text", FALLS_EXPONENTIALLY)
def test_the_rate_at_which_V_falls(text):
    found = of(text)
    assert found.conclusion == "exponentially stable"
    assert f"{found.decay}" == f"V(0)*exp(-{FALLS_EXPONENTIALLY[text]})"
    weaker = "asymptotically stable", "comes to rest", "goes to zero", "stable"
    assert all(map(found.implies, weaker))


def test_rates_of_time_need_not_go_to_zero():
    """Those of x' = -a(t) x, where a has ever higher and narrower peaks, do not."""
    found = of("x' = -(1 + t)*x")
    assert found.implies("comes to rest")
    assert not found.implies("all rates go to zero")


@pytest.mark.parametrize("text", FALLS_SLOWER)
def test_what_falls_slower_has_no_rate(text):
    found = of(text)
    assert not found.implies("exponentially stable")
    assert found.decay is None


PENDULUM = clpt.Block(
    "pendulum",
    update=lambda t, x, u, p: (x.rate, -2 * np.sin(x.angle) - x.rate),
    states={"angle": 1, "rate": 1},
)


def test_V_about_a_point_that_is_no_rest_names_its_rate():
    energy = lambda s: s.rate**2 / 2 + 2 * (1 - np.cos(s.angle))  # noqa: E731
    verdict = clpt.lyapunov(PENDULUM, energy, at={"angle": 2.0})
    assert verdict.status == "refuted"
    assert "(no rest: rate' = -2*sin(2))" in verdict.claim


LINEAR_PARTS = {  # matrix, discrete time -> eigenvalue that grows
    ((0, 1), (1, 0)): (False, "1>"),
    ((0, 1), (-1, 0.1)): (False, "0.05+0.999j>"),
    ((1.25, 1), (0, 0.5)): (True, "1.25>"),
    ((0, 1), (-1, 0)): (False, ""),  # on the border
    ((0, 1), (0, 0)): (False, ""),
}


@pytest.mark.parametrize("rows", LINEAR_PARTS)
def test_a_search_for_V_names_an_eigenvalue_that_grows(rows):
    discrete, eigenvalue = LINEAR_PARTS[rows]
    plant = control.ss(rows, [[0], [1]], [[1, 0]], 0, discrete)
    verdict = clpt.lyapunov(plant)
    assert verdict.status == "open"
    assert ("unstable: the linear part" in verdict.claim) == bool(eigenvalue)
    assert repr(verdict).endswith(eigenvalue)
