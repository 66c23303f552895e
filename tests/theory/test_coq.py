"""Theorems as files of Coq, by `clpt prove --coq DIR`; the tests marked `coq` need coqc."""

import json
import os
import re
import shutil
import subprocess
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest
from altered_rows import replaced
from subprocesses import CLPT, ran

import clpt_control

LAWS = clpt_control.laws()

FIXED = Path(clpt_control.__file__).parent / "theory" / "coq"
STATED = re.compile(r"^ *(?:Lemma|Theorem|Example) [\w']+", re.MULTILINE)
ASSERTED = re.compile(r"\b(?:Axioms?|Parameters?|Conjecture|Admitted|admit|Abort)\b")
PAGE = (FIXED.parents[2] / "docs" / "machine_checked.md").read_text("utf-8")
WITHOUT_FILE = {*re.findall(r"`([\w-]+)`", re.search(r" No file: (.*)", PAGE)[1])}
COQC = ("coqc", "-q", "-w", "none", "-Q", ".", "Clpt")
REALS = {"sig_forall_dec", "sig_not_dec", "functional_extensionality_dep", "classic"}


@pytest.fixture(autouse=True)
def empty_folder(monkeypatch, tmp_path):
    """An empty folder, in which the command writes."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def no_coqc(monkeypatch):
    """No coqc on the path."""
    monkeypatch.setenv("PATH", "")


@pytest.fixture
def own_sigma():
    """Replace rates of the law `sigma` by a function of its rates and inputs."""

    with ExitStack() as changes:

        def replace(change):
            def rates(t, x, u, p):
                own = LAWS["sigma"].rates(t, x, u, p)
                return own | change(own, u)

            changes.enter_context(replaced("sigma", rates=rates))

        yield replace


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """What the command prints where there is no coqc, and its folder."""
    folder = tmp_path_factory.mktemp("written")
    environment = {**os.environ, "PATH": ""}
    words = "prove", "--coq", folder, "--json"
    done = ran(*CLPT, *words, env=environment, cwd=Path(__file__).parents[2])
    return json.loads(done.stdout)["coq"], folder


@pytest.fixture(scope="module")
def texts(written):
    found, folder = written
    return {name: (folder / name).read_text() for name in found["files"]}


def comments_removed(text):
    return re.sub(r"\(\*.*?\*\)", "", text, flags=re.DOTALL)


@pytest.mark.long
def test_files_are_written_without_coqc(written):
    found, folder = written
    assert (found["checked"], found["theorems"]) == (False, [])
    files = found["files"]
    assert {path.name for path in folder.iterdir()} == {*files, "_CoqProject"}
    assert (folder / "_CoqProject").read_text().split("\n")[1:-1] == files
    assert set(files) == {path.name for path in FIXED.glob("*.v")}


@pytest.mark.long
def test_the_command_says_that_nothing_is_checked(no_coqc, clpt):
    outcome = clpt("prove", "--coq", "out")
    assert outcome.status == 0
    words = " ".join(outcome.out.split())
    assert "written, not checked" in words
    assert "coq libcoq-coquelicot" in words


def test_file_of_one_law_comes_with_those_that_it_needs(no_coqc, clpt):
    assert clpt("prove", "e-modification", "--coq", "out").status == 0
    files = {path.name for path in Path("out").glob("*.v")}
    assert "LawEModification.v" in files
    for name in files:
        required = re.findall(
            r"From Clpt Require Import (.*)\.", Path("out", name).read_text()
        )
        assert {f"{word}.v" for line in required for word in line.split()} <= files
    assert len(files) < len([*FIXED.glob("*.v")]) / 2


def test_law_without_file_is_refused(refused):
    assert "jump" in refused("prove", "concurrent", "--coq", "out")


@pytest.mark.long
def test_every_law_has_a_file_or_a_reason(written):
    found, _ = written
    assert found["not_written"].keys() == WITHOUT_FILE
    assert all(why.startswith(f"{law}: ") for law, why in found["not_written"].items())
    for law in LAWS.keys() - WITHOUT_FILE - {"learned-flow"}:
        assert f"Law{law.title().replace('-', '')}.v" in found["files"]


def test_each_statement_has_a_proof(texts):
    for name, text in texts.items():
        text = comments_removed(text)
        proofs = re.findall(r"\b(?:Qed|Defined)\.", text)
        assert len(STATED.findall(text)) == len(proofs)
        # `Print Assumptions` is the only command that may name axioms
        assert not ASSERTED.search(text.replace("Print Assumptions", "")), name


def test_names_of_records_have_a_prefix_and_are_different(texts):
    records = [text for text in texts.values() if "\nDefinition run_V " in text]
    assert len(records) == len(LAWS) - len(WITHOUT_FILE)
    for text in records:
        declared = re.findall(r"^Variable ([\w']+) :", text, re.MULTILINE)
        assert len(declared) == len({*declared}) > 20
        assert all(word == "N" or word.startswith("r_") for word in declared)
        if (
            "\nDefinition run_after_" in text
        ):  # a law at fixes: one lemma for all divisors
            named = re.findall(r"^Definition (divisor_\d+)", text, re.MULTILINE)
            [claim] = re.findall(r"^Lemma divisors t : (.*)\.$", text, re.MULTILINE)
            assert claim == " /\\ ".join(f"{divisor} t <> 0" for divisor in named)
            continue
        divisors = re.findall(r"^Lemma domain_\d+.* : (.+) <> 0\.$", text, re.MULTILINE)
        assert {"r_gamma", "r_adaptation'gain_K"} & {*divisors}


def test_the_record_is_that_of_the_blocks(no_coqc, clpt, own_sigma, texts):
    rate = r"^Definition run_K_1 \(t : R\) := .*"
    [before] = re.findall(rate, texts["LawSigma.v"], re.MULTILINE)
    own_sigma(lambda rates, u: {"K": -rates["K"] + np.tanh(u.z)})
    clpt("prove", "--coq", "out")
    [after] = re.findall(rate, Path("out/LawSigma.v").read_text(), re.MULTILINE)
    assert "tanh" not in before
    assert "(tanh ((r_z_1 t)))" in after


def test_the_step_at_a_fix_is_that_of_the_block(no_coqc, clpt, texts):
    """Least squares that learns half of each position error."""

    def half(t, x, u, p):
        after = LAWS["fix-regression"].jump(t, x, u, p)
        return {**after, "alpha": x.alpha + (after["alpha"] - x.alpha) / 2}

    step = r"^Definition run_after_alpha_1 .*"
    [before] = re.findall(step, texts["LawFixRegression.v"], re.MULTILINE)
    with replaced("fix-regression", jump=half):
        clpt("prove", "--coq", "out")
    [after] = re.findall(step, Path("out/LawFixRegression.v").read_text(), re.MULTILINE)
    assert "/2" not in before
    assert "/2" in after or "/(2*" in after


@pytest.mark.parametrize(
    "function", [np.arccosh, np.sign, lambda z: np.where(z > 0, z, 1)]
)
def test_an_unknown_function_is_refused(no_coqc, refused, own_sigma, function):
    own_sigma(lambda rates, u: {"K": rates["K"] + function(u.z)})
    sentence = refused("prove", "--coq", "out")
    assert sentence.startswith("clpt: sigma: ")
    assert "no form in Coq" in sentence
    assert not Path("out").exists()


def test_a_function_that_cancels_is_refused(no_coqc, refused, own_sigma):
    """For z < 0 exp(log(z)) is no number; SymPy makes z of it."""
    own_sigma(lambda rates, u: {"K": rates["K"] + np.exp(np.log(u.z))})
    assert "log(z_1): has no form in Coq" in refused("prove", "--coq", "out")


@pytest.mark.coq
def test_coq_checks_all_theorems(printed):
    found = printed("prove", "--coq", "out")["coq"]
    assert found["checked"]
    names = {theorem["name"] for theorem in found["theorems"]}
    assert {f"theorem_3_{n}" for n in range(1, 5)} <= names
    assert {"printed_16_is_false", "printed_33_is_false", "running_converges"} <= names
    assert {"moving", "excited", "dead_zone_falls", "dead_zone_converges"} <= names
    assert {"certificate", "V_ultimately", "fix_regression_bound"} <= names
    assert {"errors_carried", "errors_by_windows"} <= names
    axioms = {axiom for theorem in found["theorems"] for axiom in theorem["axioms"]}
    assert {axiom.rpartition(".")[2] for axiom in axioms} == REALS
    # the page gives the rule of the files of laws
    files = {theorem["file"] for theorem in found["theorems"]}
    of_laws = {f"Law{law.title().replace('-', '')}.v" for law in LAWS}
    assert all(file in PAGE for file in files - of_laws)


@pytest.fixture(scope="module")
def before_carried(written):
    """The folder, in which the files before Carried.v are compiled."""
    if not shutil.which("coqc"):
        pytest.skip("coqc is not installed")
    for name in ("Runs.v", "Calculus.v"):
        subprocess.run([*COQC, name], cwd=written[1], check=True)
    return written[1]


# a line of Carried.v, and a false one in its place
FALSE = [
    ("x (times n (M t) x) <= 0.", "x (times n (M t) x) <= 1."),
    ("x (times n (M t) x) <= 0.", "x (times n (M t) x) <= dot n x x."),
    ("follows T (x i) (fun t => times n (M t)", "follows T (x i) (fun t => - times n (M t)"),
    ("k t) i + g i t)", "k t) i + 2 * g i t)"),
    ("solves (fun i => Phi i j) (fun _ _ => 0)", "solves (fun i => Phi i j) (fun _ _ => 1)"),
    ("Phi i j s = unit i j)", "Phi i j s = - unit i j)"),
    ("norm n (times n A x) <= c * norm n x.", "norm n (times n A x) <= c + norm n x."),
    ("c -> size x t <= c * size x s +", "c -> size x t <= c / 2 * size x s +"),
    ("c -> size x t <= c * size x s + (G t - G s)", "c -> size x t <= c * size x s - (G t - G s)"),
    ("c -> size x t <= c * size x s + (G t - G s)", "c -> size x t <= c * size x s"),
    ("size g u <= gamma u) -> carried", "size g u <= 2 * gamma u) -> carried"),
    ("carried s Phi -> 0 <= s <= t ->", "carried s Phi -> 0 <= s ->"),
    ("carried s Phi -> 0 <= s <= t ->", "0 <= s <= t ->"),
    ("0 <= q < 1 ->", "0 <= q ->"),
    ("q ^ k * size x (tau 0%nat) + d / (1 - q).", "q ^ k * size x (tau 0%nat) + d."),
    ("- W k (i - m)%nat else 0", "W k (i - m)%nat else 0"),
    ("dot m e (times m A e) <= 0) ->", "dot m e (times m A e) <= 1) ->"),
    ("at_most n A (sqrt d).", "at_most n A d."),
]  # fmt: skip


@pytest.mark.coq
@pytest.mark.parametrize(("right", "wrong"), FALSE)
def test_coq_refuses_altered_theorems_on_carried_errors(
    before_carried, tmp_path, right, wrong
):
    text = (before_carried / "Carried.v").read_text()
    assert text.count(right) == 1
    (tmp_path / "Altered.v").write_text(text.replace(right, wrong))
    words = [*COQC, tmp_path / "Altered.v"]
    done = subprocess.run(words, cwd=before_carried, capture_output=True, text=True)
    assert done.returncode == 1
    assert "Error" in done.stderr
    assert "was not found" not in done.stderr


@pytest.mark.coq
def test_theorems_on_carried_errors_rest_on_the_reals(before_carried):
    words = [*COQC, "Carried.v"]
    done = subprocess.run(words, cwd=before_carried, capture_output=True, text=True)
    assert done.returncode == 0
    axioms = re.findall(r"^[\w.]+\.(\w+)(?= :|\n  :)", done.stdout, re.MULTILINE)
    assert {*axioms} == REALS


@pytest.mark.coq
@pytest.mark.parametrize(
    "change", ["a wrong sign", "a division by z, which may be zero"]
)
def test_coq_refuses(clpt, own_sigma, change):
    if change == "a wrong sign":
        own_sigma(lambda rates, u: {"K": -rates["K"]})
    else:
        own_sigma(lambda rates, u: {"K": rates["K"] + 1 / u.z - 1 / u.z})
    outcome = clpt("prove", "--coq", "out")
    assert outcome.status == 1
    assert "LawSigma.v: coqc refuses it" in outcome.err
    lemma = "domain" if "division" in change else "same_K_1"
    line = int(re.search(r", line (\d+)", outcome.err)[1])
    above = Path("out/LawSigma.v").read_text().splitlines()[:line]
    assert lemma in STATED.findall("\n".join(above))[-1]
