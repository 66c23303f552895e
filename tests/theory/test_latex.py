"""Verdicts in LaTeX: a theorem with its proof, a proposition, or a conjecture."""

import re
import shutil
import subprocess

import pytest
import sympy
from latex_texts import well_formed
from small_scenarios import paper_of
from sympy.core.function import AppliedUndef
from text_systems import written

import clpt_control as clpt

FORGETTING = {"learning.composite_least_squares.forgetting": 0.1}  # that law needs one


def verdict_of(text, **more):
    """Return the verdict on equations and V as text."""
    return clpt.lyapunov(*written(text), **more)


def test_a_linear_system_is_a_theorem():
    """x' = -x, V = x^2: V' = -2 x^2."""
    text = well_formed(verdict_of("x' = -x; V = x**2"))
    assert r"\dot{x} &= - x" in text
    assert "V = x^{2}$" in text
    assert r"\dot V = - 2\,x^{2}$" in text
    assert "Conclusion: the rest is exponentially stable from every start, " in text
    assert r"V{\left(0 \right)}\,e^{- 2\,t}$." in text
    assert "Conditions" not in text


def test_functions_of_time_keep_their_argument():
    text = well_formed(verdict_of("x' = -(2 + sin(t))*x; V = x**2"))
    assert r"\sin{\left(t \right)} + 2" in text
    assert "mathrm{sin}" not in text


def test_a_condition_is_told():
    lag = clpt.Block(
        "lag",
        update=lambda t, x, u, p: {"x": u.w - p.k * x.x},
        states={"x": 1},
        inputs={"w": 1},
        parameters={"k": 2.0},
    )
    text = well_formed(clpt.lyapunov(lag, lambda s: s.x**2 / 2))
    assert r"Then, where $w = 0$, $\displaystyle \dot V = - k\,x^{2}$" in text
    assert "Conditions: where $k > 0$; where $w = 0$." in text


def test_the_rate_of_a_refuted_V_has_its_inputs():
    """e' = -e + k r, k' = r e: V' = -e^2 + 2 e k r, which the input raises."""
    law = clpt.Block(
        "law",
        update=lambda t, x, u, p: {"e": -x.e + x.k * u.r, "k": u.r * x.e},
        states={"e": 1, "k": 1},
        inputs={"r": 1},
    )
    found = clpt.lyapunov(law, lambda s: s.e**2 / 2 + s.k**2 / 2)
    (e, k), (r,) = found.point.x, found.point.u
    at_point = {"e": e, "k": k, "r": r, "r(t)": r}
    leaves = found.rate.atoms(sympy.Symbol, AppliedUndef)
    value = found.rate.subs({leaf: at_point.get(str(leaf), 0) for leaf in leaves})
    assert float(value) == pytest.approx(-(e**2) + 2 * e * k * r, rel=1e-12)
    assert float(value) == pytest.approx(found.value, rel=1e-9)
    assert r"\dot V = - e^{2} + 2\,e\,k\,r$" in well_formed(found)


@pytest.mark.parametrize(
    "more",
    [{"claim": lambda s: -(s.x**2) / 2 + s.f**2 / 2}, {"within": {"x": (-1, 1)}}],
)
def test_the_rate_where_an_input_is_0_is_without_it(more):
    """x' = f - x, V = x^2/2: V' = -x^2 where f = 0."""
    lag = clpt.Block(
        "lag", update=lambda t, x, u, p: [u.f - x.x], states={"x": 1}, inputs={"f": 1}
    )
    found = clpt.lyapunov(lag, lambda s: s["x"] ** 2 / 2, **more)
    assert "where f = 0" in str(found)
    assert str(found.rate) == "-x**2"
    assert r"Then, where $f = 0$, $\displaystyle \dot V = - x^{2}$" in well_formed(
        found
    )


@pytest.mark.parametrize(("factor", "status"), [(1, "proved"), (3, "refuted")])
def test_a_claim_is_a_formula(factor, status):
    """V' = -2 x^2 is at most -x^2, but above -3 x^2."""
    verdict = verdict_of("x' = -x; V = x**2", claim=lambda s: -factor * s.x**2)
    text = well_formed(verdict)
    assert verdict.status == status
    claimed = r"- x^{2}" if factor == 1 else r"- 3\,x^{2}"
    assert rf"\dot V \le {claimed}$" in text
    assert ("Refuted: $\\dot V$ is above the claim at a point: $t = " in text) == (
        status == "refuted"
    )


