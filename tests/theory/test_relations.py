"""Relations that states keep, `lyapunov(..., keeps=)`: laws of textbooks, and traps beside them."""

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from text_systems import TICKS, written

import clpt_control as clpt
from clpt_control import lyapunov

POSITIVE = {"P": (0, None)}


def block(rates, r=True, parameters=None, **more):
    """A block of scalar states: name -> rate of (x, u, p); its input r is bounded."""
    return clpt.Block(
        "law",
        update=lambda t, x, u, p: {name: rate(x, u, p) for name, rate in rates.items()},
        states=dict.fromkeys(rates, 1),
        inputs={"r": 1} if r else {},
        parameters={"th": 2.0} | (parameters or {}),
        **more,
    )


FILTER = {
    "w": lambda x, u, p: -x.w + u.r,
    "y": lambda x, u, p: -x.y + p.th * u.r,
    "h": lambda x, u, p: x.w * (x.y - x.h * x.w),
}


def gradient(change=None, **more):
    """A gradient law on y = th w; `change` of the distance y - th w is added to y'."""
    rates = dict(FILTER)
    if change is not None:
        # without the filter's own -y the distance moves by `change` alone
        rates["y"] = lambda x, u, p: p.th * (u.r - x.w) + change(x.y - p.th * x.w, x, u)
    return block(rates, **more)


def squared(s):
    return (s.th - s.h) ** 2 / 2


def weighted(s):
    return (s.th - s.h) ** 2 / (2 * s.P)


def on_line(s):
    return [s.y - s.th * s.w]


def least_squares(rate=None, **more):
    rates = FILTER | {
        "h": lambda x, u, p: x.P * x.w * (x.y - x.h * x.w),
        "P": rate or (lambda x, u, p: -(x.P**2) * x.w**2),
    }
    return block(rates, **more)


# --- laws of textbooks --------------------------------------------------------------------------


def test_the_error_of_a_gradient_law_goes_to_zero():
    verdict = lyapunov(gradient(), squared, keeps=on_line)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert verdict.of == "w*(h - th) goes"
    assert "where y = th*w at the start" in verdict.sentence
    assert lyapunov(gradient(), squared).status == "refuted"  # off the line


@pytest.mark.long
def test_least_squares_with_one_parameter():
    """V' = -w^2 (h - th)^2/2 by hand, for every th."""
    verdict = lyapunov(least_squares(), weighted, keeps=on_line, where=POSITIVE)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert f"{verdict.rate}" == "-w**2*(h - th)**2/2"
    wanted = ["P > 0 at the start", "y = th*w at the start"]
    assert all(text in verdict.sentence for text in wanted)
    assert "with the parameters" not in verdict.sentence
    with pytest.raises(clpt.ClptError, match="states keep relations"):
        verdict.coq()


def test_least_squares_of_a_wrong_line_are_not_proved():
    def wrong(s):
        return [s.y - 1.1 * s.th * s.w]

    verdict = lyapunov(least_squares(), weighted, keeps=wrong, where=POSITIVE)
    assert verdict.status == "open"
    assert "leaves it by" in verdict.sentence


@pytest.mark.long
def test_two_parameters_by_two_filters():
    """V' = -(w^T (th - h))^2."""
    law = clpt.Block(
        "law",
        update=lambda t, x, u, p: {
            "w": -x.w + u.r,
            "y": -x.y + p.th @ u.r,
            "h": x.w * (x.y[0] - x.h @ x.w),
        },
        states={"w": 2, "y": 1, "h": 2},
        inputs={"r": 2},
        parameters={"th": [2.0, -1.0]},
    )
    verdict = lyapunov(
        law, lambda s: (s.th - s.h) @ (s.th - s.h) / 2, keeps=lambda s: s.y - s.th @ s.w
    )
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")


@pytest.mark.long
def test_two_parameters_by_filters_in_a_row():
    """V' = -((a - A) v + (b - B) w)^2; rates of its forms grow long, and are left out."""
    law = control.nlsys(
        lambda t, x, u, p: [
            -x[0] + np.sin(t),
            -x[1] + x[0],
            -x[2] + p["a"] * np.sin(t) + p["b"] * x[0],
            x[0] * (x[2] - x[3] * x[0] - x[4] * x[1]),
            x[1] * (x[2] - x[3] * x[0] - x[4] * x[1]),
        ],
        inputs=0,
        states=["v", "w", "y", "A", "B"],
        params={"a": 1.0, "b": 2.0},
        name="law",
    )
    verdict = lyapunov(
        law,
        lambda s: ((s.a - s.A) ** 2 + (s.b - s.B) ** 2) / 2,
        keeps=lambda s: s.y - s.a * s.v - s.b * s.w,
    )
    assert verdict.conclusion == "goes to zero"
    assert verdict.of.startswith("-A*v - B*w + a*v + b*w")


