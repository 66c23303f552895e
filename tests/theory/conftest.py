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

    def check_caller():
        module = sys._getframe(2).f_globals["__name__"]
        is_printer = STATEMENT.startswith(module)
        in_theory = module.startswith("clpt_control.theory")
        assert is_printer or not in_theory, f"{module}: use said()"

    def as_text(statement, spec):
        check_caller()
        return format(str(statement), spec)

    def added(statement, text):
        check_caller()
        return str(statement) + text

    def added_to(statement, text):
        check_caller()
        return text + str(statement)

    monkeypatch.setattr(f"{STATEMENT}.__format__", as_text)
    monkeypatch.setattr(f"{STATEMENT}.__add__", added)
    monkeypatch.setattr(f"{STATEMENT}.__radd__", added_to, raising=False)


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
