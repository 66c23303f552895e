"""The learner in C: the numbers of its blocks, of simulations and of a Cortex-M7 in QEMU."""

import ctypes
import re
import shutil
import subprocess
from collections import Counter
from functools import partial, reduce
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from engine_runs import Each
from scipy.linalg import expm
from small_scenarios import FIXES, paper_of
from test_export import InC, library, needs_cc

import clpt_control as clpt

BOARD = Path(__file__).parents[1] / "data" / "board"
PAPER = clpt.paper_scenario()


def of_law(name, **values):
    """Return the paper's scenario with a law of the table."""
    law = clpt.laws()[name]
    own = {"learning.law": name}
    if law.gain is not None:
        own["learning.gain"] = None
    if law.alpha_is_constant:
        own["learning.parameters"] = None
    if law.given_estimate:
        own["learning.theta_estimate"] = [[0.1, -0.2, 0.3], [0.3, 0.2, -0.1]]
    if law.at_fixes:
        own |= FIXES
    return PAPER.with_values({**own, **values})


class OnBoard(InC):
    """A learner in C, compiled."""

    def __init__(self, system, folder, **given):
        super().__init__(system, folder, part="learner", **given)
        self.inputs = re.findall(r"/\* (\w+)\[\d\] \*/", self.enum("u"))
        self.inputs = list(dict.fromkeys(self.inputs))

    def enum(self, letter):
        """Return the enum of states, inputs or outputs."""
        return next(
            enum
            for enum in self.text.split("enum {")
            if f"{self.name}_n{letter} =" in enum
        )

    def steps(self, times, u, held=False):
        """Return the state after each step; inputs are straight lines, or held."""
        x = self.x0.copy()
        states = []
        u = np.ascontiguousarray(u)
        for k, (t, t_next) in enumerate(pairwise(times)):
            u_next = u[k] if held else u[k + 1]
            self.call("step", [t, t_next - t], x, u[k], u_next, self.p)
            states.append(x.copy())
        return np.array(states)


def inputs_of(run, names):
    """Return the inputs of a learner along a run, a row for each time."""
    variables = {"x": "position", "zc": "reference"}
    if "commanded_velocity" in run:
        variables |= {"v_x": "velocity", "v_c": "commanded_velocity"}
    return np.hstack([run[variables.get(name, name)].values for name in names])


def runge_kutta(rates, x, times, u):
    """Return the state after each step of the method of order 4, inputs on straight lines."""
    states = []
    for k, (t, t_next) in enumerate(pairwise(times)):
        h = t_next - t
        middle = 0.5 * (u[k] + u[k + 1])
        k_1 = rates(t, x, u[k])
        k_2 = rates(t + h / 2, x + h / 2 * k_1, middle)
        k_3 = rates(t + h / 2, x + h / 2 * k_2, middle)
        k_4 = rates(t + h, x + h * k_3, u[k + 1])
        x = x + h / 6 * (k_1 + 2 * k_2 + 2 * k_3 + k_4)
        states.append(x)
    return np.array(states)


def compared(scenario, folder, duration, h, **export):
    """Return the largest difference of a learner in C from python-control's rates."""
    scenario = scenario.with_values({"run.duration": duration, "run.output_step": h})
    run = clpt.simulate(clpt.closed_loop(scenario))
    learner = OnBoard(clpt.closed_loop(scenario, external="zc"), folder, **export)
    u = inputs_of(run, learner.inputs)
    times = run.time.values
    diagram = clpt.closed_loop(scenario, external=learner.inputs)
    order = [
        diagram.input_labels.index(f"{p}[{k}]") for p in learner.inputs for k in (0, 1)
    ]
    assert order == list(range(len(order)))
    in_python = runge_kutta(diagram.dynamics, learner.x0, times, u)
    in_c = learner.steps(times, u)
    return np.abs(in_c - in_python).max() / max(1.0, np.abs(in_python).max())


@needs_cc
@pytest.mark.parametrize(
    "name", [n for n in clpt.laws() if n not in ("fix-regression", "concurrent")]
)
def test_each_law_has_the_numbers_of_its_blocks(name, tmp_path):
    assert compared(of_law(name), tmp_path, 2.0, 0.02) <= 1e-12


