"""docs/each_law.md has a section for each law, as its page and its row have it."""

import re
import runpy
from pathlib import Path

import pytest

from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.promises import promises_in_words

ROOT = Path(__file__).parents[1]
TOOL = ROOT / "tools" / "print_laws.py"
PAGE = ROOT / "docs" / "each_law.md"

pytestmark = pytest.mark.skipif(not TOOL.exists(), reason="installed without tools")


def test_the_sections_are_those_of_the_laws():
    tool = runpy.run_path(str(TOOL))
    text = PAGE.read_text("utf-8")
    assert tool["whole_page"]() == text, "run python tools/print_laws.py"
    for law in LAWS.values():
        assert re.search(rf"^## .*`{law.name}`", text, re.M)


def test_equations_become_formulas():
    tool = runpy.run_path(str(TOOL))
    assert tool["formula"]("theta_hat' = gamma phi_f e^T/r^2") == (
        r"\hat{\theta}' = \gamma \phi_{f} e^{\top} / r^2"
    )
    assert tool["formula"]("KD_i <= GammaD") == r"K_{D,i} \le \Gamma_D"
    assert tool["formula"]("Q = M (1 + m M)^-1") == "Q = M ( 1 + m M )^{-1}"


@pytest.mark.parametrize(
    ("text", "typeset"),
    [
        ("so V' = -e^T KD e, Theorem 3.2.", r"so $V' = - e^{\top} K_D e$, Theorem 3.2."),
        ("a each of its errors, a - a*", "a each of its errors, $a - a^{*}$"),
        ("the vehicle's own P, N x N", "the vehicle's own $P$, $N$ by $N$"),
        ("K of `e-law`. Source: V. K. Rao", "$K$ of `e-law`. Source: V. K. Rao"),
        ("e: |(theta - theta_hat) phi| is", r"$e$: $| ( \theta - \hat{\theta} ) \phi |$ is"),
        ("| law | clip(norm(e)/M, 0, 0.1) |",
         r"| law | $\operatorname{clip} ( \operatorname{norm} ( e ) / M , 0 , 0.1 )$ |"),
    ],
)  # fmt: skip
def test_symbols_in_sentences_become_formulas(text, typeset):
    assert runpy.run_path(str(TOOL))["typeset"](text) == typeset


@pytest.mark.parametrize("name", LAWS)
def test_the_command_prints_a_laws_page(clpt, printed, name):
    outcome = clpt("laws", name)
    assert outcome.status == 0
    listed = printed("laws", name)["laws"]
    assert list(listed) == [name]
    assert listed[name]["page"] == LAWS[name].page
    assert list(listed[name]["settings"]) == list(LAWS[name].settings)
    assert listed[name]["promises"] == list(promises_in_words(LAWS[name]).values())
    for line in (LAWS[name].page.splitlines()[0], *listed[name]["promises"]):
        assert line in outcome.out


def test_the_command_lists_all(clpt, printed):
    assert list(printed("laws")["laws"]) == list(LAWS)
    assert all(name in clpt("laws").out for name in LAWS)


def test_an_unknown_law_is_refused(clpt):
    outcome = clpt("laws", "no-law")
    assert (outcome.status, outcome.out) == (2, "")
    assert outcome.err == "clpt: no-law: is no law; `clpt laws` lists them\n"
