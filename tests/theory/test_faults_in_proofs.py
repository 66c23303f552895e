"""Errors in functions of the user name their line; errors of the package say that they are its."""

import numpy as np
import pytest
from error_sentences import says

import clpt_control as clpt

LAG = clpt.Block("lag", update=lambda t, x, u, p: {"x": -x.x}, states={"x": 1})


def half_of_e(s):
    return s.e @ s.e / 2


def kept(s, p, truth):
    return {"a": 0 * s["a"]}


@pytest.fixture
def law():
    return clpt.Block(
        "mine",
        update=lambda t, x, u, p: {"a": -u.e[:1]},
        output=lambda t, x, u, p: {
            "alpha": np.concatenate([x.a, x.a]),
            "K": np.zeros(2),
            "Gamma": np.zeros(2),
        },
        states={"a": 1},
        inputs={"e": 2},
        outputs={"alpha": 2, "K": 2, "Gamma": 2},
    )


def test_an_error_of_the_package_is_reported_as_its_own(monkeypatch):
    def broken(*arguments):
        return {}["t"]

    monkeypatch.setattr("clpt_control.theory.proofs.judge.squares", broken)
    with pytest.raises(
        clpt.ClptError, match=r"lag: a fault of clpt-control .*'t'"
    ) as caught:
        clpt.lyapunov(LAG, lambda s: s.x**2)
    assert "V' cannot be computed" not in f"{caught.value}"
    cause = caught.value.__cause__
    assert isinstance(cause, KeyError)
    assert cause.__traceback__.tb_next is not None


def test_an_error_in_a_V_names_its_line(law):
    V = lambda truth: 1 / 0  # noqa: E731
    says(clpt.DiagramError, "mine: V: <lambda>, line ", clpt.prove, law, V, points=5)
    says(clpt.DiagramError, "ZeroDivisionError", clpt.prove, law, V, points=5)


@pytest.mark.parametrize("argument", ["invariants", "losses"])
def test_an_error_in_what_a_law_keeps_names_its_line(law, argument):
    given = {"invariants": kept} | {argument: lambda s, p, truth: s["nothing"]}
    with pytest.raises(
        clpt.DiagramError, match=f"mine: {argument}: <lambda>, line .*nothing"
    ):
        clpt.prove(law, half_of_e, points=5, **given)


@pytest.mark.parametrize(
    ("argument", "value"),
    [
        ("semidefinite", ("Q",)),
        ("start", {"Q": 1.0}),
        ("invariants", lambda s, p, truth: {"Q": 0}),
    ],
)
def test_a_state_that_the_law_has_not_is_named(law, argument, value):
    given = {"invariants": kept} | {argument: value}
    with pytest.raises(
        clpt.ClptError, match=f"mine: {argument}: there is no Q. It has"
    ):
        clpt.prove(law, half_of_e, points=5, **given)
