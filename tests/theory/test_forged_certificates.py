"""Forged certificates: the checker rejects each, or prints what the file leaves unproved.

All files are written by hand from this loop, V = (e^2 + q^2)/2 and V' = -k e^2:

    e' = -k e + q w,    q' = -e w
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest

CHECKER = Path(__file__).parents[2] / "tools" / "check_certificate.py"
ONE, ZERO = [["1", {}]], []


def product(coefficient, **powers):
    return [[coefficient, powers]]


def term(basis, weight=(), matrix=(("1",),)):
    return {
        "weight": [*weight],
        "basis": [basis],
        "matrix": matrix if isinstance(matrix, str) else [*map(list, matrix)],
    }


HALF = [product("1/2")]
E, Q, X, Y = (product("1", **{s: 1}) for s in "eqxy")
GOOD = {
    "format": "clpt certificate 1",
    "rates": {
        "e": product("-1", k=1, e=1) + product("1", q=1, w=1),
        "q": product("-1", e=1, w=1),
    },
    "positive": ["k"],
    "constants": [],
    "inputs": ["w"],
    "positive_inputs": [],
    "signals": [],
    "V": [term(E, HALF), term(Q, HALF)],
    "losses": [term(E, [product("1", k=1)])],
    "push": [],
    "decay": [],
    "semidefinite": {},
    "assumed": [],
    "conclusion": "goes to zero",
    "of": [E],
    "conditions": ["N = 2"],
}
EMPTY = GOOD | {
    key: type(GOOD[key])()
    for key in ("rates", "positive", "inputs", "V", "losses", "of", "conditions")
}
TEXT = json.dumps(GOOD)


def falling(form, **fields):
    """x' = -1 with V = x, where x >= 0 is assumed; V loses form^2 = 1."""
    return {
        **EMPTY,
        "rates": {"x": product("-1")},
        "V": [term(ONE, [X])],
        "assumed": [X],
        "losses": [term(form)],
        "of": [form],
        **fields,
    }


def stable(**fields):
    """x' = -x with V = x^2."""
    return {
        **EMPTY,
        "rates": {"x": product("-1", x=1)},
        "V": [term(X)],
        "losses": [term(X, [product("2")])],
        "conclusion": "asymptotically stable",
        **fields,
    }


def square(form, sign=1):
    """A polynomial in one monomial, squared."""
    [[c, powers]] = form
    return [[str(sign * int(c) ** 2), {s: 2 * n for s, n in powers.items()}]]


def assuming(*polynomials, **fields):
    """The good certificate with assumptions."""
    return GOOD | {"assumed": [*polynomials], **fields}


def named(name, old="e"):
    """The good certificate with another name of a state."""
    return TEXT.replace(json.dumps(old), json.dumps(name))


def coefficient(value):
    """The good certificate with another coefficient of a matrix, in JSON."""
    return TEXT.replace('[["1"]]', f"[[{value}]]", 1)


def power(value):
    """The good certificate with another power of e in its form, in JSON."""
    return json.dumps(GOOD | {"of": [[["1", {"e": "POWER"}]]]}).replace(
        '"POWER"', value
    )


def with_matrix(rows, **fields):
    """V of x' = -1 that is hidden in a matrix that is assumed to be semidefinite."""
    basis = [ONE, *[ZERO] * (len(rows) - 1)]
    hidden = {"weight": [], "basis": basis, "matrix": "P"}
    symbols = {s for row in rows for s in row if isinstance(s, str)} - {"x"}
    return falling(X) | {
        "rates": {"x": product("-1")} | {s: [] for s in sorted(symbols)},
        "V": [hidden, term(X)],
        "losses": [term(ONE)],
        "push": product("-2", x=1),
        "assumed": [],
        "semidefinite": {"P": rows},
        "conclusion": "V' is at most the push",
        "of": [],
        **fields,
    }


