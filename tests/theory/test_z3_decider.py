"""Signs decided by Z3: right ones, wrong ones, and verdicts that need them."""

import subprocess
import sys

import numpy as np
import pytest
import sympy
from text_systems import written

from clpt_control import lyapunov
from clpt_control.theory.proofs import decide
from clpt_control.theory.proofs.symbolic_loop import Numbers
from clpt_control.theory.proofs.z3_decider import z3_never_positive

pytest.importorskip("z3")

x, y, z = sympy.symbols("x y z", real=True)
a, b = sympy.symbols("a b", positive=True)
t = sympy.Symbol("t", real=True)
d = sympy.Function("d", real=True)(t)  # an input
WORDS = (
    "where gt ge lt le and_ or_ not_ clip inside maximum minimum sign floor ceil mod"
)
NAMES = {name: sympy.Function(name, real=True) for name in WORDS.split()}
NAMES |= {"x": x, "y": y, "z": z, "a": a, "b": b, "t": t, "d": d, "pi": sympy.pi}


def read(text):
    """An expression as it is written."""
    return sympy.sympify(text, locals=NAMES, rational=True)


MOTZKIN = "x**4*y**2 + x**2*y**4 + 1"
RIGHT = (
    f"3*x**2*y**2 - ({MOTZKIN})",
    "4*x*y*z - x**4 - y**4 - z**4 - 1",
    "2*a*b*x*y*tanh(z) - a**2*x**2 - b**2*y**2",
    "2*sqrt(a*b)*x*y - a*x**2 - b*y**2",
    "-(x - y)*(tanh(x) - tanh(y))",
    "-(x - y)*(exp(x) - exp(y))",
    "(x - y)*(tanh(x) - tanh(y)) - (x - y)**2",
    "-x*log(1 + x**2)**2*x",
    "1 + x - exp(x)",
    "log(a) - a + 1",
    "1 + x**2/2 - cosh(x)",
    "sinh(x)**2 - cosh(x)**2",
    "1 - x**2/2 - cos(x)",
    "sin(x) - pi/3",
    "-t*x**2",
    "-t**3",
    "-d**2 + 2*d*x - x**2",
    "-x*clip(x, -1, 1) + x*y*inside(x, -1, 1) - y**2",
    "where(gt(x, 0), -sqrt(x), where(lt(x, 0), -2, -1))",
    "where(and_(gt(x, 0), not_(lt(x, 1))), 1 - x, -1)",
    "maximum(x, y)*minimum(x, y) - x**2/2 - y**2/2",
    "abs(x)*tanh(y) - sqrt(1 + x**2)",
    "x*y/(1 + x**2 + y**4) - x**2/(1 + y**2) - y**2",
    "floor(x) - x",
    "x - 1 - floor(x)",
    "mod(x, 2) - 2",
    "-x**2/abs(y)**(1/2)",
)
WRONG = (
    f"3.001*x**2*y**2 - ({MOTZKIN})",
    "4.1*x*y*z - x**4 - y**4 - z**4 - 1",
    "2.01*a*b*x*y*tanh(z) - a**2*x**2 - b**2*y**2",
    "where(gt(x, 0), -sqrt(x), where(lt(x, 0), 1, -1))",
    "where(gt(x, 0), -1/x, 1)",
    "where(lt(x, 0), 1, -log(1 + x))",
    "where(gt(1/x, 1), -1, x)",
    "maximum(-1, minimum(1, 1/x))",
    "1 + sqrt(-1 - x**2)",  # has no value
    "1/(x - x*y/y)",
    "-x**3",
    "tanh(x) - 0.999",
    "x - floor(x) - 0.999",
    "sin(x) + cos(y)*sin(y) - 1.49",
    "-(x - y)*(sin(x) - sin(y))",
    "exp(-1/x**2) - 0.5",
    "d",
)


@pytest.mark.parametrize("text", RIGHT)
def test_a_sign_that_is_right_is_decided(text):
    assert z3_never_positive(read(text), {a, b})


@pytest.mark.parametrize("text", WRONG)
def test_a_sign_that_is_wrong_is_not_decided(text):
    assert not z3_never_positive(read(text), {a, b})


@pytest.mark.parametrize(
    "e",
    [
        -(sympy.Symbol("q") ** 2),  # not known to be real
        -abs(sympy.zeta(x)),
        -(x**20) - y**20,
        -abs(sympy.Function("lookup", real=True)(x)),
        sympy.Add(*(-((x + k) ** 2) for k in range(300))),
        -sympy.oo,
    ],
)
def test_an_expression_without_translation_is_not_decided(e):
    assert not z3_never_positive(e, set())