@pytest.mark.long
@needs_cc
def test_a_limited_speed_gives_the_commanded_velocity_as_an_input(tmp_path):
    limited = of_law("composite-memory", **{"vehicle.max_speed": 1.2})
    assert compared(limited, tmp_path, 4.0, 0.04) <= 1e-12
    assert "learner_u_v_c_1," in clpt.export(limited, part="learner")


@needs_cc
@pytest.mark.parametrize("end", [250.0, pytest.param(2000.0, marks=pytest.mark.slow)])
@pytest.mark.sampled
def test_the_papers_run_has_the_numbers_of_its_blocks(tmp_path, end):
    assert compared(PAPER, tmp_path, end, 0.5) <= 1e-12


# --- samples, windows and fixes ---------------------------------------------------------------


def moving(t, x, u, p):
    """x and v_x of a vehicle on a circle, held for the time h."""
    angle = 0.3 * p.interval * p.h
    return {
        "x": [3 * np.cos(angle), 3 * np.sin(angle)],
        "v_x": [np.sin(2 * angle), np.cos(angle)],
    }


def held_track(h):
    """Return a source of held positions and velocities."""
    return clpt.Block(
        "track",
        output=moving,
        outputs={"x": 2, "v_x": 2},
        parameters={"h": h, "interval": -1.0},
        breakpoints=Each("h"),
    )


@pytest.mark.long
@needs_cc
@pytest.mark.parametrize(
    ("law", "values"),
    [
        ("learned-flow", {"learning.sample": 0.1}),
        ("composite-memory", {"learning.sample": 0.1}),
        ("concurrent", {"learning.concurrent.window": 2.5}),
    ],
)
def test_samples_and_windows_are_those_of_the_simulation(law, values, tmp_path):
    """Inputs are held for 0.5; steps of 0.05 differ by 1e-4 of the states, of 0.025 by a 14th."""
    scenario = of_law(law, **values)
    errors = []
    for h in (0.05, 0.025):
        learner = OnBoard(scenario, tmp_path)
        steps = round(60.25 / h)
        times = h * np.arange(steps + 1)
        track = {"h": 0.5, "interval": np.floor(times / 0.5 + 1e-9)}
        both = moving(0.0, None, None, type("Track", (), track))
        u = np.vstack([row for port in learner.inputs for row in both[port]]).T
        blocks = clpt.closed_loop(scenario, external=learner.inputs).syslist
        loop = clpt.connect([held_track(0.5), *blocks])
        start = learner.x0
        run = clpt.simulate(loop, [0, 7.25, 60.25], 0.0, start, rtol=1e-11, atol=1e-13)
        states = learner.steps(times, u, held=True)[[round(7.25 / h) - 1, -1]]
        wanted = run.states.values[1:]
        errors.append(np.abs(states - wanted).max() / np.abs(wanted).max())
    assert errors[0] <= 1e-4
    assert errors[1] <= errors[0] / 14


@needs_cc
def test_fixes_are_those_of_the_simulation(tmp_path):
    """The vehicle flies a velocity for 0.5 each; a third of the fixes is missing."""
    fixes = {"interval": 5.0, "noise": 0.1, "dropouts": 0.3, "seed": 3}
    times = {"run.duration": 102.5, "run.output_step": 0.5}
    tight = {"run.rtol": 1e-11, "run.atol": 1e-13}
    scenario = of_law("fix-regression", **{**times, **tight, "localization": fixes})
    hold = clpt.parts.hold(0.5, signals=2, u="v_x", y="v_x_hold")
    run = clpt.simulate(clpt.closed_loop(scenario, insert={"v_x": hold}))
    taken = np.flatnonzero(
        run.taken.values.ravel() * np.isin(run.time, 5.0 * np.arange(1, 21))
    )
    assert 10 <= len(taken) <= 18
    learner = OnBoard(scenario, tmp_path)
    assert learner.inputs == ["fix", "v_x"]
    u = np.hstack([run.fix.values, run.v_x_hold.values])
    errors = []
    for count in (4, 8, 16):
        x = learner.x0.copy()
        h = 0.5 / count
        for k, t in enumerate(run.time.values[:-1]):
            held = u[k].copy()
            if k in taken:
                learner.call("fix", [t], x, held, learner.p)
            for step in range(count):
                start = t + step * h
                learner.call("step", [start, h], x, held, held, learner.p)
        learned = dict(zip(labels(learner, "x"), x, strict=True))
        z = [learned[f"adaptation_z[{k}]"] for k in range(2)]
        alpha = [learned[f"adaptation_alpha[{k}]"] for k in range(6)]
        errors.append(
            max(
                np.abs(z - run.predicted_position.values[-1]).max(),
                np.abs(alpha - run.alpha.values[-1].ravel()).max(),
            )
        )
    assert errors[0] <= 1e-7
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert np.all(orders > 3.7), errors


