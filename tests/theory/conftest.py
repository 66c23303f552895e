"""What many tests of proofs share, and what each verdict in them keeps."""

import functools
import sys

import pytest
from latex_texts import well_formed

import clpt_control

STATEMENT = "clpt_control.theory.proofs.statements.Statement"


@pytest.fixture(scope="session")
def paper():
    return clpt_control.paper_scenario().with_values({"run.duration": 400})


@pytest.fixture(scope="session")
def true_paper(paper):
    return paper.started_true()


@pytest.fixture(autouse=True)
def _statements_keep_their_parts(monkeypatch):
    """Statements in f-strings of the package, and sums of them, lose their expressions."""

    def as_text(statement, spec):
        module = sys._getframe(1).f_globals["__name__"]
        is_printer = f"{STATEMENT}".startswith(module)
        assert is_printer or not module.startswith("clpt_control.theory"), (
            f"{module}: use said()"
        )
        return format(str(statement), spec)

    def refuse(*texts):
        raise AssertionError("use said()")

    monkeypatch.setattr(f"{STATEMENT}.__format__", as_text)
    monkeypatch.setattr(f"{STATEMENT}.__add__", refuse)
    monkeypatch.setattr(f"{STATEMENT}.__radd__", refuse, raising=False)


@pytest.fixture(autouse=True)
def _proofs_have_latex(monkeypatch):
    """The LaTeX of each proof that a test makes has no text of a program in it."""
    found = []

    def kept(function):
        @functools.wraps(function)
        def judged(*arguments, **named):
            found.append(function(*arguments, **named))
            return found[-1]

        return judged

    for name in ("lyapunov", "prove"):
        monkeypatch.setattr(clpt_control, name, kept(getattr(clpt_control, name)))
    yield
    for verdict in found:
        if verdict.status == "proved":
            well_formed(verdict)
