"""C that is exported: compiled without a warning, and the numbers of the blocks that run."""

import ctypes
import random
import re
import shutil
import subprocess
from contextlib import suppress

import control
import numpy as np
import pytest
from engine_runs import Each, NativeDiagram
from example_models import MODELS, pendulum
from gridded_currents import field_blocks, plane_field
from random_diagrams import random_system

import clpt_control as clpt

COMPILER = shutil.which("cc")
needs_cc = pytest.mark.skipif(COMPILER is None, reason="no C compiler on this machine")
FLAGS = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-pedantic",
    "-Werror",
    "-O2",
    "-shared",
    "-fPIC",
]


def library(text, folder):
    """Return text of C, compiled without a warning."""
    (folder / "made.c").write_bytes(text)
    made = folder / "made.so"
    subprocess.run([COMPILER, *FLAGS, "-o", made, folder / "made.c", "-lm"], check=True)
    return ctypes.CDLL(str(made))


class InC:
    """A diagram's C, compiled."""

    def __init__(self, system, folder, export=clpt.export, **given):
        self.text = export(system, folder / "made.c", **given)
        assert re.findall(r"#include.*", self.text) == ["#include <math.h>"]
        assert not re.search(r"\b(malloc|calloc|free|printf)\b", self.text)
        self.library = library((folder / "made.c").read_bytes(), folder)
        self.name = re.search(r"(\w+)_nx = ", self.text)[1]
        counts = re.findall(rf"{self.name}_n([xuyp]) = (\d+)", self.text)
        self.counts = {letter: int(count) for letter, count in counts}
        self.p, self.x0 = self.array("p"), self.array("x")

    def array(self, letter):
        """Return the numbers that the file has itself."""
        count = self.counts[letter]
        held = (ctypes.c_double * max(1, count)).in_dll
        return (
            np.array(held(self.library, f"{self.name}_{letter}0"))
            if count
            else np.zeros(1)
        )

    def call(self, name, times, *arrays):
        pointers = [a.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for a in arrays]
        getattr(self.library, f"{self.name}_{name}")(
            *map(ctypes.c_double, times), *pointers
        )

    def computed(self, name, t, x, u):
        """Return outputs or rates."""
        found = np.zeros(self.counts["y" if name == "outputs" else "x"])
        self.call(name, [t], x, u, self.p, found)
        return found

    def run(self, x, u, h, times):
        """Return states after each step, from the first."""
        found = [np.array(x)]
        for t in times[:-1]:
            found.append(found[-1].copy())
            self.call("step", [t, h], found[-1], u, self.p)
        return np.array(found)


def stepped(runner, x, u, times):
    """Return states of classical steps of order 4, by the functions in Python.

    Blocks jump at the end of a step that ends at their breakpoints.
    """
    sweep, h = runner.sweep, times[1] - times[0]

    def jumped(t, x, sampling=()):
        sweep.enter(t + h / 2)
        ends = max(t - h / 2, 0.0), t + h / 2
        breaking = [k for k in sweep.jumping if len(sweep.block_breakpoints(k, *ends))]
        return sweep.jump(t, x, u, breaking, sampling) if breaking or sampling else x

    sampled = [
        k for k in sweep.jumping if runner.wiring.nodes[k].system.first_held is not None
    ]
    states = [jumped(times[0], x, sampled)]
    for t in times[:-1]:
        x = states[-1]
        k1 = sweep.derivative(t, x, u)
        k2 = sweep.derivative(t + h / 2, x + h / 2 * k1, u)
        k3 = sweep.derivative(t + h / 2, x + h / 2 * k2, u)
        k4 = sweep.derivative(t + h, x + h * k3, u)
        states.append(jumped(t + h, x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)))
    return np.array(states)