@needs_cc
def test_a_fix_that_is_not_finite_or_beyond_the_gate_leaves_the_states(tmp_path):
    """The function returns 0; without a gate a far fix is learned."""
    program = """
    #include "learner.c"
    #include <stdio.h>
    int main(void) {
        double x[learner_nx], u[learner_nu] = {0.0};
        for (int i = 0; i < learner_nx; i++) x[i] = learner_x0[i];
        learner_step(0.0, 0.1, x, u, u, learner_p0);
        double fixes[3] = {NAN, INFINITY, x[learner_x_adaptation_z_0] + 60.0};
        for (int k = 0; k < 3; k++) {
            u[learner_u_fix_0] = fixes[k];
            double before = x[learner_x_adaptation_P_0];
            int learned = learner_fix(0.1, x, u, learner_p0);
            printf("%d %d ", learned, x[learner_x_adaptation_P_0] == before);
        }
        return 0;
    }
    """
    scenario = of_law("fix-regression", localization={"interval": 5.0})
    text = clpt.export(scenario, tmp_path / "learner.c", part="learner")
    assert "the flow must turn by less than about 1 radian between fixes" in text
    words = " ".join(text.replace("\n *", "").split())
    # the root of 3^(1/2) (e^x - 1 - x) = x is 0.8513
    said = (
        "For a fix each 5 s: a bound lasts only where the shear of the flow times the "
    )
    assert said + "interval is below 0.851" in words
    assert "fix_regression_bound" in words
    (tmp_path / "main.c").write_text(program)
    for gate, last in (([], [1, 0]), (["-Dlearner_gate=50.0"], [0, 1])):
        flags = "-std=c99", "-O1", *gate, "main.c", "-o", "main", "-lm"
        output_of("cc", *flags, folder=tmp_path)
        told = [int(word) for word in output_of("./main", folder=tmp_path).split()]
        assert told == [0, 1, 0, 1, *last]


def labels(learner, letter):
    """Return the labels of an enum."""
    return re.findall(r"/\* (\S+) \*/", learner.enum(letter))


# --- the transition matrix beside the learner -------------------------------------------------


@pytest.fixture(scope="module")
def watched():
    """The paper's scenario for 200 s, and blocks that carry Phi, begun again each 50 s."""
    scenario = PAPER.with_values({"run.duration": 200.0, "run.output_step": 0.1})
    return scenario, clpt.gramian(scenario, 50.0, 0.0).watch


def papers_norms(run, windows):
    """|Phi| of each axis at ends of windows and in each, by SciPy's expm at middles of steps."""
    gains, norms = np.sqrt(PAPER.learning.gain), []
    k = PAPER.vehicle.feedback[0]
    for i in (0, 1):
        own = run.predicted_position, run.reference
        w = [run.phi_x.values, *(signal.values[:, [i]] for signal in own)]
        w = gains * np.hstack(w)[1::2]
        M = np.zeros((len(w), 6, 6))
        M[:, 0, 0], M[:, 0, 1:], M[:, 1:, 0] = -k, w, -w
        steps = expm(0.1 * M)
        along, each = np.eye(6), len(w) // windows
        for begin in range(0, len(w), each):
            Phi = reduce(lambda Y, step: step @ Y, steps[begin : begin + each])
            along = Phi @ along
            norms.append([np.linalg.norm(along, 2), np.linalg.norm(Phi, 2)])
    return np.array(norms).reshape(2, windows, 2).swapaxes(0, 1)