@pytest.mark.long
@pytest.mark.parametrize(
    ("V", "forms", "rate"),
    [
        ("log(cosh(x)) + y**2/2", "$x$, $y$", r"\tanh{\left(x \right)}"),
        ("sqrt(1 + x**2) - 1 + y**2/2", "$x$, $y$", r"\frac{x^{2}}{\sqrt{x^{2} + 1}}"),
    ],
)
def test_claims_are_formulas(V, forms, rate):
    """x' = -x: V' = -x tanh(x) or -x^2/sqrt(1 + x^2), less y^2."""
    text = well_formed(verdict_of(f"x' = -x; y' = -y; V = {V}"))
    assert f"$V$ is positive definite in {forms} (exact)" in text.replace(
        "$y$, $x$", forms
    )
    [item] = re.findall(r"item \$\\dot V = (.*) \\le 0\$ \(exact\)", text)
    assert rate in item
    assert "**" not in text


def test_an_open_verdict_is_a_conjecture():
    verdict = verdict_of("x' = -x; V = tanh(x**2)")  # a V that is bounded
    assert verdict.status == "open"
    text = well_formed(verdict)
    assert r"V = \tanh{\left(x^{2} \right)}$" in text
    assert "Not shown: $V$ is positive definite." in text


def test_a_search_without_a_V_is_a_conjecture_without_formulas():
    plant, _ = written("x' = x; V = x**2")
    verdict = clpt.lyapunov(plant)
    assert (verdict.status, verdict.V) == ("open", None)
    assert r"\dot" not in well_formed(verdict)


def test_the_principle_of_LaSalle_is_typeset():
    text = well_formed(verdict_of("x' = v; v' = -x**3 - v; V = x**4/4 + v**2/2"))
    assert r"\dot{v} &= - v - x^{3}" in text
    assert r"\dot V = - v^{2}$" in text


def test_in_discrete_time_V_changes():
    """x+ = x/2, V = x^2: V(x+) - V(x) = -3 x^2/4."""
    half = clpt.Block(
        "half", update=lambda t, x, u, p: {"x": x.x / 2}, states={"x": 1}, dt=1.0
    )
    text = well_formed(clpt.lyapunov(half, lambda s: s.x**2))
    assert "x^{+} &= \\frac{x}{2}" in text
    assert r"V(x^+) - V(x) = - \frac{3\,x^{2}}{4}$" in text


@pytest.mark.long
@pytest.mark.parametrize("name", clpt.laws())
def test_the_verdict_on_a_law_is_well_formed(name):
    scenario = paper_of(2, name)
    if name == "composite-least-squares":
        scenario = scenario.with_values(FORGETTING)
    verdict = clpt.prove(clpt.closed_loop(scenario), points=20)
    text = well_formed(verdict)
    assert text.count("Conclusion: ") == 1
    if verdict.V is not None:
        assert "K_{D,1}" in text
        assert r"\dot{z}_{1} &= " in text


def test_theorem_3_2_is_typeset():
    """V' = -e^T KD e, e = x - z, with gamma = 0.8: alpha' = -0.8 e phi."""
    text = well_formed(clpt.prove(clpt.closed_loop(paper_of(1, "learned-flow"))))
    e = [rf"\left(x_{{{i}}} - z_{{{i}}}\right)" for i in (1, 2)]
    rate = rf"- K_{{D,1}}\,{e[0]}^{{2}} - K_{{D,2}}\,{e[1]}^{{2}}"
    assert rf"\dot V = {rate}." in " ".join(text.split())
    assert rf"\dot{{K}}_{{1}} &= - \frac{{4\,z_{{1}}\,{e[0]}}}{{5}}" in text
    assert "Conclusion: CLPE goes to zero." in text
    assert r"K\_1" not in text.partition("Conditions")[0]