@needs_cc
@pytest.mark.parametrize("name", [name for name in MODELS if name != "stiff"])
def test_the_numbers_are_those_of_the_blocks(name, tmp_path):
    system, start, u, h, *_ = MODELS[name]
    made = InC(system, tmp_path, initial_state=start)
    runner, u = NativeDiagram(system), np.array([*u, 0.0])
    start, m = np.array(start, float), runner.wiring.ninputs
    assert made.x0 == pytest.approx(start)
    random, exact = np.random.default_rng(1), {"rel": 1e-12, "abs": 1e-12}
    for t in (0.0, 0.7, 3.1):
        x = start + 0.3 * np.abs(random.standard_normal(len(start)))
        runner.sweep.enter(t)
        rates = runner.sweep.derivative(t, x, u[:m])
        assert made.computed("rates", t, x, u) == pytest.approx(rates, **exact)
        outputs = runner.sweep.outputs()
        assert made.computed("outputs", t, x, u) == pytest.approx(outputs, **exact)
    times = h * np.arange(301)
    if name == "discrete":
        expected = runner.run(start, times, inputs=u[:m]).x
    else:
        expected = stepped(runner, start, u[:m], times)
    if "_begin(" in made.text:
        made.call("begin", [0.0], start, u, made.p)
    assert np.abs(made.run(start, u, h, times) - expected).max() <= 1e-12 * max(
        1.0, np.abs(expected).max()
    )


@needs_cc
def test_elements_of_a_parameter_behind_a_block_that_jumps_are_read_at_their_places(
    tmp_path,
):
    count = clpt.Block(
        "count",
        update=lambda t, x, u, p: [0.0],
        jump=lambda t, x, u, p: x + u,
        states={"n": 1},
        inputs={"u": 1},
        parameters={"interval": -1.0},
        breakpoints=Each(0.5),
    )
    gains = clpt.Block(
        "gains",
        output=lambda t, x, u, p: {"y": p.v},
        outputs={"y": 3},
        parameters={"v": [1.0, 2.0, 3.0]},
    )
    tank = control.ss(-1.0, 1.0, 1.0, 0.0, inputs="f", outputs="h", name="tank")
    wires = [["count.u", "gains.y[1]"], ["tank.f", "-gains.y[2]"]]
    system = control.interconnect(
        [count, gains, tank], wires, outlist=["tank.h", "count.n[0]", "gains.y[0]"]
    )
    made = InC(system, tmp_path, initial_state=[0.0, 0.0])
    rates = made.computed("rates", 0.1, np.array([0.0, 0.5]), np.array([0.0]))
    assert rates == pytest.approx([0.0, -3.5])


def test_the_head_says_how_long_a_step_may_be():
    """A diagram of discrete time has its own; one that samples wants a divisor of its period."""
    discrete = clpt.export(control.ss(0.5, 1, 1, 0, 0.25, name="own"))
    assert "the diagram's own time, 0.25; dt is not used" in discrete
    assert "dt must divide" not in discrete
    hold, lag = clpt.parts.hold(0.1, y="held"), clpt.parts.lag(0.5, u="held", y="y")
    assert "dt must divide" in clpt.export(clpt.connect([hold, lag], "u"))
    assert "dt must divide" not in clpt.export(control.ss(-1, 1, 1, 0, name="free"))


@needs_cc
@pytest.mark.parametrize("h", [0.025, 0.1])
def test_what_samples_takes_new_inputs_by_begin(h, tmp_path):
    """Samples of t^2 each 0.1, held, and a lag of 0.5 behind them."""
    hold, lag = clpt.parts.hold(0.1, y="held"), clpt.parts.lag(0.5, u="held", y="y")
    made = InC(clpt.connect([hold, lag], "u"), tmp_path)
    assert "where u is new" in made.text
    x, found = made.x0.copy(), []
    for t in h * np.arange(round(1.0 / h) + 1):
        u = np.array([t**2])
        made.call("begin", [t], x, u, made.p)
        found.append(made.computed("outputs", t, x, u))
        made.call("step", [t, h], x, u, made.p)
    samples, y = (0.1 * np.arange(11)) ** 2, [0.0]
    for held in samples[:-1]:
        y.append(held + (y[-1] - held) * np.exp(-0.2))
    at_samples = np.array(found)[:: round(0.1 / h)]
    np.testing.assert_allclose(at_samples[:, 0], samples, atol=1e-12)
    np.testing.assert_allclose(at_samples[:, 1], y, atol=1e-5)


