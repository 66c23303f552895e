"""A checker without the package accepts certificates, and rejects altered ones."""

import json
import subprocess
import sys
from copy import deepcopy
from fractions import Fraction
from pathlib import Path

import control
import numpy as np
import pytest

import clpt_control as clpt

pytestmark = pytest.mark.long  # by `make test-long`

ROOT = Path(__file__).parents[2]
CHECKER = ROOT / "tools" / "check_certificate.py"
LAWS = {  # with settings that a law needs
    **{
        key: {}
        for key in ("learned-flow", "sigma", "concurrent", "normalised-gradient")
    },
    "kalman-flow": {"learning.parameters": None},
}
STRENGTH = ("asymptotically stable", "goes to zero", "stable", "V does not increase")


def system(rates, states, inputs=(), **params):
    return control.nlsys(
        lambda t, x, u, p: rates(x, u, p),
        None,
        states=list(states),
        inputs=list(inputs),
        outputs=list(states),
        params=params,
        name="plant",
    )


SYSTEMS = {
    "asymptotically stable": (
        system(lambda x, u, p: [-(x[0] ** 3) + x[1], -(x[0] ** 3) - x[1]], "xy"),
        lambda s: s.x**4 / 4 + s.y**2 / 2,
    ),
    "gram": (
        system(lambda x, u, p: [-x[0] + x[1], -x[1]], "xy"),
        lambda s: (
            s.x**4 + 3 * s.y**4 + s.x**2 * s.y**2 + s.x**3 * s.y + s.x**2 + s.y**2
        ),
    ),
    "goes to zero": (
        system(lambda x, u, p: [-x[0] + x[1] * u[0], -2 * x[0] * u[0]], "ek", "r"),
        lambda s: s.e**2 / 2 + s.k**2 / 4,
    ),
    "ultimately bounded": (
        system(lambda x, u, p: [-x[0] + x[1] + 1, -x[0] - 2 * x[1] + 2], "xy"),
        lambda s: s.x**2 + s.y**2,
    ),
    "divided": (
        system(lambda x, u, p: [-x[0] / (1 + x[1] ** 2), -x[1]], "xy"),
        lambda s: s.x**2 + s.y**2,
    ),
}


def checked(paths, checker=CHECKER):
    """The lines that the checker prints without any package, and its exit status."""
    command = [sys.executable, "-I", "-S", checker, *paths]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert not run.stderr
    return run.stdout.splitlines(), run.returncode


@pytest.fixture(scope="module")
def cases():
    """Certificates by name, each with the cases of its file."""
    found = {
        name: [clpt.lyapunov(*of, points=20).certificate()]
        for name, of in SYSTEMS.items()
    }
    for name, settings in LAWS.items():
        scenario = clpt.paper_scenario().with_values({"learning.law": name, **settings})
        loop = clpt.closed_loop(scenario)
        found[name] = [clpt.prove(loop, points=20).certificate()]
    return found


def written(folder, certificates):
    paths = [folder / f"{k}.json" for k in range(len(certificates))]
    for path, data in zip(paths, certificates, strict=True):
        path.write_text(json.dumps(data))
    return paths


def test_certificates_are_accepted(cases, tmp_path):
    lines, status = checked(written(tmp_path, [*cases.values()]))
    assert status == 0
    assert all(": checked: " in line for line in lines)
    by_name = dict(zip(cases, lines, strict=True))
    assert "goes to zero (e_1, e_2)" in by_name["learned-flow"]
    assert "ultimately bounded" in by_name["sigma"]
    assert "S = [[S[1][1], S[2][1]], [S[2][1], S[2][2]]] >= 0" in by_name["concurrent"]
    assert "Delta_1" in by_name["sigma"]  # in the push
    assert any(len(t["basis"]) > 1 for t in cases["gram"][0]["V"])  # a Gram matrix


def test_it_is_the_same_file_in_the_package(cases, tmp_path):
    paths = written(tmp_path, [*cases.values()])
    package = ROOT / "clpt_control" / "data" / "check_certificate.py"
    assert checked(paths, package) == checked(paths)


# --- altered certificates ----------------------------------------------------------------------


def names(terms):
    return {s for _, powers in terms for s in powers}