@pytest.mark.long
@needs_cc
@pytest.mark.parametrize("single", [False, True])
def test_the_matrix_on_board_is_that_of_scipy(single, watched, tmp_path):
    scenario, watch = watched
    run = clpt.simulate(clpt.closed_loop(scenario), np.linspace(0, 200, 4001))
    times, u = run.time.values[::2], run.position.values[::2]
    norms = papers_norms(run, 4)
    learner = OnBoard(scenario, tmp_path, watch=watch)
    kind = ctypes.c_float if single else ctypes.c_double
    if single:
        text = clpt.export(
            scenario, tmp_path / "made.c", part="learner", watch=watch, single=True
        )
        assert "double" not in text
        (tmp_path / "single").mkdir()
        functions = library(text.encode(), tmp_path / "single")
    else:
        functions = learner.library
    number = np.float32 if single else np.float64
    x, u = learner.x0.astype(number), u.astype(number, order="C")
    p, y = ctypes.byref(kind.in_dll(functions, "made_p0")), np.zeros(200, number)
    places = [
        [labels(learner, "y").index(f"{name}_x{k}") for name in ("factor", "worst")]
        for k in (1, 2)
    ]

    def pointers(*arrays):
        return (array.ctypes.data_as(ctypes.POINTER(kind)) for array in arrays)

    worst = np.zeros(2)
    for k, t in enumerate(times[:-1]):
        functions.made_step(kind(t), kind(0.1), *pointers(x, u[k], u[k + 1]), p)
        if k % 500 == 499:
            j = k // 500
            (tail,) = pointers(y)
            functions.made_outputs(kind(times[k + 1]), *pointers(x, u[k + 1]), p, tail)
            factor, shown = y[places].T
            # the bound of the norm is at most 6^(1/64) too large
            assert np.all(factor > norms[j, :, 0] * (1 - 1e-3))
            assert np.all(factor < norms[j, :, 0] * 6 ** (1 / 64) * (1 + 1e-3))
            # windows that have ended at the beginning of the step
            assert shown == pytest.approx(worst, rel=0.1)
            worst = np.maximum(worst, norms[j, :, 1])


def test_watch_is_of_a_learner():
    watch = clpt.gramian(PAPER, 200.0).watch
    with pytest.raises(clpt.ClptError, match="watch: is of part='learner'"):
        clpt.export(PAPER, watch=watch)
    given = {"part": "learner", "params": {"adaptation.gain": 2.0}}
    with pytest.raises(clpt.ClptError, match="watch: has the numbers of its gramian"):
        clpt.export(PAPER, watch=watch, **given)


# --- altered signs, and what is refused -------------------------------------------------------


@pytest.mark.long
@needs_cc
def test_altered_signs_are_found(tmp_path):
    """A minus of the rates, made a plus, changes the numbers; phi(z) cancels in Eq. (8)."""
    centers = {"basis.centers": [[1.0, 2.0], [10.0, 9.0], [5.0, 4.0]]}
    scenario = paper_of(3, **centers)
    text = clpt.export(scenario, part="learner")
    begin, end = text.index("rates_("), text.index("static void signals_")
    places = enumerate(re.findall(r"/\* (\S+) \*/", text[text.index("_x1_0,") : begin]))
    centers_z = [k for k, label in places if label.startswith("basis_z.centers")]
    cancels = rf" - p\[({'|'.join(map(str, centers_z))})\b"
    found = re.finditer(rf"(?!{cancels}) - ", text[:end])
    signs = [minus.start() for minus in found if minus.start() > begin]
    for place in np.random.default_rng(2).choice(signs, 10, replace=False):
        folder = tmp_path / str(place)
        folder.mkdir()
        altered = f"{text[:place]} + {text[place + 3 :]}"

        def written(system, path, altered=altered, **given):
            path.write_text(altered.replace("learner_", "made_"))
            return path.read_text()

        found = compared(scenario, folder, 5.0, 0.05, export=written)
        assert not found <= 1e-6, altered