@pytest.mark.long
@needs_cc
def test_no_sample_is_missed_by_the_rounding_of_times(tmp_path):
    h = 0.001
    names = {"name": "count", "states": 1, "inputs": ["u"], "outputs": ["n"]}
    count = control.nlsys(lambda t, x, u, p: [x[0] + 1], None, dt=h, **names)
    lag = control.tf(1, [1, 1], inputs="n", outputs="y", name="lag")
    made = InC(clpt.connect([count, lag], external="u"), tmp_path)
    for t, step, steps in ((0.0, h, 20_000), (90_000.0, h / 4, 8000)):
        # 20 s; after 25 hours
        x, u = np.zeros(made.counts["x"]), np.zeros(1)
        made.call("begin", [t], x, u, made.p)
        for _ in range(steps):
            made.call("step", [t, step], x, u, made.p)
            t += step
        assert x[0] == round(steps * step / h)


CASCADE = """
#include "c.c"
int main(void) {
    REAL x[c_nx], u[1], y[c_ny];
    for (int i = 0; i < c_nx; i++) x[i] = c_x0[i];
    for (long k = 0; k < 7200000; k++) {
        if (k == 20000) k = 3590000;
        if (k == 3610000) k = 7190000;
        REAL t = (REAL)(0.001 * k);
        u[0] = (REAL)(k % 1009);
        c_begin(t, x, u, c_p0);
        c_outputs(t, x, u, c_p0, y);
        if (y[c_y_w] != (REAL)((k - k % 10) % 1009)) return 1;
        if (y[c_y_fast] != 2 * y[c_y_w]) return 2;
        c_step(t, (REAL)0.001, x, u, c_p0);
    }
    return 0;
}
"""


@needs_cc
@pytest.mark.parametrize("single", [False, True])
def test_samples_of_two_rates_keep_their_order_for_two_hours(single, tmp_path):
    """The input is the number of the step: the slow part holds that at which it sampled."""
    slow, fast = (
        control.nlsys(None, output, inputs=u, outputs=y, name=y, dt=dt)
        for output, u, y, dt in (
            (lambda t, x, u, p: u[0], "ref", "w", 0.01),
            (lambda t, x, u, p: 2 * u[0], "w", "fast", 0.001),
        )
    )
    loop = clpt.connect([slow, fast], external="ref", name="c")
    clpt.export(loop, tmp_path / "c.c", single=single)
    main = CASCADE.replace("REAL", "float" if single else "double")
    (tmp_path / "main.c").write_text(main)
    made = tmp_path / "main"
    source = tmp_path / "main.c"
    subprocess.run([COMPILER, "-std=c99", "-O1", "-o", made, source, "-lm"], check=True)
    assert subprocess.run([made]).returncode == 0


@needs_cc
def test_parameters_may_be_changed_but_those_that_were_asked_for(tmp_path):
    made = InC(pendulum(), tmp_path, params={"l": 2.0})
    assert made.p == pytest.approx([9.81, 2.0, 0.3])
    names = re.findall(r"(pendulum_p_\w+),", made.text)
    assert names == [
        "pendulum_p_pendulum_g",
        "pendulum_p_pendulum_l",
        "pendulum_p_pendulum_c",
    ]
    made.p[0] = 1.6
    rates = made.computed("rates", 0.0, np.array([0.5, 0.0]), np.zeros(1))
    assert rates == pytest.approx([0.0, -0.8 * np.sin(0.5)])
    asking = lambda t, x, u, p: [-p["k"] * x[0] if p["n"] > 2 else -x[0]]  # noqa: E731
    params = {"k": 1.0, "n": 3.0}
    text = clpt.export(
        control.nlsys(asking, states=1, inputs=0, params=params, name="a")
    )
    for said in (
        "a_p_a_k,  /* a.k */",
        "a_p_a_n_fixed,  /* a.n fixed */",
        "it is a constant of the code",
    ):
        assert said in text
    lags = [
        control.ss(-2, 1, 1, 0, name=a + b, inputs=a, outputs=b)
        for a, b in ("uv", "vy")
    ]
    # each has its own three
    assert "_np = 6" in clpt.export(clpt.connect(lags, external="u"))