def altered(terms):
    """Each sign flipped, each coefficient doubled, each monomial dropped."""
    for k, (c, powers) in enumerate(terms):
        for new in (-Fraction(c), 2 * Fraction(c)):
            yield [*terms[:k], [str(new), powers], *terms[k + 1 :]]
        yield terms[:k] + terms[k + 1 :]


def alterations(data):
    """Every certificate with one thing altered that makes its statement false or unfounded."""

    def new(**fields):
        return deepcopy(data) | fields

    in_V = {s for term in data["V"] for b in term["basis"] for s in names(b)}
    for s in in_V & data["rates"].keys():
        for terms in altered(data["rates"][s]):
            yield new(rates=data["rates"] | {s: terms})
    for s in data["rates"].keys() - in_V:  # no longer pulled back
        terms = [
            [str(-Fraction(c)) if s in powers else c, powers]
            for c, powers in data["rates"][s]
        ]
        yield new(rates=data["rates"] | {s: terms})
    for part in ("V", "losses"):
        for k, term in enumerate(data[part]):
            before, after = data[part][:k], data[part][k + 1 :]
            yield new(**{part: before + after})
            for factor in ("-1", "2", "0"):
                weight = [*term["weight"], [[factor, {}]]]
                yield new(**{part: [*before, term | {"weight": weight}, *after]})
            for j, b in enumerate(term["basis"]):
                basis = [*term["basis"]]
                for basis[j] in list(altered(b))[1:2]:  # twice as large
                    yield new(**{part: [*before, term | {"basis": basis}, *after]})
            if isinstance(term["matrix"], list) and len(term["matrix"]) > 1:
                matrix = deepcopy(term["matrix"])
                matrix[0][0] = f"-{matrix[0][0]}"
                yield new(**{part: [*before, term | {"matrix": matrix}, *after]})
    for terms in altered(data["push"]):
        yield new(push=terms)
    yield new(push=[*data["push"], ["1", {}]])
    yield new(decay=[*data["decay"], [["7", {}]]])
    # what is needed of parameters and inputs
    weights = [w for term in data["V"] + data["losses"] for w in term["weight"]]
    for s in set(data["positive"]) & set().union(*map(names, weights)):
        if all(names(w) for w in weights if s in names(w)) and not data["assumed"]:
            positive = [v for v in data["positive"] if v != s]
            yield new(constants=[*data["constants"], s], positive=positive)
    moving = set()
    if data["conclusion"] == "goes to zero":
        of = set().union(*map(names, data["of"])) & data["rates"].keys()
        moving = set().union(*(names(data["rates"][s]) for s in of))
    elif data["conclusion"] == "ultimately bounded":
        moving = names(data["push"])
    for s in moving & {*data["inputs"]}:
        inputs = [v for v in data["inputs"] if v != s]
        yield new(inputs=inputs, signals=[*data["signals"], s])
    for s in [*data["inputs"], *data["positive"], *data["constants"]]:
        kinds = ("inputs", "positive", "constants")
        yield new(**{k: [v for v in data[k] if v != s] for k in kinds})  # not declared
        yield new(signals=[*data["signals"], s])  # twice
    # claims
    if data["conclusion"] in STRENGTH:
        for claim in STRENGTH[: STRENGTH.index(data["conclusion"])]:
            yield new(conclusion=claim)
    else:
        for claim in STRENGTH:
            yield new(conclusion=claim)
    yield new(of=[*data["of"], [["1", {"unknown": 1}]]])
    yield new(conclusion="goes to zero", of=[])
    yield new(format="clpt certificate 0")


@pytest.mark.parametrize("every", [5, pytest.param(1, marks=pytest.mark.slow)])
def test_altered_certificates_are_rejected(cases, tmp_path, every):
    files = [
        data for certificates in cases.values() for data in alterations(*certificates)
    ][::every]
    lines, status = checked(written(tmp_path, files))
    accepted = [k for k, line in enumerate(lines) if ": rejected: " not in line]
    assert status == 1
    assert len(files) > 1000 / every
    print(f"{len(lines) - len(accepted)} of {len(files)} rejected")
    assert [lines[k] for k in accepted] == []


@pytest.mark.parametrize(
    "content",
    ["", "{}", "[]", "null", "7", '{"format": "clpt certificate 1"}', "\x00", "[[]]"],
)
def test_malformed_files_are_rejected_in_a_line(content, tmp_path):
    path = tmp_path / "a.json"
    path.write_text(content)
    (line,), status = checked([path])
    assert status == 1
    assert line.startswith(f"{path}: rejected: ")


