"""Files of Coq of verdicts: refusals, sentence against file; those marked `coq` need coqc."""

import re

import control
import pytest
import sympy
from coq_files import REALS, compiled
from judged_loops import RIGHT, WRONG
from lyapunov_cases import CASES
from small_scenarios import paper_of
from test_ends import BROKEN, HELD
from text_systems import written
from user_laws import FOR_TWO
from user_laws import RIGHT as OWN_LAWS

import clpt_control as clpt
from clpt_control.theory.proofs.conclusions import CONCLUSIONS, REQUIREMENTS

# a box, what V stays below, and what is not in the file
REGIONS = {
    "a cube": ("x' = -x + x**3; V = x**2", {"x": (-2, 2)}, "1999/2000", ""),
    "a product": (
        "x' = -x + x*y; y' = -y; V = x**2 + y**2", {"x": (-2, 2), "y": (-2, 2)}, "", "region",
    ),
}  # fmt: skip
# one of each kind -> its equations, its conclusion, and what is not in its file
SAMPLE = {
    "a hard spring": (
        "x' = v; v' = -a*x - b*x**3 - d*v; V = v**2/2 + a*x**2/2 + b*x**4/4; a = 1; b = 2; d = 3",
        "asymptotically stable",
        "",
    ),
    "a divisor": ("x' = -x/(1 + x**2)", "asymptotically stable", ""),
    "a rest elsewhere": (
        "x' = 3 - x; V = (x - 3)**2/2; at x = 3", "asymptotically stable", "",
    ),
    "a cross term": (
        "x' = y; y' = -x - y; V = 3*x**2/2 + x*y + y**2", "asymptotically stable", "",
    ),
    "tanh": ("x' = -tanh(x)", "asymptotically stable", ""),
    "a pendulum": (
        "x' = v; v' = -sin(x) - v; V = v**2/2 + 1 - cos(x)", "comes to rest", "isolated",
    ),
    "an adaptive law": (
        "e' = -e + h*r; h' = -e*r; V = e**2/2 + h**2/2; input r", "goes to zero", "",
    ),
    "a circle": ("x' = y; y' = -x; V = x**2/2 + y**2/2", "stable", ""),
    "a sine of twice the angle": (
        "x' = v; v' = -3*v - sin(2*x); V = v**2 + 1 - cos(2*x)", "comes to rest", "isolated",
    ),
    "an exponential": (
        "x' = -a*(exp(x) - 1); V = exp(x) - x - 1; a = 2",
        "asymptotically stable",
        "rest",
    ),
    "a root": ("x' = -x/sqrt(1 + x**2)", "asymptotically stable", ""),
    "a gain of time": ("x' = -(1 + t)*x; V = x**2/2", "asymptotically stable", "rest"),
    "a gain that rises": ("x' = -(2 - exp(-t))*x", "asymptotically stable", "rest"),
    "a gain that dies": ("x' = -x/(1 + t)**2; V = x**2/2", "stable", ""),
    "a spring of |s| s": (
        "x' = v; v' = -3*abs(x)*x - v; V = v**2/2 + abs(x)*x**2",
        "asymptotically stable",
        "rest",
    ),
    "a soft modulus": (
        "x' = v; v' = -v - x/(1 + abs(x)); V = v**2/2 + abs(x) - log(1 + abs(x))",
        "asymptotically stable",
        "",
    ),
    "a divisor with a modulus": (
        "x' = -x/(1 + abs(x)); V = x**2/2", "asymptotically stable", "",
    ),
    "a logarithm": ("x' = -x; V = log(1 + x**2)", "asymptotically stable", "all"),
    "a logarithm of cosh": (
        "x' = v; v' = -tanh(x) - v; V = v**2/2 + log(cosh(x))",
        "asymptotically stable",
        "all",
    ),
    "a sine that stays off zero": (
        "x' = -x/(2 + sin(y)); y' = 1 + 0*x; V = x**2/2", "goes to zero", "",
    ),
    "a root in V": (
        "x' = -x; V = sqrt(1 + x**2) - 1", "asymptotically stable", "",
    ),
    "sinh": ("x' = -sinh(x); V = x**2/2", "asymptotically stable", ""),
    "atan": ("x' = -arctan(x); V = x**2/2", "asymptotically stable", ""),
    "cosh": (
        "x' = v; v' = -v - sinh(x); V = v**2/2 + cosh(x) - 1",
        "asymptotically stable",
        "",
    ),
    "a product in a form": (
        "x' = -x - y*z; y' = -y; z' = -z; V = (x - y*z)**2/2 + y**2/2 + z**2/2",
        "asymptotically stable",
        "",
    ),
    "a reference model": (
        "y' = -y + h*r; m' = -m + r; h' = -(y - m)*r; V = (y - m)**2/2 + (h - 1)**2/2; input r",
        "goes to zero",
        "",
    ),
    "a weight of either sign": ("x' = b*x; V = -b*x**2/2; b = -1", "asymptotically stable", ""),
    "a gain divided by cosh(t)": ("x' = -x/cosh(t); V = x**2/2", "stable", ""),
    "a gain divided by cosh(x)": ("x' = -x/cosh(x)", "asymptotically stable", ""),
    "log cosh": (
        "x' = -sinh(x)/cosh(x); V = log(cosh(x))", "asymptotically stable", "all rest",
    ),
    "the square of atan": (
        "x' = -x*(1 + x**2); V = arctan(x)**2", "comes to rest",
        "still isolated",
    ),
    "the square of atan, bounded": (
        "x' = -x; V = arctan(x)**2", "comes to rest",
        "still isolated",
    ),
    "a damping tanh(t)": (
        "x' = v; v' = -x - tanh(t)*v; V = (x**2 + v**2)/2", "stable", "",
    ),
    "a damping atan(t)": (
        "x' = v; v' = -x - arctan(t)*v; V = (x**2 + v**2)/2", "stable", "",
    ),
    "a damping with t": (
        "x' = v; v' = -x - (2 + sin(t) + 0.001*t)*v; V = (x**2 + v**2)/2",
        "square-integrable",
        "",
    ),
    "a damping with a root": (
        "x' = v; v' = -x - sqrt(abs(v))*v; V = (x**2 + v**2)/2",
        "asymptotically stable",
        "rest",
    ),
    "exponentials of two states": (
        "x' = 1 - exp(y); y' = exp(x) - 1 - (exp(y) - 1)/2; V = exp(x) - x + exp(y) - y - 2",
        "asymptotically stable",
        "rest",
    ),
    "a gain 2 + sin(t)": ("x' = -(2 + sin(t))*x", "asymptotically stable", ""),
    "a damping 2 + sin(t)": (
        "x' = v; v' = -x - (2 + sin(t))*v; V = (x**2 + v**2)/2", "goes to zero", "",
    ),
    "a damping sin(t)^2": (  # the rate of v sin(t) has the term v cos(t)
        "x' = v; v' = -x - sin(t)**2*v; V = (x**2 + v**2)/2", "goes to zero", "rates",
    ),
    "two losses of a state": (
        "x' = -x*(1 + y**2); y' = -(2 + sin(t))*y; V = x**4 + y**2", "asymptotically stable", "",
    ),
    "a wave of a frequency": ("x' = -(2 + sin(t*w))*x; w = 3", "asymptotically stable", ""),
    "a negative divisor": ("x' = x/b; V = x**2/2; b = -1", "asymptotically stable", ""),
    "a function that rises": (
        "x' = -x - exp(x) + exp(y); y' = -y + exp(x) - exp(y); V = x**2/2 + y**2/2",
        "stable",
        "",
    ),
    "a cube that pulls back": (
        "x' = 2*x - x**3; V = x**2/2", "ultimately bounded", "",
    ),
    "a leak": (
        "e' = -e + h*r; h' = -e*r - h - 1; V = e**2/2 + h**2/2; input r",
        "ultimately bounded",
        "",
    ),
}  # fmt: skip
TRUSTED = {"values", "running", "exists", "jumps"}  # the record, and that runs go on
NO_FILE = {
    "a clip": ("x' = -np.clip(x, -1, 1)".replace("np.", ""), "has pieces"),
    "a sign": ("x' = -x - sign(x)", "has pieces"),
    "a modulus in V": ("x' = -x; V = abs(x)**3*x**2", "has pieces"),
    "a choice": ("x' = -x*where(x > 0, 1, 2)", "has pieces"),
}  # fmt: skip