@pytest.mark.long
@needs_cc
def test_a_gridded_field_is_a_table(tmp_path):
    random = np.random.default_rng(5)
    axes = np.linspace(0, 6, 7), np.linspace(-20, 20, 6), np.linspace(-30, 30, 18)
    plane_field(tmp_path / "f.nc", *axes, *random.normal(size=(2, 7, 6, 18)))
    loop = clpt.connect(field_blocks(tmp_path / "f.nc"), external="v_x")
    made = InC(loop, tmp_path)
    assert "static const double T_[]" in made.text
    for t, *x in ((0.0, 1.0, 2.0), (3.3, -25.0, 11.0), (5.9, 3.0, -19.0)):
        rates = loop.dynamics(t, np.array(x), np.array([0.1, 0.2]))
        found = made.computed("rates", t, np.array(x), np.array([0.1, 0.2]))
        assert found == pytest.approx(rates, rel=1e-12, abs=1e-12)


ONE = {"inputs": 0, "states": ["y"], "outputs": ["y"], "name": "plant"}
HELD = control.nlsys(lambda t, x, u, p: -p["a"] * x, params={"a": 1.0}, **ONE)
UNREAD = control.nlsys(lambda t, x, u, p: [float(str(x[0]))], **ONE)
ODD = clpt.Block(
    "odd", update=lambda t, x, u, p: [p.interval], states={"x": 1}, parameters={"interval": -1.0},
    breakpoints=lambda p, t0, t1: [t for t in (1.0, 2.5) if t0 < t <= t1],
)  # fmt: skip


@pytest.mark.parametrize(
    ("system", "given", "said"),
    [
        (clpt.parts.lag(1.0), {"params": {"lag.gain": np.nan}}, "gain = nan"),
        (HELD, {"params": {"a": np.inf}}, "params: a = inf: must be finite"),
        (HELD, {"initial_state": [np.nan]}, "initial_state = .*: must be finite"),
        (ODD, {}, "odd jumps at times that a function"),
        (UNREAD, {}, "plant"),
    ],
)
def test_what_has_no_c_is_said(system, given, said):
    with pytest.raises(clpt.ClptError, match=said):
        clpt.export(system, **given)


def test_what_is_infinite_is_written_as_c_has_it():
    assert "INFINITY" in clpt.export(clpt.parts.pid(1, 0.1))  # no limit of its own
    divides = control.nlsys(
        lambda t, x, u, p: [1 / x[0]], None, name="s", states=1, inputs=0
    )
    assert "1.0 / x[0]" in clpt.export(divides)  # asked at 0, without a warning


# --- random programs ------------------------------------------------------------------------------

PROGRAMS, SLOW_PROGRAMS, IN_A_TEST = 100, 2000, 25
STARTS = [
    *range(0, PROGRAMS, IN_A_TEST),
    *(
        pytest.param(start, marks=pytest.mark.slow)
        for start in range(10_000, 10_000 + SLOW_PROGRAMS, IN_A_TEST)
    ),
]


def system_with_states(seed):
    """Return a random system of python-control that has states."""
    draw = random.Random(seed)
    while True:
        system = random_system(draw, f"program{seed}")
        if system.nstates:
            return system


@pytest.mark.long
@needs_cc
@pytest.mark.parametrize("start", STARTS)
def test_random_programs_in_c_compute_what_python_computes(start, tmp_path):
    """At least four of five are exported; the others are refused."""
    systems = map(system_with_states, range(start, start + IN_A_TEST))
    texts = {}
    for system in systems:
        with suppress(clpt.ClptError):
            texts[system] = clpt.export(system, tmp_path / f"{system.name}.c")
    assert len(texts) >= IN_A_TEST * 4 // 5
    made = tmp_path / "made.so"
    files = [tmp_path / f"{system.name}.c" for system in texts]
    flags = ["-std=c99", "-O0", "-w", "-shared", "-fPIC"]
    subprocess.run([COMPILER, *flags, "-o", made, *files, "-lm"], check=True)
    functions = ctypes.CDLL(str(made))
    for system, text in texts.items():
        compare_in_c(functions, system, text)