@pytest.mark.long
def test_information_of_a_filter_is_a_second_relation():
    """Y' = w y and R' = w^2 keep Y = th R where y = th w; w, that may grow, drives distances."""
    rates = FILTER | {
        "R": lambda x, u, p: x.w**2 - x.R,
        "Y": lambda x, u, p: x.w * x.y - x.Y,
        "h": lambda x, u, p: x.R * (x.Y - x.h * x.R),
    }

    def lines(s):
        return [s.y - s.th * s.w, s.Y - s.th * s.R]

    verdict = lyapunov(block(rates), squared, keeps=lines)
    assert verdict.failed[0].claim == "a distance from it does not grow"
    assert lyapunov(block(rates), squared, keeps=on_line).status != "proved"


@pytest.mark.long
def test_filters_in_discrete_time():
    law = clpt.Block(
        "law",
        update=lambda t, x, u, p: {
            "w": 0.5 * x.w + u.r,
            "y": 0.5 * x.y + p.th * u.r,
            "h": x.h + x.w * (x.y - x.h * x.w) / (1 + x.w**2),
        },
        states={"w": 1, "y": 1, "h": 1},
        inputs={"r": 1},
        parameters={"th": 2.0},
        dt=0.1,
    )
    verdict = lyapunov(law, squared, keeps=on_line)
    assert verdict.status == "proved"


def jumping(rates, jump):
    """A block that jumps at whole times."""
    ticks = {"breakpoints": TICKS["breakpoints"], "jump": jump}
    return block(
        rates, r="r" if rates is FILTER else "", parameters={"interval": -1.0}, **ticks
    )


@pytest.mark.parametrize(
    ("jump", "status"),
    [
        # w is not known to be bounded beside jumps
        (lambda t, x, u, p: {"w": x.w / 2, "y": x.y / 2, "h": x.h}, "open"),
        (lambda t, x, u, p: {"w": x.w, "y": x.y + 1, "h": x.h}, "open"),
        (lambda t, x, u, p: {"w": 2 * x.w, "y": x.y, "h": x.h}, "open"),
        (lambda t, x, u, p: {"w": x.w, "y": 0 * x.y, "h": x.h}, "open"),
        (lambda t, x, u, p: {"w": x.h, "y": x.y, "h": x.h}, "open"),
    ],
)
def test_jumps_keep_the_line_or_leave_it(jump, status):
    assert lyapunov(jumping(FILTER, jump), squared, keeps=on_line).status == status


# --- traps --------------------------------------------------------------------------------------

BESIDE = {  # r' of the distance r from the line
    "r": lambda r, x, u: r,
    "r/100": lambda r, x, u: r / 100,
    "r^3": lambda r, x, u: r**3,
    "r^2": lambda r, x, u: r**2,
    "sin r": lambda r, x, u: np.sin(r),
    "tanh r": lambda r, x, u: np.tanh(r),
    "1 - cos r": lambda r, x, u: 1 - np.cos(r),
    "|r|^(1/2)": lambda r, x, u: np.sqrt(np.abs(r)),
    "-|r|^(1/2)": lambda r, x, u: -np.sqrt(np.abs(r)),
    "r^(1/3)": lambda r, x, u: np.cbrt(r),
    "acosh": lambda r, x, u: np.arccosh(1 + np.abs(r)),
    "asin": lambda r, x, u: np.pi / 2 - np.arcsin(1 / (1 + r**2)),
    "sign r": lambda r, x, u: np.sign(r),
    "-sign r": lambda r, x, u: -np.sign(r),
    "where r > 0": lambda r, x, u: np.where(r > 0, 1.0, 0.0),
    "max(r, 0)": lambda r, x, u: np.maximum(r, 0.0),
    "-max(r, 0) + min(r, 0)": lambda r, x, u: -np.maximum(r, 0.0) + np.minimum(r, 0.0),
    "-r + 2 |r|": lambda r, x, u: -r + 2 * np.abs(r),
    "u^2 r": lambda r, x, u: u.r**2 * r,
    "w^2 r": lambda r, x, u: x.w**2 * r,
    "w r": lambda r, x, u: x.w * r,
    "h r": lambda r, x, u: x.h * r,
    "u r": lambda r, x, u: u.r * r,
    "-r + r^3": lambda r, x, u: -r + 1e20 * r**3,  # stable nearer than rounding
    "-r + w r^2": lambda r, x, u: -r + x.w * r**2,
    "u": lambda r, x, u: u.r,
    "2 - r": lambda r, x, u: 2 - r,
    "h - r": lambda r, x, u: x.h - r,
    "(1 - w^2) r": lambda r, x, u: (1 - x.w**2) * r,
}