def test_a_fast_gain_does_not_go_to_zero(cases, tmp_path):
    """A signal of any size in e' is found, as the pulses of a gain that grows ever narrower."""
    (data,) = cases["learned-flow"]
    rates = deepcopy(data["rates"])
    product = {"s": 1, "K_1": 1, "e_2": 1}
    rates["e_1"].append(["1", product])  # e_2 e_1 K_1 s less itself: V' stays as it is
    rates["e_2"].append(["-1", {"s": 1, "K_1": 1, "e_1": 1}])
    changed = data | {"rates": rates, "signals": ["s"]}
    weaker = changed | {"conclusion": "square-integrable"}
    lines, _ = checked(written(tmp_path, [changed, weaker]))
    assert "rejected: 'goes to zero' does not follow of each form" in lines[0]
    assert "checked: square-integrable (e_1, e_2)" in lines[1]


def test_rates_that_the_proof_does_not_use_are_left_out(cases):
    """V of sigma bounds the errors for each x(t); Barbalat's lemma needs a bounded x."""
    (sigma,), (paper,) = cases["sigma"], cases["learned-flow"]
    assert {"x_1", "x_2"} <= {*sigma["signals"]} - sigma["rates"].keys()
    assert {"x_1", "x_2"} <= paper["rates"].keys()


def test_a_rate_that_is_left_out_makes_no_conclusion_stronger(tmp_path):
    """s' = 1 + s^2 leaves in finite time: e goes to zero for no t -> infinity."""
    plant = system(lambda x, u, p: [-x[0] + x[1], -x[0], 1 + x[2] ** 2], "eqs")
    data = clpt.lyapunov(plant, lambda s: s.e**2 + s.q**2, points=20).certificate()
    assert data["rates"].keys() == {"e", "q"}
    assert data["conclusion"] == "square-integrable"
    lines, _ = checked(written(tmp_path, [data]))
    assert ": checked: square-integrable (e)" in lines[0]


def test_names_of_a_file_are_ascii(tmp_path):
    plant = control.nlsys(
        lambda t, x, u, p: -np.asarray(x),
        None,
        states=["\u03b8", "_2"],
        inputs=0,
        outputs=2,
        name="plant",
    )
    verdict = clpt.lyapunov(
        plant, lambda s: sum(getattr(s, x) ** 2 for x in plant.state_labels), points=20
    )
    data = verdict.certificate()
    assert [*data["rates"]] == ["u03b8", "s2"]
    lines, status = checked(written(tmp_path, [data]))
    assert status == 0
    assert "asymptotically stable (V of s2, u03b8)" in lines[0]


def test_no_certificate_has_a_reason():
    pendulum = system(lambda x, u, p: [x[1], -np.sin(x[0]) - x[1]], "qw")
    verdict = clpt.lyapunov(pendulum, lambda s: 1 - np.cos(s.q) + s.w**2 / 2)
    assert verdict.certificate() is None
    assert verdict.why_no_certificate() == "1 - cos(q) is no square"


def test_clpt_prove_writes_them(clpt, tmp_path):
    printed = clpt("prove", "learned-flow", "--certificates", tmp_path / "out")
    path = tmp_path / "out" / "law_learned-flow.json"
    assert "Wrote 1 certificate to" in str(printed)
    (line,), status = checked([path])
    assert status == 0
    assert "checked: goes to zero" in line


WRITTEN = [
    (["learned-flow"], ["law_learned-flow"]),
    (["--theorem", "3.2"], ["theorem_3_2"]),
    pytest.param([], None, marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("words", "names"), WRITTEN)
def test_every_certificate_of_the_paper_and_the_laws_is_checked(
    clpt, tmp_path, words, names
):
    """`clpt prove --certificates` writes 17 files, and the checker accepts each."""
    outcome = clpt("prove", *words, "--certificates", tmp_path / "out")
    assert outcome.status == 0, outcome.err
    paths = sorted((tmp_path / "out").glob("*.json"))
    assert len(paths) == 17 or [path.stem for path in paths] == names
    done = subprocess.run(
        [sys.executable, CHECKER, *paths], capture_output=True, text=True, timeout=600
    )
    assert done.returncode == 0, done.stdout
    assert done.stdout.count("checked") >= 1