def compare_in_c(functions, system, text):
    """Compare the rates of C with those of the function at 160 points."""
    name = re.search(r"(\w+)_nx = ", text)[1]
    sizes = {key: int(n) for key, n in re.findall(rf"{name}_n([xup]) = (\d+)", text)}
    array = ctypes.c_double * max(1, sizes["p"])
    p = array.in_dll(functions, f"{name}_p0") if sizes["p"] else array()
    rates = getattr(functions, f"{name}_rates")
    numbers = np.random.default_rng(len(text))
    pointer = ctypes.POINTER(ctypes.c_double)
    for k in range(160):
        size = (0.1, 1.0, 4.0)[k % 3]
        x, u = (size * numbers.normal(size=max(1, sizes[key])) for key in "xu")
        x[numbers.random(x.shape) < 0.1] = 0.0
        t, found = float(numbers.uniform(0.0, 5.0)), np.zeros(sizes["x"])
        arguments = (*(a.ctypes.data_as(pointer) for a in (x, u)), p)
        rates(ctypes.c_double(t), *arguments, found.ctypes.data_as(pointer))
        with np.errstate(all="ignore"):
            wanted = in_python(system, t, x[: sizes["x"]], u[: sizes["u"]])
        near = 1e-9 * np.nan_to_num(np.abs(found), posinf=1.0).max(initial=1.0)
        alike = (np.abs(found - wanted) <= near) | (found == wanted) | np.isnan(found)
        assert alike.all(), f"{system.name} at {t, x, u}: {found}, Python {wanted}"


def in_python(system, t, x, u):
    """Return the rates of a function; NaN where it raises an error of numbers."""
    try:
        return np.array(system.updfcn(np.float64(t), x.copy(), u.copy(), system.params))
    except (ArithmeticError, ValueError, IndexError, UnboundLocalError):
        return np.full(len(x), np.nan)


@needs_cc
def test_states_jump_at_the_end_of_the_step_that_passes_their_level(tmp_path):
    """A falling count restarts at 1 each time it has fallen below 0, up to one step late."""
    saw = clpt.Block(
        "saw",
        update=lambda t, x, u, p: [-1.0, 0.0],
        states={"left": 1, "turns": 1},
        jump=lambda t, x, u, p: [1.0, x[1] + 1.0],
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    )
    made = InC(saw, tmp_path, initial_state=[1.0, 0.0])
    assert (
        "States of saw jump at the end of the step that passes their level."
        in made.text
    )
    times = 0.003 * np.arange(3500)
    left, turns = made.run(made.x0, np.zeros(1), 0.003, times).T
    assert np.all((left > 0.0) & (left <= 1.0))
    assert turns[-1] == 10.0
    with pytest.raises(clpt.DiagramError, match="saw: jumps at a level"):
        clpt.export(saw, tmp_path / "saw.fmu")


# --- parameters that are changed by their names in C ----------------------------------------------

CHANGED = """
#include "made.c"
#include <stdio.h>
int main(void) {
    double x[NAME_nx + 1], u[NAME_nu + 1] = {0.0}, y[NAME_ny + 1], p[NAME_np + 1];
    for (int i = 0; i < NAME_np; i++) p[i] = NAME_p0[i];
    for (int i = 0; i < NAME_nx; i++) x[i] = NAME_x0[i];
    SET
    BEGIN
    for (int k = 0; k < 2000; k++) {
        NAME_outputs(k / 1000.0, x, u, p, y);
        NAME_step(k / 1000.0, 0.001, x, u, p);
    }
    for (int i = 0; i < NAME_nx; i++) printf("%.17g ", x[i]);
    return sizeof NAME_p0 / sizeof *NAME_p0 != (NAME_np ? NAME_np : 1);
}
"""
SANITIZED = "-std=c99 -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all"