@pytest.mark.parametrize("name", BESIDE)
def test_a_line_that_a_run_leaves_is_not_kept(name):
    verdict = lyapunov(gradient(BESIDE[name]), squared, keeps=on_line)
    assert verdict.status == "open"


@pytest.mark.parametrize(
    "change",
    [
        lambda r, x, u: 0 * r,
        lambda r, x, u: -r,
        lambda r, x, u: -(r**3),
        lambda r, x, u: -(x.w**2) * r,
        lambda r, x, u: -np.tanh(r),
        lambda r, x, u: -np.maximum(r, 0.0) - 2 * np.minimum(r, 0.0),
    ],
)
def test_a_line_that_distances_do_not_leave_is_kept(change):
    verdict = lyapunov(gradient(change), squared, keeps=on_line)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")


@pytest.mark.parametrize(
    "after",
    [
        lambda w, y: w + 2 * (y - w),
        lambda w, y: w + np.sqrt(np.abs(y - w)),
        lambda w, y: w + (y - w) ** 2,
    ],
)
def test_a_jump_that_enlarges_a_distance(after):
    loop = clpt.Block(
        "loop",
        update=lambda t, x, u, p: {"w": 0 * x.w, "y": 0 * x.y, "e": -x.e},
        jump=lambda t, x, u, p: {"w": x.w, "y": after(x.w, x.y), "e": x.e},
        states={"w": 1, "y": 1, "e": 1},
        **TICKS,
    )
    verdict = lyapunov(loop, lambda s: s.e**2, keeps=lambda s: [s.y - s.w])
    assert verdict.failed[0].claim == "a distance from it does not grow"


@pytest.mark.parametrize("drive", ["c * (z - 3 * w)", "z - 3 * w + (y - 3 * w)"])
def test_a_distance_that_another_drives(drive):
    """r_y' = -r_y + c r_z with c' = 3 c; r_y' = r_z with r_z' = 0."""
    e = f"w' = -w; y' = -3*w - (y - 3*w) + {drive}; z' = -3*w{'- (z - 3*w)' * ('c' in drive)}"
    plant, V, *_ = written(f"{e}; c' = 3*c; e' = -e; V = e**2")
    verdict = lyapunov(plant, V, keeps=lambda s: [s.y - 3 * s.w, s.z - 3 * s.w])
    assert verdict.failed[0].claim == "a distance from it does not grow"


@pytest.mark.long
def test_two_distances_that_drive_each_other():
    """(1 + w^2) times [[-1, 2], [2, -1]] has a negative trace, and a positive eigenvalue."""

    def pair(share):
        def off(x, p):
            return x.y - p.th * x.w, x.z - p.th * x.w

        def rate(own, other):
            return lambda x, u, p: (
                p.th * (u.r - x.w)
                + (1 + x.w**2) * (-off(x, p)[own] + share * off(x, p)[other])
            )

        return block(FILTER | {"y": rate(0, 1), "z": rate(1, 0)})

    def lines(s):
        return [s.y - s.th * s.w, s.z - s.th * s.w]

    assert lyapunov(pair(2.0), squared, keeps=lines).status == "open"
    assert lyapunov(pair(0.5), squared, keeps=lines).status == "proved"


@pytest.mark.long
@pytest.mark.parametrize("share", [1.1, 1.0 + 1e-6, -2.0])
def test_distances_that_grow_in_discrete_time(share):
    law = clpt.Block(
        "law",
        update=lambda t, x, u, p: {
            "w": 0.5 * x.w,
            "y": p.th * 0.5 * x.w + p.a * (x.y - p.th * x.w),
            "h": x.h + x.w * (x.y - x.h * x.w) / (1 + x.w**2),
        },
        states={"w": 1, "y": 1, "h": 1},
        parameters={"th": 2.0, "a": share},
        dt=1.0,
    )
    assert lyapunov(law, squared, keeps=on_line).status == "open"