# --- random expressions -----------------------------------------------------------------


def drawn(random, depth):
    """A random expression."""
    if depth == 0:
        return random.choice([x, y, x, y, sympy.Integer(int(random.integers(-2, 3)))])
    u, v, w = (drawn(random, depth - 1) for _ in range(3))
    ways = (
        lambda: u + v,
        lambda: u - v,
        lambda: u * v,
        lambda: -(u**2) - v**2,
        lambda: u / v if v != 0 else u,
        lambda: sympy.sqrt(u),
        lambda: NAMES["where"](NAMES["gt"](u, v), u, w),
        lambda: NAMES["where"](NAMES["le"](u, 0), w, v),
        lambda: NAMES["clip"](u, -1, 1),
        lambda: NAMES["maximum"](u, v),
        lambda: -abs(u),
        lambda: NAMES["sign"](u),
        lambda: NAMES["floor"](u),
        lambda: sympy.tanh(u),
        lambda: sympy.sin(u),
        lambda: sympy.cos(u),
        lambda: -sympy.exp(u),
    )
    return ways[random.integers(len(ways))]()


def test_no_random_expression_that_is_positive_somewhere_is_decided():
    random, decided = np.random.default_rng(0), 0
    for _ in range(600):
        e = drawn(random, 2 + int(random.integers(2)))
        if not e.free_symbols or e.has(sympy.I, sympy.zoo, sympy.nan, sympy.oo):
            continue
        if not z3_never_positive(e, set()):
            continue
        decided += 1
        numbers = Numbers(e)
        points = random.normal(size=(len(numbers.symbols), 1000))
        points *= 10.0 ** random.uniform(-1, 1, 1000)
        points[:, :300] = np.round(points[:, :300])  # at kinks and jumps
        known = dict(zip(numbers.symbols, points, strict=True))
        (values,) = numbers.at(known, 1000)
        values = values[np.isfinite(values)]
        scale = 1e-9 * (1 + abs(values).max(initial=0))
        assert values.max(initial=-1.0) <= scale, e
    assert decided > 50


# --- verdicts ---------------------------------------------------------------------------

CUBES = "x' = -x**3 + y**3/3; y' = -y**3 + z**3/3; z' = -z**3 + x**3/3"
ONLY_WITH_Z3 = {
    "cubic springs in a ring": CUBES,
    "a cubic coupling": "x' = -x**3 + y**2*x; y' = -y**3 + 0.9*x**2*y",
    "Motzkin's polynomial": "x' = -x**3*y**2 - x*y**4 + 3*x*y**2 - x/2; y' = -y",
    "a flow through exp": "v' = -(exp(v) - exp(w)); w' = exp(v) - exp(w) - w",
    "a flow through tanh": "v' = -(tanh(v) - tanh(w)); w' = tanh(v) - tanh(w) - w",
    "a leaky pair": "v' = -tanh(v) + tanh(w); w' = tanh(v) - 2*tanh(w); "
    "V = log(cosh(v)) + log(cosh(w))",
}
WRONG_SYSTEMS = {
    "cubic springs that push": CUBES.replace("/3", "*1.01"),
    "a larger cubic coupling": "x' = -x**3 + y**2*x; y' = -y**3 + 1.01*x**2*y",
    "a flow back": "v' = exp(v) - exp(w); w' = exp(v) - exp(w) - w",
}


@pytest.mark.parametrize("name", ONLY_WITH_Z3)
def test_z3_decides_a_verdict(name, monkeypatch):
    assert lyapunov(*written(ONLY_WITH_Z3[name]), points=50).status == "proved"
    monkeypatch.setattr(decide, "z3_never_positive", lambda e, fixed: False)
    assert lyapunov(*written(ONLY_WITH_Z3[name]), points=50).status == "open"


@pytest.mark.parametrize("name", WRONG_SYSTEMS)
def test_a_wrong_system_is_not_proved(name):
    assert lyapunov(*written(WRONG_SYSTEMS[name]), points=50).status != "proved"


def test_without_z3_nothing_is_decided(monkeypatch):
    monkeypatch.setitem(sys.modules, "z3", None)
    assert not z3_never_positive(-(x**2), set())


def test_the_package_is_imported_without_z3():
    code = (
        "import sys, clpt_control.theory.proofs.decide; sys.exit('z3' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