LATE = {"localization": {"interval": 5.0, "latency": 1.0}}


@pytest.mark.parametrize(
    ("system", "given", "said"),
    [
        (of_law("fix-regression", **LATE), {}, "localization.latency: .* Set it to 0"),
        (clpt.parts.lag(1.0), {}, "lag: has no learner. Give a scenario"),
        (PAPER, {"path": "learner.fmu"}, "must end in .c or .h"),
        (PAPER, {"path": "loop.fmu", "part": None, "single": True}, "end in .c or .h"),
        (PAPER, {"part": "model"}, "part = 'model': must be 'learner'"),
        (PAPER, {"params": {"vehicle.mass": 1.0}}, "unknown parameter 'vehicle.mass'"),
    ],
)
def test_learners_that_have_no_c_are_refused(system, given, said):
    with pytest.raises(clpt.ClptError, match=said):
        clpt.export(system, **{"part": "learner", **given})


def test_the_head_names_inputs_units_and_proofs():
    limited = of_law("composite-memory", **{"vehicle.max_speed": 2.0})
    text = clpt.export(limited, part="learner")
    for said in (
        "x[2]: measured position, m\n",
        "v_c[2]",
        "as flown, m s-1",
        "clpt prove",
    ):
        assert said in text
    assert "Coq" not in text  # its theorems are on unlimited speed
    text = clpt.export(of_law("sigma"), part="learner")
    assert "theorems\n * sigma_rate, sigma_bounded (LawSigma.v)." in text
    assert "do not cover samples" in clpt.export(
        of_law("sigma", **{"learning.sample": 1.0}), part="learner"
    )


def test_an_own_law_and_an_own_part_are_on_board():
    from law_blocks import papers_law

    loop = clpt.closed_loop(
        PAPER, law=papers_law(), replace={"vehicle": clpt.paper_blocks(PAPER)[6]}
    )
    text = clpt.export(loop, part="learner")
    assert "parts of your own" in text
    assert "flow_x" not in text


@pytest.mark.long
@needs_cc
def test_single_precision_errs_by_1e_4_after_the_papers_run(tmp_path):
    run = clpt.simulate(PAPER.with_values({"run.output_step": 0.1}))
    u = run.position.values
    double = OnBoard(PAPER, tmp_path).steps(run.time.values, u)[-1]
    text = clpt.export(PAPER, tmp_path / "made.c", part="learner", single=True)
    assert "double" not in text
    code = '#pragma GCC diagnostic error "-Wdouble-promotion"\n' + text
    folder = tmp_path / "single"
    folder.mkdir()
    functions = library(code.encode(), folder)
    pointer = ctypes.POINTER(ctypes.c_float)
    x = np.zeros(12, np.float32)
    u = u.astype(np.float32, order="C")
    p = ctypes.byref(ctypes.c_float.in_dll(functions, "made_p0"))
    for k, t in enumerate(run.time.values[:-1]):
        arrays = (array.ctypes.data_as(pointer) for array in (x, u[k], u[k + 1]))
        functions.made_step(ctypes.c_float(t), ctypes.c_float(0.1), *arrays, p)
    difference = np.abs(x - double).max()
    assert 1e-7 < difference < 1e-4


# --- a Cortex-M7 ------------------------------------------------------------------------------