def test_stable_is_not_said_on_a_relation():
    """x' = -x + y^2 with y = 0: 0 is the rest, and y' = -y alone is judged."""
    rates = {"x": lambda x, u, p: -x.x, "y": lambda x, u, p: -x.y + 0 * x.x}
    plain = block(rates, r=False)
    verdict = lyapunov(plain, lambda s: s.x**2, keeps=lambda s: s.y)
    assert verdict.conclusion == "goes to zero"
    assert "stable" not in verdict.sentence
    rates["x"] = lambda x, u, p: -(x.x**3) + 1e3 * x.y
    driven = lyapunov(
        block(rates, r=False), lambda s: s.x**2 / 2, keeps=lambda s: [s.y]
    )
    assert "stable" not in driven.sentence
    assert driven.status == "proved"
    rates["x"] = lambda x, u, p: 0 * x.x
    still = lyapunov(block(rates, r=False), lambda s: s.x**2 / 2, keeps=lambda s: s.y)
    assert "stable" not in still.sentence


def test_V_that_is_zero_on_the_line_shows_nothing():
    verdict = lyapunov(gradient(), lambda s: (s.y - s.th * s.w) ** 2, keeps=on_line)
    assert verdict.status == "open"


@pytest.mark.long
def test_runs_on_a_line_that_escape_are_not_said_to_exist():
    """w' = w^2 ends at t = 1/w(0)."""
    rates = FILTER | {
        "w": lambda x, u, p: x.w**2,
        "y": lambda x, u, p: p.th * x.w**2 - (x.y - p.th * x.w),
    }
    verdict = lyapunov(block(rates), squared, keeps=on_line)
    assert verdict.status == "open"
    assert "w may grow, and multiplies what rounding leaves" in verdict.sentence


def test_a_factor_of_the_distance_that_grows_is_told():
    """Off the line by z(0), z falls as exp(-t) and m z grows as exp(t), which drives h."""
    rates = {
        "y": lambda x, u, p: -x.y + p.th * u.r,
        "w": lambda x, u, p: -x.w + u.r,
        "m": lambda x, u, p: 2 * x.m,
        "h": lambda x, u, p: -x.h + x.m * (x.y - p.th * x.w),
    }
    of_h = lambda s: s.h**2 / 2  # noqa: E731
    grown = lyapunov(block(rates), of_h, keeps=on_line)
    assert grown.status == "open"
    assert "m*th may grow, and multiplies what rounding leaves" in grown.sentence
    rates["m"] = lambda x, u, p: -x.m
    assert lyapunov(block(rates), of_h, keeps=on_line).conclusion == "goes to zero"


ACTS = {  # what a distance d = y - 3 x adds to x', g', bounds; d falls as exp(-t)
    "d/g, g falls": (lambda d, x, u: d / x.g, -2, {"g": (0, None)}),
    "d/g^2, g falls": (lambda d, x, u: d / x.g**2, -1, {"g": (0, None)}),
    "d/sqrt(g), g falls": (lambda d, x, u: d / np.sqrt(x.g), -4, {"g": (0, None)}),
    "d g, g rises": (lambda d, x, u: d * x.g, 2, {}),
    "d^2 g, g rises": (lambda d, x, u: d**2 * x.g, 3, {}),
    "d and a constant": (lambda d, x, u: 1 + d * x.g, 2, {}),
    "sign d": (lambda d, x, u: np.sign(d), -1, {}),
    "a root of d": (lambda d, x, u: np.cbrt(d), -1, {}),
}


def beside(act, g=-1, fall=1.0, r=True, **more):
    """x' = -x + act where y = 3 x is kept, g' = g x.g."""

    def rates(t, x, u, p):
        d = x.y - 3 * x.x
        added = act(d, x, u)
        return {"x": -x.x + added, "y": -3 * x.x + 3 * added - fall * d, "g": g * x.g}

    inputs = {"r": 1} if r else {}
    states = dict.fromkeys("xyg", 1)
    return clpt.Block("loop", update=rates, states=states, inputs=inputs, **more)


def tripled(s):
    return [s.y - 3 * s.x]


def of_x(s):
    return s.x**2 / 2


@pytest.mark.parametrize(("act", "g", "where"), ACTS.values(), ids=ACTS)
def test_a_distance_that_acts_more_and_more_is_not_kept_in_a_run(act, g, where):
    """Of d/g the closed form is x = e^-t (x(0) - d(0)/2) + d(0) e^t/2."""
    loop = beside(act, g, r=False)
    verdict = lyapunov(loop, of_x, keeps=tripled, where=where)
    assert verdict.status == "open"
    assert "may grow, and multiplies what rounding leaves" in verdict.sentence


@pytest.mark.long
def test_the_factor_of_a_distance_is_named():
    act, g, where = ACTS["d/g, g falls"]
    verdict = lyapunov(beside(act, g, r=False), of_x, keeps=tripled, where=where)
    assert "(1/g may grow" in verdict.sentence
    run = solve_ivp(
        lambda t, s: [-s[0] + s[1] / s[2], -s[1], -2 * s[2]],
        (0, 40),
        [0.1, 1e-12, 1.0],
        method="Radau",
        rtol=1e-9,
        atol=1e-60,
    )
    assert run.y[0, -1] == pytest.approx(1e-12 * np.exp(40) / 2, rel=1e-3)