SWING = "x' = v; v' = -sin(x) - d_1*v; V = v**2/2 + 1 - cos(x); d_1 = 0.5"
LONG = "; ".join(f"x{k}' = -{k + 1}*x{k}**3 - x{k}*sin(x{k})**2" for k in range(12))
KURAMOTO = (
    "x' = -K*(sin(x - y) + sin(x - z)); y' = K*(sin(x - y) - sin(y - z)); "
    "z' = K*(sin(x - z) + sin(y - z)); V = 3 - cos(x - y) - cos(y - z) - cos(x - z); K = 1"
)
PRODUCT = (
    "x' = -x*y**2*(1 + sin(y)**2)*(2 + cos(y))*(3 + tanh(y))*exp(-y**2); y' = -y; "
    "V = x**2/2 + y**2/2"
)
BACKSTEPPING = (
    "x' = x**2 + y; "
    "y' = d - x - b*(y + a*x + x**2) - (a + 2*x)*(x**2 + y); "
    "V = x**2/2 + (y + a*x + x**2)**2/2; input d; a = 1.5; b = 2.5"
)
OF_EACH_KIND = [
    (SWING, {}),
    (LONG, {}),
    ("x' = -x; V = tanh(x**2)", {}),
    ("x' = x + 3*x**2; V = x**2", {}),
    ("x' = -k*x + d; V = x**2/2; k = 3; input d", {}),
    ("th' = -th/(1 + y**2); y' = 1; V = th**2/2", {}),
    ("y' = -y + h*r; m' = -m + r; h' = -(y - m)*r; V = (y - m)**2/2 + (h - 1)**2/2; input r", {}),
    ("a' = -clip(a, -1, 1); b' = -b - maximum(b, 0); V = a**2 + b**2", {}),
    ("x' = -1e50*x; V = x**2", {}),
    ("γ' = -θ*γ; é' = -é; θ = 3", {}),
    ("x' = -x + d; V = x**2; input d", {"where": {"d": (-1, 2)}}),
    ("x' = -x + x*y; y' = -y; V = x**2 + y**2", {"within": {"x": (-2, 2), "y": (-2, 2)}}),
    ("x' = -maximum(x, 0) - 2*minimum(x, 0); V = x**2/2", {}),
    ("x' = -where(x > 1, 2*x, x); V = x**2/2", {}),
    ("x' = -abs(x)*x; V = x**2/2", {}),
    ("x' = -x + y; y' = -x - where(abs(y) > 1, y, 2*y); V = x**2/2 + y**2/2", {}),
    ("x' = -x - 1.0000000000000002*x**3; V = x**2/2", {}),
    (KURAMOTO, {}),
    ("x' = -x/(1 + x**2) - x*exp(-x**2)*cos(x)**2; V = x**2/2", {}),
    (PRODUCT, {}),
    ("x' = -x + d*y; y' = -y - d*x; V = x**2 + y**2; input d", {}),
    (BACKSTEPPING, {"where": {"d": (-0.2, 0.2)}}),
]  # fmt: skip
ARTICLE = r"""\documentclass{article}
\usepackage{amsmath,amsthm}
\newtheorem{theorem}{Theorem}\newtheorem{proposition}{Proposition}
\newtheorem{conjecture}{Conjecture}
\begin{document}
%s
\end{document}"""


@pytest.mark.long
def test_latex_of_each_kind_compiles(tmp_path):
    verdicts = [verdict_of(text, **more) for text, more in OF_EACH_KIND]
    texts = [*map(well_formed, verdicts)]
    assert all(len(line) <= 1000 for text in texts for line in text.splitlines())
    assert all(len(verdict.sentence) <= 300 for verdict in verdicts)
    if not shutil.which("pdflatex"):
        pytest.skip("pdflatex is not installed")
    (tmp_path / "all.tex").write_text(ARTICLE % "\n\n".join(texts))
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "all.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-800:]
    assert not re.search(
        r"Overfull \\hbox \(\d\d", done.stdout
    )  # by a millimetre or two


def test_choices_and_limits_are_set_as_in_a_paper():
    """max, min and cases, for what NumPy calls maximum, minimum and where."""
    text = well_formed(verdict_of("x' = -maximum(x, 0) - 2*minimum(x, 0); V = x**2/2"))
    assert r"\max\left(0, x\right)" in text
    assert r"\min\left(0, x\right)" in text
    assert (
        r"\begin{cases}"
        in clpt.equations(written("x' = -where(x > 1, 2*x, x)")[0]).latex()
    )


@pytest.mark.long
def test_a_long_rate_is_broken_into_lines():
    """V' of three oscillators; brackets with a break in them have no left and right."""
    text = well_formed(verdict_of(KURAMOTO))
    rate = text[text.index("Then") : text.index("Conclusion")]
    lines = re.split(r"\\\\ &", rate)
    assert len(lines) > 3
    for line in lines:
        assert len(re.sub(r"\\[a-z]+|[{}^_ ]", "", line)) < 80
        assert line.count(r"\left(") == line.count(r"\right)")


def test_claims_of_a_law_are_mathematics():
    """V' of the known-flow law is written by hand, in arrays."""
    text = well_formed(clpt.prove("known-flow", points=5))
    known = r"-e^{\top}\,K_D\,e + e^{\top}\,(\theta - \theta_{\mathrm{hat}})\,\phi"
    assert rf"\item $\dot V = {known}$, for every $N$ (exact)" in text


@pytest.mark.long
def test_conclusions_and_conditions_are_mathematics():
    text = well_formed(verdict_of(SWING))
    assert r"$v$, $\sin{\left(x \right)}$ go to zero." in text
    assert "Conditions: where $d_{1} > 0$." in text
    assert "..." not in well_formed(verdict_of(LONG))  # no line, which is cut