def changed_in_c(system, params, folder):
    """Return the states at t = 2 of a program that sets parameters by the enum, with sanitizers."""
    text = clpt.export(system, folder / "made.c")
    name = re.search(r"(\w+)_nx = ", text)[1]
    words = {
        label: word for word, label in re.findall(r"(\w+_p_\w+),  /\* (.*) \*/", text)
    }
    sets = [
        f"p[{words[label + index]}] = {value!r};"
        for label, values in params.items()
        for index, value in entries(values)
    ]
    begin = f"{name}_begin(0.0, x, u, p);" if f"{name}_begin(" in text else ""
    main = CHANGED.replace("SET", " ".join(sets)).replace("BEGIN", begin)
    (folder / "main.c").write_text(main.replace("NAME", name))
    made = folder / "changed"
    files = ["-o", made, folder / "main.c", "-lm"]
    subprocess.run([COMPILER, *SANITIZED.split(), *files], check=True)
    done = subprocess.run([made], capture_output=True, text=True, check=True)
    return np.array(done.stdout.split(), float)


def entries(values):
    """Return the index in C and the value of each number."""
    values = np.asarray(values)
    return [
        ("".join(f"[{k}]" for k in index), float(value))
        for index, value in np.ndenumerate(values)
    ]


KNOTS, HEIGHTS = [0.0, 0.6, 9.0], [2.0, 3.0, 4.0]


def tables_over_time(jumps=False, samples=False):
    """Blocks before, with and behind two tables over time; the last two may jump or sample."""
    first = clpt.Block(
        "first", outputs={"a": 3}, parameters={"v": [0.1, 0.2, 0.3]},
        output=lambda t, x, u, p: p.v * np.cos(t),
    )  # fmt: skip
    table = clpt.Block(
        "table", outputs={"y": 1}, parameters={"h": 7.0, "k": 0.5},
        output=lambda t, x, u, p: p.h * np.interp(t, KNOTS, HEIGHTS)
        + p.k * np.interp(t - 0.3, HEIGHTS, KNOTS),
    )  # fmt: skip
    lag = clpt.Block(
        "lag", inputs={"y": 1, "a": 3}, states={"x": 1},
        parameters={"m": 0.5, "w": [1.0, 2.0, 3.0]},
        update=lambda t, x, u, p: [u.y[0] - p.m * x[0] + p.w @ u.a],
    )  # fmt: skip
    count = clpt.Block(
        "count", inputs={"y": 1}, states={"n": 1}, parameters={"g": 1.0, "interval": -1.0},
        update=lambda t, x, u, p: [0.0], jump=lambda t, x, u, p: [x[0] + p.g * u.y[0]],
        breakpoints=Each(0.5),
    )  # fmt: skip
    held = clpt.Block(
        "held", inputs={"y": 1}, states={"s": 1}, parameters={"q": 1.0},
        update=lambda t, x, u, p: [x[0] + p.q * u.y[0]],
    )  # fmt: skip
    blocks = [first, *[count] * jumps, table, *[clpt.Sampled(held, 0.5)] * samples, lag]
    return clpt.connect(blocks, name="loop")


@needs_cc
@pytest.mark.parametrize("kinds", [{}, {"jumps": True}, {"samples": True}])
def test_parameters_behind_a_table_over_time_are_changed_by_the_enum(kinds, tmp_path):
    system = tables_over_time(**kinds)
    changed = {
        "lag.m": 1.5,
        "lag.w": [0.3, -1.0, 2.0],
        "table.k": 4.0,
        "first.v": [1.0, 2.0, 5.0],
    }
    changed |= {"count.g": 3.0} if "jumps" in kinds else {}
    changed |= {"held.q": 3.0} if "samples" in kinds else {}
    right = clpt.simulate(system, [0.0, 2.0], params=changed, rtol=1e-10, atol=1e-12)
    found = changed_in_c(system, changed, tmp_path)
    np.testing.assert_allclose(found, right.states.values[-1], rtol=1e-6)