def test_a_distance_over_a_state_that_falls_in_discrete_time_is_not_kept():
    law = clpt.Block(
        "law",
        update=lambda t, x, u, p: {
            "x": x.x / 2 + (x.y - 3 * x.x) / x.g,
            "y": 1.5 * x.x + (3 / x.g + 0.5) * (x.y - 3 * x.x),
            "g": x.g / 8,
        },
        states={"x": 1, "y": 1, "g": 1},
        dt=1.0,
    )
    verdict = lyapunov(law, of_x, keeps=tripled, where={"g": (0, None)})
    assert "1/g may grow, and multiplies" in verdict.sentence


@pytest.mark.parametrize(
    ("where", "text"),
    [
        ({}, "where r is bounded"),
        ({"r": (0, None)}, "where r is bounded"),
        ({"r": (-9, 9)}, "where -9 <= r <= 9"),
    ],
)
@pytest.mark.parametrize("power", [1, 2])
def test_an_input_that_multiplies_a_distance_is_bounded(power, where, text):
    loop = beside(lambda d, x, u: u.r**power * d)
    verdict = lyapunov(loop, of_x, keeps=tripled, where=where)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert text in verdict.sentence


def test_a_distance_that_stays_is_not_added_up():
    """z' = y - 3 x is no rate on the relation; of a distance that falls z takes up little."""
    for fall, status in ((0.0, "open"), (1.0, "proved")):
        line = f"y' = -3*x - {fall}*(y - 3*x); z' = y - 3*x; V = (x**2 + z**2)/2"
        plant, V, *_ = written(f"x' = -x; {line}")
        verdict = lyapunov(plant, V, keeps=tripled)
        assert verdict.status == status
        assert ("z adds up what rounding leaves" in verdict.sentence) == (not fall)


@pytest.mark.parametrize(
    "keeps",
    [
        lambda s: s.y - s.th * s.r,  # of an input
        lambda s: s.y - s.th * s.w * np.exp(-s.t),
        lambda s: s.y**2 - (s.th * s.w) ** 2,
        lambda s: s.y * s.w - 1,
        lambda s: s.th - 2,
        lambda s: [s.y - s.th * s.w, s.y - s.th * s.w - 1],
        lambda s: np.maximum(s.y, s.w),
    ],
)
def test_what_is_no_relation_of_states_is_refused(keeps):
    with pytest.raises(clpt.ClptError, match=r"keeps|relation"):
        lyapunov(gradient(), squared, keeps=keeps)


@pytest.mark.parametrize("nothing", [[], None])
def test_keeps_that_returns_nothing_is_named(nothing):
    with pytest.raises(clpt.ClptError) as refusal:
        lyapunov(gradient(), squared, keeps=lambda s: nothing)
    wanted = f"law: keeps returns {nothing}. Return functions of states"
    assert f"{refusal.value}" == wanted


def test_a_rate_that_jumps_on_the_relation_is_named():
    """y' = -2 sign y and 2 x' = -2 sign x are one rate where y = 2 x."""
    plant, V, *_ = written("x' = -sign(x); y' = -2*sign(y); V = x*y/2")
    verdict = lyapunov(plant, V, keeps=lambda s: [s.y - 2 * s.x])
    assert "y may leave it: its rate may jump" in verdict.sentence


@pytest.mark.long
def test_a_divisor_between_zero_and_a_number_is_above_zero():
    law = least_squares(lambda x, u, p: -(x.P**2) * x.w**2)
    verdict = lyapunov(law, weighted, keeps=on_line, where={"P": (0, 10)})
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert "where P > 0, 10 - P >= 0 at the start" in verdict.sentence
    rises = least_squares(lambda x, u, p: x.P)
    risen = lyapunov(rises, weighted, keeps=on_line, where={"P": (0, 10)})
    assert risen.status == "open"


def test_keeps_is_refused_in_a_box_and_without_V():
    lag = block({"x": lambda x, u, p: -x.x, "y": lambda x, u, p: -x.y}, r=False)
    box = {"x": (-1, 1), "y": (-1, 1)}
    with pytest.raises(clpt.ClptError, match="leave `keeps` out"):
        lyapunov(lag, lambda s: s.x**2, within=box, keeps=lambda s: s.y)
    with pytest.raises(clpt.ClptError, match="leave `keeps` out"):
        lyapunov(lag, keeps=lambda s: s.y)