def in_term(part="losses", **fields):
    """The good certificate with fields of a term."""
    return GOOD | {part: [GOOD[part][0] | fields, *GOOD[part][1:]]}


# x' = x (1 - x^2 - y^2) - y, y' = y (1 - x^2 - y^2) + x leaves 0 for the unit circle;
# V = x^2 + y^2 + p = (x^2 + y^2 - 1)^2 + 1 where p = r^4 - 3 r^2 + 2 >= 0 for r <= 1
R2 = square(X) + square(Y)
R4 = product("1", x=4) + product("2", x=2, y=2) + product("1", y=4)
TURNING = EMPTY | {
    "rates": {
        "x": X + product("-1", x=3) + product("-1", x=1, y=2) + product("-1", y=1),
        "y": Y + product("-1", y=3) + product("-1", x=2, y=1) + X,
    },
    "assumed": [R4 + product("-3", x=2) + product("-3", y=2) + product("2")],
    "losses": [  # 4 r^2 (1 - r^2)^2
        term(s + product("-1", **m3) + product("-1", **m12), [product("4")])
        for s, m3, m12 in (
            (X, {"x": 3}, {"x": 1, "y": 2}),
            (Y, {"y": 3}, {"x": 2, "y": 1}),
        )
    ],
    "conclusion": "stable",
}
TURNING["V"] = [term(X), term(Y), term(ONE, TURNING["assumed"])]
HIDDEN = product("-2", x=1, s=1) + product("-1", s=2)
DRIVEN = EMPTY | {  # x' = -x + s, V' = -x^2/2 - (x - s)^2/2 + s^2/2
    "rates": {"x": product("-1", x=1) + product("1", s=1)},
    "signals": ["s"],
    "V": [term(X, HALF)],
    "losses": [term(X, HALF), term(X + product("-1", s=1), HALF)],
    "push": product("1/2", s=2),
    "conclusion": "bounded in the mean",
    "of": [X],
}
FORM = "does not fit the format"
NOT_SHOWN = "does not follow"
FORGED = {  # name -> file, a part of the reason
    # --- nothing is shown
    "no state": (EMPTY | {"conclusion": "asymptotically stable"}, "no states"),
    "no state and a push": (EMPTY | {"push": ONE}, "no states"),
    "the zero form": (stable(conclusion="goes to zero", of=[ZERO]), NOT_SHOWN),
    "the zero form in the losses": (
        stable(
            conclusion="goes to zero",
            of=[ZERO],
            losses=[term(X, [product("2")]), term(ZERO)],
        ),
        "a form has no state",
    ),
    "the zero form of cancelled terms": (
        stable(
            conclusion="goes to zero",
            of=[X, X + product("-1", x=1)],
            losses=[term(X, [product("2")]), term(ZERO)],
        ),
        "a form has no state",
    ),
    "1 goes to zero": (falling(ONE), "a form has no state"),
    "a parameter goes to zero": (
        falling(
            product("1", k=1), positive=["k"], rates={"x": product("-1", k=2)}, of=[]
        )
        | {"of": [product("1", k=1)]},
        "a form has no state",
    ),
    "V = 0 of x' = x": (
        stable(rates={"x": X}, V=[], losses=[], conclusion="V does not increase"),
        "no state is in V",
    ),
    "V of a zero basis": (
        stable(rates={"x": X}, V=[term(ZERO)], losses=[term(ZERO)]),
        "no state is in V",
    ),
    "V = k^2 of x' = x": (
        stable(
            rates={"x": X},
            constants=["k"],
            V=[term(product("1", k=1))],
            losses=[],
            conclusion="V does not increase",
        ),
        "no state is in V",
    ),
    "V = 0 is ultimately bounded": (
        stable(
            rates={"x": X},
            V=[],
            losses=[],
            decay=[ONE],
            conclusion="ultimately bounded",
        ),
        "no state is in V",
    ),
    "V' is V'": (
        stable(
            rates={"x": product("1", x=3)},
            losses=[],
            push=product("2", x=4),
            conclusion="V' is at most the push",
        ),
        "nothing is shown",
    ),
    # --- assumptions
    "-1 >= 0": (assuming(product("-1")), "a number is assumed"),
    "1 >= 0": (assuming(ONE), "a number is assumed"),
    "0 >= 0": (assuming(ZERO), "a number is assumed"),
    "k - k >= 0": (
        assuming(product("1", k=1) + product("-1", k=1)),
        "a number is assumed",
    ),
    "-k >= 0 where k > 0": (assuming(product("-1", k=1)), "no point is found"),
    "-e^2 - 1 >= 0": (
        assuming(product("-1", e=2) + product("-1")),
        "no point is found",
    ),
    "2 <= k <= 1": (
        assuming(product("1", k=1) + product("-2"), product("-1", k=1) + product("1")),
        "no point is found",
    ),
    "a matrix of one state": (with_matrix([["x"]]), "a single entry"),
    "a matrix of one state, four times": (
        with_matrix([["x", "x"], ["x", "x"]]),
        "equal entries",
    ),
    "a matrix with an equal diagonal": (
        with_matrix([["x", "y"], ["y", "x"]]),
        "equal entries",
    ),
    "a matrix that is not symmetric": (
        with_matrix([["x", "y"], ["z", "v"]]),
        "not symmetric",
    ),
    "a matrix with a short row": (with_matrix([["x", "y"], ["y"]]), "shorter"),
    "a matrix without rows": (with_matrix([]), "matrix"),
    "a matrix of numbers": (with_matrix([[1, 0], [0, 1]]), FORM),
    "a matrix of number texts": (with_matrix([["1", "0"], ["0", "1"]]), FORM),
    "a matrix of texts": (with_matrix(["xy", "yz"]), FORM),
    "a matrix that has no name": (
        with_matrix([["x", "y"], ["y", "z"]], semidefinite={}),
        "malformed: KeyError",
    ),
    "a matrix with a state's name": (
        GOOD | {"semidefinite": {"e": [["e", "q"], ["q", "k"]]}},
        "declared twice",
    ),
    "a matrix with a negative diagonal": (
        with_matrix(
            [["x", "y"], ["y", "z"]], assumed=[product("-1", x=1) + product("-1")]
        ),
        "no point is found",
    ),
    # --- names
    "a name of three": (named("e_1, e_2, alpha"), FORM),
    "a Cyrillic e": (named("\u0435"), FORM),
    "an accent": (named("\u00e9"), FORM),
    "a wide digit": (named("e\uff11"), FORM),
    "a name with a line": (named("e)\nout/sigma.json: checked: stable ("), FORM),
    "a name that ends in a line": (named("e\n"), FORM),
    "a name with an escape sequence": (named("e\x1b[2K"), FORM),
    "a name that turns the line": (named("\u202ee"), FORM),
    "a name with a zero-width space": (named("e\u200b"), FORM),
    "a name with a NUL": (named("e\x00"), FORM),
    "half of a surrogate pair": (named("e\ud800"), FORM),
    "a name with a space": (named("e e"), FORM),
    "no name": (named(""), FORM),
    "a name that is a number": (named("2"), FORM),
    "a name that begins with a digit": (named("2e"), FORM),
    "a name that is a power": (named("e^2"), FORM),
    "a name that is a product": (named("k*e"), FORM),
    "a name that is a sum": (named("e+q"), FORM),
    "a mark of a bounded form": (named("#0"), FORM),
    "a parameter with a line": (named("k > 0\nx", "k"), FORM),
    "an input with a line": (named("w bounded\nx", "w"), FORM),
    # --- keys and declarations
    "rates given twice": (
        TEXT.replace('"rates": {', '"rates": {"e": [["1", {"e": 1}]]}, "rates": {'),
        "given twice",
    ),
    "a state given twice": (
        TEXT.replace('"rates": {', '"rates": {"e": [], '),
        "given twice",
    ),
    "a conclusion given twice": (
        TEXT.replace('"conclusion"', '"conclusion": "stable", "conclusion"'),
        "given twice",
    ),
    "a power given twice": (
        TEXT.replace('"of": [[["1", {"e": 1', '"of": [[["1", {"e": 2, "e": 1'),
        "given twice",
    ),
    "an escaped key given twice": (
        TEXT.replace('"rates": {', '"r\\u0061tes": {}, "rates": {'),
        "given twice",
    ),
    "a key of its own": (GOOD | {"proved by": "Lyapunov"}, "its keys"),
    "a key in capitals": (GOOD | {"Rates": GOOD["rates"]}, "its keys"),
    "no conditions": (
        {key: value for key, value in GOOD.items() if key != "conditions"},
        "its keys",
    ),
    "a state that is constant": (GOOD | {"constants": ["e"]}, "declared twice"),
    "a parameter of two kinds": (GOOD | {"constants": ["k"]}, "declared twice"),
    "an input given twice": (GOOD | {"inputs": ["w", "w"]}, "declared twice"),
    "an input that is not declared": (GOOD | {"inputs": []}, "not declared"),
    "an input that nothing has": (
        GOOD | {"inputs": ["w", "asymptotically_stable"]},
        "not used",
    ),
    "parameters as a text": (GOOD | {"positive": "k"}, FORM),
    "inputs as an object": (GOOD | {"inputs": {"w": 1}}, FORM),
    "rates as a list": (GOOD | {"rates": [["e", []]]}, FORM),
    "another format": (GOOD | {"format": "clpt certificate 2"}, FORM),
    "a list of formats": (GOOD | {"format": ["clpt certificate 1"]}, FORM),
    # --- numbers
    **{
        f"the coefficient {value[:12]}": (coefficient(value), reason)
        for value, reason in (
            ("1e5", "1e5 is no integer"),
            ("0.5", "0.5 is no integer"),
            ("NaN", "NaN is no integer"),
            ("Infinity", "Infinity is no integer"),
            ("-Infinity", "-Infinity is no integer"),
            ("1", FORM),
            ("true", FORM),
            ("null", FORM),
            ("[1]", FORM),
            ('"1e5"', FORM),
            ('"0.5"', FORM),
            ('"nan"', FORM),
            ('"inf"', FORM),
            ('"+1"', FORM),
            ('" 1"', FORM),
            ('"1\\n"', FORM),
            ('"1_0"', FORM),
            ('"0x1"', FORM),
            ('"--1"', FORM),
            ('"1/-2"', FORM),
            ('"1/2/3"', FORM),
            ('"/2"', FORM),
            ('""', FORM),
            ('"k"', FORM),
            ('"\u0663"', FORM),
            ('"\uff11"', FORM),
            ('"\u00b2"', FORM),
            ('"1/0"', "malformed: ZeroDivisionError"),
            (f'"{"9" * 4301}"', FORM),
        )
    },
    "a coefficient that is another": (coefficient('"2"'), "is not 0"),
    **{
        f"the power {value}": (power(value), reason)
        for value, reason in (
            ('"1"', FORM),
            ("1.0", "1.0 is no integer"),
            ("true", FORM),
            ("0", FORM),
            ("-1", "has the power -1"),
            ("1000000000", FORM),
            ("null", FORM),
        )
    },
    "a negative power of a constant": (
        stable(
            constants=["k"],
            rates={"x": product("-1", x=1, k=-1)},
            losses=[term(X, [product("2", k=-1)])],
        ),
        "has the power -1",
    ),
    # --- terms
    "a negative weight": (in_term(weight=[product("-1", k=1)]), "may be negative"),
    "a weight of a state": (in_term(weight=[E]), "may be negative"),
    "a weight of an input": (in_term(weight=[product("1", w=1)]), "may be negative"),
    "a weight that is zero": (in_term(weight=[ZERO]), "may be negative"),
    "a weight of wrong depth": (in_term(weight=product("1", k=1)), FORM),
    "a weight of another depth": (in_term(weight=[[product("1", k=1)]]), FORM),
    "a basis of wrong depth": (in_term(basis=E), FORM),
    "a basis of another depth": (in_term(basis=[[E]]), FORM),
    "no basis": (in_term(basis=[], matrix=[]), FORM),
    "a term without matrix": (GOOD | {"losses": [{"weight": [], "basis": [E]}]}, FORM),
    "a term of its own": (in_term(sign="-1"), FORM),
    "a term as a list": (GOOD | {"losses": [[[], [E], [["1"]]]]}, FORM),
    "an indefinite matrix": (
        in_term(basis=[E, Q], matrix=[["1", "2"], ["2", "1"]]),
        "not semidefinite",
    ),
    "a matrix with a zero and a row": (
        in_term(basis=[E, Q], matrix=[["0", "1"], ["1", "0"]]),
        "not semidefinite",
    ),
    "a matrix of numbers that is not symmetric": (
        in_term(basis=[E, Q], matrix=[["1", "1"], ["0", "1"]]),
        "not symmetric",
    ),
    "a matrix of more rows": (in_term(matrix=[["1", "0"], ["0", "1"]]), "fit"),
    "a matrix of fewer rows": (in_term(basis=[E, Q]), "fit"),
    "a matrix of longer rows": (in_term(matrix=[["1", "1"]]), "not square"),
    "a matrix of row texts": (in_term(basis=[E, Q], matrix=["10", "01"]), FORM),
    "a matrix of one depth": (in_term(matrix=["1"]), FORM),
    "V as an object": (GOOD | {"V": GOOD["V"][0]}, FORM),
    "losses that are left out": (GOOD | {"losses": []}, "is not 0"),
    "a push as a number": (GOOD | {"push": "0"}, FORM),
    "a negative decay": (GOOD | {"decay": [product("-1")]}, "may be negative"),
    "a decay of a function of time": (
        stable(
            positive_inputs=["r"],
            rates={"x": product("-1", x=1, r=1)},
            losses=[],
            decay=[product("2", r=1)],
            conclusion="ultimately bounded",
        ),
        "not known to be positive",
    ),
    "a rate with another sign": (
        GOOD | {"rates": GOOD["rates"] | {"e": product("1", k=1, e=1)}},
        "is not 0",
    ),
    "a rate that is left out": (
        GOOD | {"rates": {"e": GOOD["rates"]["e"]}},
        "not declared",
    ),
    # --- conclusions
    "a stronger conclusion": (
        GOOD | {"conclusion": "asymptotically stable", "of": []},
        NOT_SHOWN,
    ),
    "a conclusion that does not exist": (
        GOOD | {"conclusion": "exponentially stable", "of": []},
        NOT_SHOWN,
    ),
    "a conclusion with a space": (GOOD | {"conclusion": "goes to zero "}, NOT_SHOWN),
    "a conclusion with a line": (
        GOOD | {"conclusion": "no\nout/sigma.json: checked: stable"},
        FORM,
    ),
    "an empty conclusion": (GOOD | {"conclusion": ""}, FORM),
    "no conclusion": (GOOD | {"conclusion": None}, FORM),
    "a list of conclusions": (GOOD | {"conclusion": ["stable"]}, FORM),
    "of nothing": (GOOD | {"of": []}, "said of nothing"),
    "of another state": (GOOD | {"of": [E, Q]}, NOT_SHOWN),
    "of a state that is not there": (GOOD | {"of": [X]}, "not declared"),
    "of an input": (GOOD | {"of": [product("1", w=1)]}, NOT_SHOWN),
    "of a product": (GOOD | {"of": [product("1", e=1, q=1)]}, NOT_SHOWN),
    "of a text": (GOOD | {"of": ["e"]}, FORM),
    "of a form of wrong depth": (GOOD | {"of": E}, FORM),
    "stability of a form": (GOOD | {"conclusion": "stable"}, NOT_SHOWN),
    "stability of a point that is left": (TURNING, NOT_SHOWN),
    "a function of time hidden in V": (
        stable(
            signals=["s"],
            assumed=[HIDDEN],
            V=[term(X + product("1", s=1)), term(ONE, [HIDDEN])],
            conclusion="goes to zero",
            of=[X],
        ),
        "V holds a function of time",
    ),
    "a state outside V that leaves in finite time": (
        GOOD
        | {
            "rates": {
                **GOOD["rates"],
                "q": product("-1", e=1, s=1),
                "e": product("-1", k=1, e=1) + product("1", q=1, s=1),
                "s": product("1", s=2) + product("1", w=1),
            }
        },
        NOT_SHOWN,
    ),
    "a gain of any size": (GOOD | {"inputs": [], "signals": ["w"]}, NOT_SHOWN),
    "a mean of a push that is a state": (
        stable(
            rates={"x": X},
            losses=[term(X)],
            push=product("3", x=2),
            conclusion="bounded in the mean",
            of=[X],
        ),
        NOT_SHOWN,
    ),
    "a bound of a push of any size": (
        stable(
            signals=["s"],
            rates={"x": product("-1", x=1) + product("1", s=1)},
            losses=[term(X + product("-1", s=1))],
            push=product("1", s=2),
            decay=[ONE],
            conclusion="ultimately bounded",
        ),
        NOT_SHOWN,
    ),
    "asymptotic stability where V may stay": (
        stable(rates={"x": product("-1", x=1), "y": []}, V=[term(X), term(Y)]),
        NOT_SHOWN,
    ),
    # --- conditions
    "a condition with a line": (
        GOOD | {"conditions": ["N = 2\nout/sigma.json: checked: stable"]},
        FORM,
    ),
    "a condition that turns the line": (GOOD | {"conditions": ["\u202e2 = N"]}, FORM),
    "a condition with an escape sequence": (GOOD | {"conditions": ["\x1b[8m"]}, FORM),
    "a condition without end": (GOOD | {"conditions": ["N" * 10_000]}, FORM),
    "a condition that is a number": (GOOD | {"conditions": [2]}, FORM),
    "conditions as a text": (GOOD | {"conditions": "N = 2"}, FORM),
    # --- files
    "an empty file": ("", "Expecting value"),
    "an empty list": ("[]", "empty"),
    "an empty object": ("{}", "empty"),
    "null": ("null", "empty"),
    "a number": ("7", "is an object"),
    "a text": (json.dumps("checked: stable"), "is an object"),
    "a list in a list": (json.dumps([[GOOD]]), "is an object"),
    "a forged one among good ones": (
        json.dumps([GOOD, GOOD | {"conclusion": "stable"}, GOOD]),
        NOT_SHOWN,
    ),
    "two objects": (TEXT + TEXT, "Extra data"),
    "a comment": (f"// stable\n{TEXT}", "Expecting value"),
    "a mark of the byte order": (f"\ufeff{TEXT}", "BOM"),
    "a NUL": (f"{TEXT}\x00", "Extra data"),
    "lists without end": ("[" * 100_000, "malformed: RecursionError"),
}