TOOLS = ("arm-none-eabi-gcc", "arm-none-eabi-size", "qemu-system-arm")
MISSING = [tool for tool in TOOLS if shutil.which(tool) is None]
M7 = [
    "-std=c99",
    "-O2",
    "-mcpu=cortex-m7",
    "-mfpu=fpv5-d16",
    "-mfloat-abi=hard",
    "-mthumb",
]
MACHINE = "-M mps2-an500 -cpu cortex-m7 -nographic -semihosting-config enable=on,target=native"
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffreestanding"]
MAIN = """
#include <stdio.h>
#include "learner.c"
int main(void) {
    double x[learner_nx], u[learner_nu] = {0.0}, u_next[learner_nu], t = 0.0;
    for (int i = 0; i < learner_nx; i++) x[i] = learner_x0[i];
    for (int k = 0; k < 20000; k++) {
        t = 0.1 * k;
        for (int i = 0; i < learner_nu; i++) u[i] = 3.0 * cos(0.03 * t + i);
        for (int i = 0; i < learner_nu; i++) u_next[i] = 3.0 * cos(0.03 * (t + 0.1) + i);
        FIX
        learner_step(t, 0.1, x, u, u_next, learner_p0);
    }
    for (int i = 0; i < learner_nx; i++) printf("%.17g ", x[i]);
    return 0;
}
"""


def output_of(*command, folder):
    """Return what a command prints."""
    words = [str(word) for word in command]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=True)
    return done.stdout


@pytest.mark.board
@pytest.mark.skipif(
    bool(MISSING),
    reason=f"{', '.join(MISSING)}: not installed. Install gcc-arm-none-eabi, "
    "libnewlib-arm-none-eabi and qemu-system-arm",
)
@pytest.mark.parametrize(
    "law", ["learned-flow", "composite-memory", "fix-regression", "watched"]
)
def test_a_cortex_m7_has_the_numbers_of_this_machine(law, watched, tmp_path):
    """Equal to 1e-12, relative for states above 1, after 20,000 steps; prints sizes."""
    run = partial(output_of, folder=tmp_path)
    scenario, watch = watched if law == "watched" else (of_law(law), ())
    text = clpt.export(scenario, tmp_path / "learner.c", part="learner", watch=watch)
    fix = "if (k % 50 == 49) learner_fix(t, x, u, learner_p0);"
    main = MAIN.replace("FIX", fix if "learner_fix" in text else "")
    (tmp_path / "main.c").write_text(main)
    run("cc", "-std=c99", "-O2", "main.c", "-o", "main", "-lm")
    run("arm-none-eabi-gcc", *M7, *STRICT, "-c", "learner.c")
    size = run("arm-none-eabi-size", "learner.o").splitlines()[1].split()
    files = BOARD / "start.c", "main.c", "-lm"
    link = "--specs=rdimon.specs", "-nostartfiles", "-T", BOARD / "m7.ld"
    run("arm-none-eabi-gcc", *M7, *link, *files, "-o", "learner.elf")
    host = np.array(run("./main").split(), float)
    board = np.array(
        run("qemu-system-arm", *MACHINE.split(), "-kernel", "learner.elf").split(),
        float,
    )
    difference = (np.abs(board - host) / np.maximum(1.0, np.abs(host))).max()
    print(f"{law}: largest relative difference {difference:.1e}; code {size[0]} bytes,")
    print(f"    state {8 * len(host)} bytes, in a step {operations(text)}")
    assert difference <= 1e-12


def operations(text):
    """Return the operations of a step as text, with four evaluations of the rates."""
    n = int(re.search(r"_nx = (\d+)", text)[1])
    counts = Counter(
        multiplications=6 * n, additions=7 * n
    )  # of Runge and Kutta's method
    loops = []
    for line in text[text.index("rates_(double") :].splitlines():
        if line == "}":
            break
        depth = (len(line) - len(line.lstrip())) // 4 - 1
        loops = loops[:depth]
        if length := re.search(r"i\d < (\d+);", line):
            loops.append(int(length[1]))
            continue
        times = 4 * int(np.prod(loops))
        value = line.partition("=")[2]
        counts["multiplications"] += times * len(
            re.findall(r" \* (?![\w +]*\])", value)
        )
        counts["additions"] += times * (
            len(re.findall(r" [+-] (?![\w +*]*\])", value)) + ("+=" in line)
        )
        counts["divisions"] += times * value.count(" / ")
        for name in ("exp", "cos", "sqrt"):
            counts[name] += times * len(re.findall(rf"\b{name}\(", value))
    return ", ".join(f"{count} {name}" for name, count in counts.items() if count)