# --- P > 0 --------------------------------------------------------------------------------------

NOT_KEPT = {
    "-1": lambda x, u, p: -1 + 0 * x.P,
    "-P^(1/2)": lambda x, u, p: -np.sqrt(x.P),
    "-P^(1/3)": lambda x, u, p: -np.cbrt(x.P),
    "-|P|^(2/3)": lambda x, u, p: -(np.abs(x.P) ** (2 / 3)),
    "-1/P": lambda x, u, p: -1 / x.P,
    "-P/(P + y^2)": lambda x, u, p: -x.P / (x.P + x.y**2),
    "r": lambda x, u, p: u.r + 0 * x.P,
    "-sign P": lambda x, u, p: -np.sign(x.P),
    "-w^2": lambda x, u, p: -(x.w**2) + 0 * x.P,
}


@pytest.mark.parametrize("name", NOT_KEPT)
def test_P_that_may_reach_zero_is_not_kept_above(name):
    verdict = lyapunov(
        least_squares(NOT_KEPT[name]), weighted, keeps=on_line, where=POSITIVE
    )
    assert verdict.status != "proved"


def covariance(rates, jump=None):
    return jumping(rates, jump) if jump else block(rates, r=False)


def over_P(s):
    return s.e**2 / s.P


@pytest.mark.parametrize(
    "jump",
    [
        lambda t, x, u, p: {"e": x.e, "P": 0 * x.P},
        lambda t, x, u, p: {"e": x.e * 1.4, "P": 2 * x.P},
        lambda t, x, u, p: {"e": x.e, "P": np.maximum(x.P - 1, 0)},
        lambda t, x, u, p: {"e": x.e, "P": x.P - 1},
    ],
)
def test_P_that_jumps_to_zero_or_up_bounds_nothing(jump):
    rates = {"e": lambda x, u, p: -x.e, "P": lambda x, u, p: 0 * x.P}
    verdict = lyapunov(covariance(rates, jump), over_P, where=POSITIVE)
    assert verdict.conclusion in ("", "V does not increase", "square-integrable")


def test_P_that_rises_bounds_nothing():
    """e' = 0.4 e and P' = P have (e^2/P)' = -0.2 e^2/P, and e grows."""
    rates = {"e": lambda x, u, p: 0.4 * x.e, "P": lambda x, u, p: x.P}
    verdict = lyapunov(covariance(rates), over_P, where=POSITIVE)
    assert verdict.conclusion in ("", "V does not increase")


def test_a_loss_that_P_makes_small_forces_nothing_to_zero():
    """z' = -P z with P = exp(-t) ends at z(0)/e, though V' <= -P z^2."""
    rates = {
        "e": lambda x, u, p: -x.e,
        "z": lambda x, u, p: -x.P * x.z,
        "P": lambda x, u, p: -x.P,
    }
    verdict = lyapunov(
        covariance(rates), lambda s: s.e**2 / s.P + s.z**2 / 2, where=POSITIVE
    )
    assert not (verdict.status == "proved" and "z" in verdict.of)


def test_an_end_at_P_of_zero_is_no_rest():
    """a' = b, b' = -a - P b with P = exp(-t) swings for ever."""
    rates = {
        "a": lambda x, u, p: x.b,
        "b": lambda x, u, p: -x.a - x.P * x.b,
        "P": lambda x, u, p: -x.P,
        "e": lambda x, u, p: -x.e,
    }
    verdict = lyapunov(
        covariance(rates),
        lambda s: s.e**2 / s.P + (s.a**2 + s.b**2) / 2,
        where=POSITIVE,
    )
    zero = verdict.of.rpartition(" ")[0].split(", ")
    assert not {"a", "b"} & {*zero}
    assert "rest" not in verdict.conclusion


def test_the_sets_of_V_with_a_value_stay_closed():
    """q' = -q^2 + d, d >= 0, is kept at 0 or above; V has a value there."""
    rates = {"q": lambda x, u, p: -(x.q**2), "P": lambda x, u, p: -x.P}
    verdict = lyapunov(
        covariance(rates), lambda s: s.q**2, where={"q": (0, None), "P": (0, None)}
    )
    assert "P >= 0" in verdict.sentence


def test_a_source_that_is_a_function_of_a_distance_is_not_known_to_keep_it():
    source = clpt.Block(
        "source",
        output=lambda t, x, u, p: {"v": abs(u.w) ** 0.5},
        inputs={"w": 1},
        outputs={"v": 1},
        opaque=True,
    )
    plant = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"x": -x.x, "w": u.v},
        output=lambda t, x, u, p: {"w": x.w},
        inputs={"v": 1},
        outputs={"w": 1},
        states={"x": 1, "w": 1},
    )
    loop = clpt.connect([source, plant])
    assert lyapunov(loop, lambda s: s.x**2, keeps=lambda s: s.w).status == "open"