def judged(name):
    plant, V, *rest = written(SAMPLE[name][0])
    return clpt.lyapunov(plant, V, **dict(*rest))


def judged_in_region(name):
    text, box = REGIONS[name][:2]
    plant, V = written(text)[:2]
    return clpt.lyapunov(plant, V, within=box)


def missing(verdict):
    """What the conclusion requires and the last theorem does not say, by its comment."""
    words = re.findall(r"Not in it, and shown by clpt-control: (.*)\.", verdict.coq())
    return {name for name, text in REQUIREMENTS.items() if text in words}


@pytest.mark.parametrize("name", SAMPLE)
def test_file_says_what_the_sentence_says(name):
    verdict = judged(name)
    _, conclusion, not_in_it = SAMPLE[name]
    assert verdict.status == "proved"
    assert verdict.implies(conclusion)
    assert missing(verdict) - TRUSTED == {*not_in_it.split()}
    text = verdict.coq()
    last = text[text.rindex("(* The verdict: ") :]
    sentence = verdict.statement.whole  # with all names, which the line may cut
    assert verdict.sentence.partition(" ...")[0].rstrip(",") in sentence
    assert " ".join(sentence.split()) in " ".join(last.split())
    assert last.count("Theorem verdict :") == 1
    assert ".." not in last.replace("...", "")
    assert text.rstrip().endswith("Print Assumptions verdict.")
    assert not re.search(r"\b(Admitted|Axiom|Parameter|Abort)\b", text)