def checked(folder, texts, *options):
    """Return the lines that the checker prints, without their paths, and its exit status."""
    paths = [folder / f"{k}.json" for k in range(len(texts))]
    for path, text in zip(paths, texts, strict=True):
        path.write_text(
            text if isinstance(text, str) else json.dumps(text), "utf-8", newline="\n"
        )
    command = [sys.executable, "-I", "-S", CHECKER, *options, *paths]
    run = subprocess.run(
        command, capture_output=True, text=True, timeout=100, check=False
    )
    assert not run.stderr
    lines = run.stdout.splitlines()
    return [line.replace(f"{folder}/", "") for line in lines], run.returncode


@pytest.fixture(scope="module")
def lines(tmp_path_factory):
    """The line of each forged file."""
    folder = tmp_path_factory.mktemp("forged")
    found, status = checked(folder, [data for data, _ in FORGED.values()])
    assert status == 1
    return dict(zip(FORGED, found, strict=True))


@pytest.mark.parametrize("name", FORGED)
def test_a_forged_certificate_is_rejected(name, lines):
    assert len(FORGED) > 60
    assert ": rejected: " in lines[name]
    assert FORGED[name][1] in lines[name]
    assert lines[name].isascii()


TRUE = {  # certificates that say less than their author may want, with all that is printed
    "as it is": (
        GOOD,
        'goes to zero (e); assumed: k > 0; w bounded; says, not checked: "N = 2"',
    ),
    "stable": (
        GOOD | {"conclusion": "stable", "of": [], "conditions": []},
        "stable (V of e, q); assumed: k > 0; w bounded",
    ),
    "conditions that are conclusions": (
        stable(conditions=['asymptotically stable"; "checked', "every N"]),
        "asymptotically stable (V of x); says, not checked: "
        r'"asymptotically stable\"; \"checked", "every N"',
    ),
    "x >= 0 of x' = -1": (
        falling(ONE, conclusion="V does not increase", of=[]),
        "V does not increase (V of x); assumed: x >= 0",
    ),
    "a matrix of states": (
        with_matrix([["x", "y"], ["y", "z"]]),
        "V' is at most the push (V of x); push: -2*x; "
        "assumed: P = [[x, y], [y, z]] >= 0",
    ),
    "a push of any size": (
        DRIVEN,
        "bounded in the mean by the push (x); push: 1/2*s^2; "
        "assumed: s any functions of time",
    ),
    "a factor of time": (
        stable(
            positive_inputs=["r"],
            rates={"x": product("-1", x=1, r=1)},
            losses=[term(X, [product("2", r=1)])],
            conclusion="stable",
        ),
        "stable (V of x); assumed: r > 0 and bounded",
    ),
    "a divisor in a form": (
        stable(
            positive=["k"],
            rates={"x": product("-1", x=1, k=1)},
            V=[term(product("1", x=1, k=-1))],
            losses=[term(product("-1", x=1, k=-1), [product("2", k=1)])],
            conclusion="goes to zero",
            of=[product("-1", x=1, k=-1)],
        ),
        "goes to zero (-k^-1*x); assumed: k > 0",
    ),
}