def test_a_system_of_python_control_keeps_a_relation():
    plant = control.nlsys(
        lambda t, x, u, p: [-x[0] + u[0], -x[1] + 2 * u[0], -x[2] + x[1] - 2 * x[0]],
        states=["w", "y", "e"],
        inputs=["r"],
        outputs=0,
        name="plant",
    )
    verdict = lyapunov(plant, lambda s: s.e**2 / 2, keeps=lambda s: s.y - 2 * s.w)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert "stable" not in verdict.sentence


# --- laws beside a plant ------------------------------------------------------------------------


@pytest.mark.long
def test_a_composite_law_with_least_squares():
    """Slotine and Li (1991), section 8.8: V' = -kd s^2 - (vf (bh - b))^2/2, s = v - vr."""

    def rates(t, x, u, p):
        s, ar = x.v - x.vr, u.r - p.l * x.vr
        tau = ar + x.bh * x.v - p.kd * s
        drag = tau - p.b * x.v
        return {
            "v": drag,
            "vr": ar,
            "vf": -p.lam * x.vf + x.v,
            "y": -p.lam * x.y + tau - drag,
            "bh": -x.P * (x.v * s + x.vf * (x.vf * x.bh - x.y)),
            "P": -(x.P**2) * x.vf**2,
        }

    loop = clpt.Block(
        "loop",
        update=rates,
        states=dict.fromkeys(("v", "vr", "vf", "y", "bh", "P"), 1),
        inputs={"r": 1},
        parameters={"b": 0.4, "l": 1.0, "lam": 2.0, "kd": 3.0},
    )
    verdict = lyapunov(
        loop,
        lambda s: (s.v - s.vr) ** 2 / 2 + (s.bh - s.b) ** 2 / (2 * s.P),
        keeps=lambda s: s.y - s.b * s.vf,
        where=POSITIVE,
    )
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert f"{verdict.rate}" == "-kd*(v - vr)**2 - vf**2*(b - bh)**2/2"
    assert {*verdict.of.removesuffix(" go").split(", ")} == {"v - vr", "vf*(b - bh)"}


@pytest.mark.slow
def test_a_composite_law_with_two_parameters():
    """V' = -kd s^2 - c (W (a_hat - a))^2, W = (v - lam vf, vf), for all parameters."""

    def rates(t, x, u, p):
        s, ar = x.v - x.vr, u.r - p.l * x.vr
        tau = x.mh * ar + x.bh * x.v - p.kd * s
        W = x.v - p.lam * x.vf
        miss = W * x.mh + x.vf * x.bh - x.y
        return {
            "v": (tau - p.b * x.v) / p.m,
            "vr": ar,
            "vf": -p.lam * x.vf + x.v,
            "y": -p.lam * x.y + tau,
            "mh": -p.g * (ar * s + p.c * W * miss),
            "bh": -p.g * (x.v * s + p.c * x.vf * miss),
        }

    loop = clpt.Block(
        "loop",
        update=rates,
        states=dict.fromkeys(("v", "vr", "vf", "y", "mh", "bh"), 1),
        inputs={"r": 1},
        parameters={
            **{"m": 1.5, "b": 0.4, "l": 1.0},
            **{"lam": 2.0, "kd": 3.0, "g": 2.0, "c": 1.0},
        },
    )
    verdict = lyapunov(
        loop,
        lambda s: (
            s.m * (s.v - s.vr) ** 2 / 2
            + ((s.mh - s.m) ** 2 + (s.bh - s.b) ** 2) / (2 * s.g)
        ),
        keeps=lambda s: s.y - s.m * (s.v - s.lam * s.vf) - s.b * s.vf,
    )
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert "v - vr" in verdict.of
    assert "values" not in verdict.sentence


@pytest.mark.long
def test_a_normalised_gradient():
    """V' = -g (w (h - th))^2/(1 + w^2), and w is bounded."""
    rates = FILTER | {"h": lambda x, u, p: p.g * x.w * (x.y - x.h * x.w) / (1 + x.w**2)}
    law = block(rates, parameters={"g": 0.7})
    verdict = lyapunov(law, squared, keeps=on_line)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert "where r is bounded" in verdict.sentence
    rates |= {
        "w": lambda x, u, p: x.w,
        "y": lambda x, u, p: x.y - 2 * (x.y - p.th * x.w),
    }
    grows = lyapunov(block(rates, parameters={"g": 0.7}), squared, keeps=on_line)
    assert grows.status == "open"