@pytest.mark.sampled
@pytest.mark.parametrize("name", REGIONS)
def test_file_of_a_region_says_what_is_not_left(name):
    verdict = judged_in_region(name)
    level, not_in_it = REGIONS[name][2:]
    assert missing(verdict) - TRUSTED == {*not_in_it.split()}
    assert "exists" in missing(verdict)
    assert "runs that begin there stay in it" in {s.claim for s in verdict.beyond_coq()}
    text = verdict.coq()
    start = re.search(r"begins : .* < (\d+/\d+) }", text)[1]
    assert f"V i t < {start})" in text[text.rindex("Theorem verdict :") :]
    assert level in ("", start)
    assert sympy.Rational(start) <= sympy.Rational(f"{verdict.level}")


@pytest.mark.parametrize("name", NO_FILE)
def test_pieces_are_refused(name):
    text, reason = NO_FILE[name]
    plant, V = written(text)[:2]
    verdict = clpt.lyapunov(plant, V)
    assert verdict.status == "proved"
    with pytest.raises(clpt.DiagramError, match=reason):
        verdict.coq()


def test_what_jumps_or_is_not_in_time_is_refused(tmp_path):
    discrete = control.nlsys(
        lambda t, x, u, p: [x[0] / 2], states=["x"], inputs=0, dt=1.0, name="d"
    )
    jumping = RIGHT["a state that is reset"]
    for verdict, reason in (
        (clpt.lyapunov(jumping.plant, jumping.V), "jump"),
        (clpt.lyapunov(discrete, lambda s: s.x**2), "discrete"),
    ):
        assert verdict.status == "proved"
        with pytest.raises(clpt.DiagramError, match=reason):
            verdict.coq(tmp_path / "mine.v")
    assert [*tmp_path.iterdir()] == []


def lag(t, x, u, p):
    """A state of V, and one that follows it."""
    return [-x[0], -x[1] + x[0]]


def test_bounded_states_outside_V_are_in_the_theorem():
    plant = control.nlsys(lag, states=["x", "y"], inputs=0, outputs=0, name="lag")
    theorem = (
        clpt.lyapunov(plant, lambda s: s.x**2 / 2).coq().split("(* The verdict")[1]
    )
    assert "bounded (T i) (r_y i)" in theorem.replace("r_lag'y", "r_y")


@pytest.mark.long
def test_comment_of_a_law_names_its_own_conditions():
    comment = clpt.prove("sigma").coq().split("(* The verdict")[1].split("*)")[0]
    assert "The number N of functions is that of this file." in comment
    assert (
        "Not in it, and shown by clpt-control: x is not held by V, and bounded."
        in comment
    )
    assert "Assumed to be bounded" not in comment
    comment = clpt.prove("learned-flow").coq().split("(* The verdict")[1]
    assert "Assumed to be bounded, with the names of the file: phi_x" in comment


def test_what_is_not_proved_is_refused():
    plant, V = written("x' = x")[:2]
    with pytest.raises(clpt.DiagramError, match="nothing is proved"):
        clpt.lyapunov(plant, V).coq()


def texts():
    """The written systems of the tests of ends."""
    for rows in (*BROKEN.values(), *HELD.values()):
        yield from (row[0] for row in rows)


def compared(verdict):
    """Compare a proved verdict with its file; False if it has none."""
    try:
        steps = verdict.beyond_coq()
    except clpt.DiagramError:
        return False
    assert all(step.holds for step in steps)
    by_steps = {name for step in steps for name in step.shows.split()}
    required = CONCLUSIONS[verdict.conclusion].requires
    # what no step shows is given: a loop without states that jump
    assert missing(verdict) - by_steps <= {"jumps"} <= required | {"jumps"}
    return True


@pytest.mark.long
def test_verdicts_are_stronger_than_their_files_by_steps_alone():
    cases = [(c.plant, c.V, c.more) for c in CASES.values() if c.status == "proved"]
    cases += [
        (c.plant, c.V, c.more) for c in (*RIGHT.values(), *WRONG.values()) if c.true
    ]
    for text in texts():
        plant, V, *rest = written(text)
        cases.append((plant, V, dict(*rest)))
    with_file = 0
    for plant, V, more in cases:
        verdict = clpt.lyapunov(plant, V, **more | {"points": 5})
        with_file += verdict.status == "proved" and compared(verdict)
    assert with_file > 100