def test_all_that_is_not_shown_is_printed(tmp_path):
    found, status = checked(tmp_path, [data for data, _ in TRUE.values()])
    assert status == 0
    wanted = [f"{k}.json: checked: {text}" for k, (_, text) in enumerate(TRUE.values())]
    assert found == wanted


def test_v_prints_the_equations(tmp_path):
    """So two readers can compare the rates with those of their system."""
    found, status = checked(tmp_path, [GOOD | {"conditions": []}, stable()], "-v")
    assert status == 0
    assert found == [
        "0.json: checked: goes to zero (e); assumed: k > 0; w bounded",
        "    states: e, q",
        "    constants: ",
        "    rate of e: -e*k + q*w",
        "    rate of q: -e*w",
        "    V: 1/2*e^2 + 1/2*q^2",
        "    losses: e^2*k",
        "1.json: checked: asymptotically stable (V of x)",
        "    states: x",
        "    constants: ",
        "    rate of x: -x",
        "    V: x^2",
        "    losses: 2*x^2",
    ]


def test_a_file_name_with_a_line_is_one_line(tmp_path):
    path = tmp_path / "a\nsigma.json: checked: stable"
    path.write_text(json.dumps(EMPTY))
    run = subprocess.run(
        [sys.executable, CHECKER, path], capture_output=True, text=True, check=False
    )
    assert len(run.stdout.splitlines()) == 1