# --- claims with a push -------------------------------------------------------------------------


def pushed(rates, V, claim, **more):
    return lyapunov(block(rates, parameters={"k": 2.0}), V, claim, **more)


SHARED = {"e": lambda x, u, p: -p.k * x.e + x.h * u.r, "h": lambda x, u, p: -x.h}


def of_both(s):
    return (s.e**2 + s.h**2) / 2


def of_e(s):
    return s.e**2 / 2


def test_a_claim_that_holds_is_not_refuted():
    """V' = -k e^2 + e h r - h^2, so k e^2 is in the mean at most (h r)^2/k."""
    verdict = pushed(SHARED, of_both, lambda s: -s.k * s.e**2 + s.e * s.h * s.r)
    assert (verdict.status, verdict.conclusion) == ("proved", "bounded in the mean")
    assert verdict.bound == "e**2*k is at most h**2*r(t)**2/k"


@pytest.mark.long
def test_an_error_in_two_states_has_a_mean():
    rates = {
        "y": lambda x, u, p: -p.k * (x.y - x.m) - x.m + u.r + x.h * u.r,
        "m": lambda x, u, p: -x.m + u.r,
        "h": lambda x, u, p: -x.h,
    }
    verdict = pushed(
        rates,
        lambda s: (s.y - s.m) ** 2 / 2,
        lambda s: -s.k * (s.y - s.m) ** 2 + (s.y - s.m) * s.h * s.r,
    )
    assert verdict.conclusion == "bounded in the mean"
    assert verdict.bound.endswith("is at most h**2*r(t)**2/k")


def test_a_level_and_an_input_of_zero_come_before_a_mean():
    rates = {"e": lambda x, u, p: -p.k * x.e + u.r}

    def claim(s):
        return -s.k * s.e**2 + s.e * s.r

    level = pushed(rates, of_e, claim, where={"r": (-1, 1)})
    assert level.conclusion == "ultimately bounded"
    still = pushed(rates, of_e, claim)
    assert "where r = 0" in still.sentence


@pytest.mark.parametrize(
    ("rates", "V", "claim"),
    [
        (  # e' = h^2 r and h' = e h^2 may end in finite time
            {
                "e": lambda x, u, p: -p.k * x.e + x.h**2 * u.r,
                "h": lambda x, u, p: x.e * x.h**2,
            },
            of_e,
            lambda s: -s.k * s.e**2 + s.e * s.h**2 * s.r,
        ),
        (
            {"e": lambda x, u, p: -p.k * x.e + x.z * u.r, "z": lambda x, u, p: x.e**2},
            of_e,
            lambda s: -s.k * s.e**2 + s.e * s.z * s.r,
        ),
        (  # e in the push
            {"e": lambda x, u, p: -p.k * x.e + x.e * u.r},
            of_e,
            lambda s: -s.k * s.e**2 + s.e**2 * s.r,
        ),
        (
            {"e": lambda x, u, p: -p.k * x.e + np.sin(x.e) * u.r},
            of_e,
            lambda s: -s.k * s.e**2 + s.e * np.sin(s.e) * s.r,
        ),
        (  # nothing pulls
            SHARED | {"e": lambda x, u, p: p.k * x.e + x.h * u.r},
            of_both,
            lambda s: s.k * s.e**2 + s.e * s.h * s.r,
        ),
        (  # V does not hold e
            SHARED,
            lambda s: s.h**2 / 2,
            lambda s: -s.k * s.e**2 + s.e * s.h * s.r,
        ),
    ],
)
def test_a_push_that_may_carry_V_away_has_no_mean(rates, V, claim):
    verdict = pushed(rates, V, claim)
    assert verdict.conclusion in ("", "V' is at most the claim") or (
        "as claimed" in verdict.sentence and "where r = 0" in verdict.sentence
    )


def test_a_set_of_a_state_that_a_relation_gives_is_refused():
    plant, V, *_ = written("a' = -a; b' = -b; V = a")
    with pytest.raises(
        clpt.DiagramError, match="where: b is given by a relation, b = a"
    ):
        lyapunov(plant, V, keeps=lambda s: [s.a - s.b], where={"b": (0, None)})
    found = lyapunov(plant, V, keeps=lambda s: [s.a - s.b], where={"a": (0, None)})
    assert found.status == "proved"
    with pytest.raises(clpt.DiagramError, match="in which one has a constant factor"):
        lyapunov(plant, V, keeps=lambda s: [s.a * s.b])