@pytest.mark.long
@pytest.mark.parametrize("name", [*OWN_LAWS, *FOR_TWO])
def test_verdicts_on_own_laws(name):
    verdict = clpt.prove({**OWN_LAWS, **FOR_TWO}[name](), points=50)
    assert verdict.status != "proved" or compared(verdict) in (True, False)


def test_law_of_the_paper():
    verdict = clpt.prove(clpt.closed_loop(paper_of(1, "learned-flow")), points=50)
    assert missing(verdict) - TRUSTED == set()


# --- coqc ---------------------------------------------------------------------------------------


@pytest.mark.sampled
@pytest.mark.coq
@pytest.mark.parametrize("name", SAMPLE)
def test_file_compiles_with_the_axioms_of_the_reals_alone(name, tmp_path):
    accepted, axioms = compiled(tmp_path, judged(name).coq())
    assert accepted
    assert axioms <= REALS


@pytest.mark.coq
@pytest.mark.parametrize("name", REGIONS)
def test_file_of_a_region_compiles(name, tmp_path):
    accepted, axioms = compiled(tmp_path, judged_in_region(name).coq())
    assert accepted
    assert axioms <= REALS


@pytest.mark.coq
def test_file_of_a_law_compiles(tmp_path):
    verdict = clpt.prove(clpt.closed_loop(paper_of(1, "learned-flow")), points=50)
    assert compiled(tmp_path, verdict.coq()) == (True, REALS)


ALTERED = [  # a text of the file, another one for it
    ("a hard spring", "- r_d*(r_v t)", "+ r_d*(r_v t)"),  # damping
    ("a hard spring", "Hypothesis P_d : 0 < r_d.", ""),
    ("a hard spring", "follows T r_x (fun t => (r_v t))", "follows T r_x (fun t => 2*(r_v t))"),
    ("a cross term", "V (i : run) (t : R) := 3*", "V (i : run) (t : R) := 4*"),
    ("a cross term", "<= V i s", "< V i s"),
    ("a divisor", "follows (T i) (V i) (fun t => -", "follows (T i) (V i) (fun t => -2*"),
    ("a pendulum", "(sin ((r_x t)))", "(sin (2*(r_x t)))"),
    ("a pendulum", "vanishes (T i) (fun t => (sin ((r_x i t))))", "vanishes (T i) (r_x i)"),
    ("an adaptive law", ";\n  B_r : bounded T r_r", ""),
    ("an adaptive law", "vanishes (T i) (r_e i)", "vanishes (T i) (r_h i)"),
    ("a circle", "near now (fun i t => (r_x i t))", "near now (fun i t => (r_x i t) + 1)"),
    ("a circle", "follows T r_y (fun t => -(r_x t))", "follows T r_y (fun t => (r_x t))"),
    ("a root", "/sqrt((r_x t)^2 + 1)", "/sqrt((r_x t)^2 + 2)"),
    ("an exponential", "(exp ((r_x t))) - 1)", "(exp ((r_x t))) + 1)"),
    ("a leak", "V i t <= c /", "V i t <= 0 * c /"),
    ("a gain 2 + sin(t)", "<= 1 * (1)", "<= 1 * (2)"),
    ("a damping tanh(t)", "(tanh (t))", "(tanh (t - 1))"),
    ("a gain divided by cosh(x)", "(cosh ((r_x t)))", "(cosh (2*(r_x t)))"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("loop", "left_out"),
    [
        (
            "x' = (2 + sin(t)*cos(t))*v; v' = -(2 + sin(t)*cos(t))*x - v",
            "x goes to zero, as rates",
        ),
        ("x' = v; v' = -x - (2 + sin(t**2))*v", "v, x go to zero"),
    ],
)
def test_limits_that_are_not_in_the_file_are_named(loop, left_out):
    """V loses a multiple of v^2; x goes to zero as the rate of v does."""
    plant, V = written(f"{loop}; V = (x**2 + v**2)/2")[:2]
    verdict = clpt.lyapunov(plant, V)
    assert "so v, x go to zero" in verdict.sentence
    steps = [step.claim for step in verdict.beyond_coq()]
    assert "x goes to zero, as rates of v do" in steps
    text = verdict.coq()
    assert left_out in text[text.rindex("(* The verdict: ") :]


@pytest.mark.sampled
@pytest.mark.coq
@pytest.mark.parametrize(("name", "text", "other"), ALTERED)
def test_altered_file_is_refused(name, text, other, tmp_path):
    file = judged(name).coq()
    start = file.index("Section Loop.")
    loop = file[start:]
    altered = loop.replace(text, other)
    assert altered != loop
    assert compiled(tmp_path, file[:start] + altered)[0] is False
