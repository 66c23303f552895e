"""Altered equations in Coq, by `make proofs`, after `clpt prove --coq DIR`.

    python tools/check_proofs.py DIR

Each rate of each record, and V, gets one wrong sign: coqc must refuse the file in the first lemma
that names the rate.  Controls must compile: each rate written as 0 + rate, and a law block of the
paper through the printer, whose copy with a wrong sign must fail.  Then `coqchk` checks all files.
"""

import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

import numpy as np

import clpt_control as clpt
from clpt_control.paper.laws.table import LAWS
from clpt_control.theory.coq.files import COQC, RECORD, coq_files, record_of, templates
from clpt_control.theory.coq.printing import text_of
from clpt_control.theory.coq.running import WIRED, equations_of, law_and_V, law_loop

DEFINED = re.compile(r"^Definition (run_[\w']+)(.*?) := (.*)\.$", re.MULTILINE)
LEMMA = re.compile(r"^(?:Lemma|Theorem) ([\w']+).*?\b(?:Qed|Admitted)\.$", re.M | re.S)


class Case(NamedTuple):
    """A file to compile."""

    name: str
    text: str
    lemma: str | None  # in which coqc must refuse the file; None: it compiles


def with_one_sign(expression):
    """Return an expression with its last sign altered."""
    signs = list(re.finditer(r" ([+-]) ", expression))
    if not signs:
        return f"- ({expression})"
    start, end = signs[-1].span()
    return (
        expression[:start] + {"+": " - ", "-": " + "}[signs[-1][1]] + expression[end:]
    )


def lemma_of(text, rate):
    """Return the name of the first lemma with a rate in its text."""
    return next(
        (m[1] for m in LEMMA.finditer(text) if re.search(rf"\b{rate}(?![\w'])", m[0])),
        f"(no lemma has {rate})",
    )


def with_lemma(text, lemma):
    """Return a file whose proofs before a lemma are skipped: the unaltered file has them."""
    start = text.find(f"Lemma {lemma} ")
    skipped = re.sub(r"Proof\..*?\bQed\.", "Admitted.", text[:start], flags=re.DOTALL)
    return skipped + text[start:]


def altered(file, text):
    """Yield a file with one wrong sign in each rate, and a control with all rates as 0 + rate."""
    for found in DEFINED.finditer(text):
        rate, arguments, expression = found.groups()
        wrong = f"Definition {rate}{arguments} := {with_one_sign(expression)}."
        lemma = lemma_of(text, rate)
        changed = with_lemma(text.replace(found[0], wrong), lemma)
        yield Case(f"{file} {rate}", changed, lemma)
    right = DEFINED.sub(r"Definition \1\2 := 0 + (\3).", text)
    yield Case(f"{file} control", right, None)


def paper_law(sign):
    """Return the paper's law as a block of its own, with a sign of K'."""

    def rates(t, x, u, p):
        return {
            "alpha": -p.gain * np.outer(u.e, u.phi_x),
            "K": sign * p.gain * u.z * u.e,
            "Gamma": p.gain * u.zc * u.e,
        }

    law = LAWS["learned-flow"]
    block, V = law_and_V(law, WIRED)
    own = clpt.Block(
        "adaptation",
        update=rates,
        inputs={"e": 2, "phi_x": "N", "z": 2, "zc": 2},
        states={"alpha": (2, "N"), "K": 2, "Gamma": 2},
        parameters={"gain": block.parameters.gain},
        sizes={"N": WIRED},
    )
    record = text_of(equations_of(law_loop(law, own, V)))
    text = coq_files()["RunningN.v"].replace(record_of("learned-flow"), record)
    name, lemma = ("wrong", "same_K_1") if sign > 0 else ("right", None)
    return Case(f"RunningN.v block with the {name} sign of K'", text, lemma)


def is_as_expected(folder, case):
    """Compile a case, print a line, and return True if the result is the expected one."""
    started = time.monotonic()
    with tempfile.TemporaryDirectory() as own:
        path = Path(own) / "Altered.v"
        path.write_text(case.text)
        done = subprocess.run(
            [*COQC, str(path)], cwd=folder, capture_output=True, text=True
        )
    result = "compiles" if done.returncode == 0 else "refused"
    place = re.search(r", line (\d+), characters", done.stderr)
    at = None
    if place:
        offset = sum(map(len, case.text.splitlines(True)[: int(place[1]) - 1]))
        at = next((m[1] for m in LEMMA.finditer(case.text) if m.end() > offset), None)
    as_expected = at == case.lemma and (result == "refused") == (case.lemma is not None)
    where = f" in {at}" if at else ""
    more = "" if as_expected else f"; expected: {case.lemma or 'compiles'}"
    seconds = time.monotonic() - started
    print(f"{case.name}: {result}{where}, {seconds:.1f} s{more}", flush=True)
    return as_expected


def main(folder):
    """Compile all cases by two processes, run coqchk, and exit with 1 after a surprise."""
    texts = coq_files()
    with_record = [name for name, text in templates().items() if RECORD.search(text)]
    cases = [paper_law(sign) for sign in (1.0, -1.0)]
    cases += [case for name in with_record for case in altered(name, texts[name])]
    with ThreadPoolExecutor(2) as pool:
        good = list(pool.map(lambda case: is_as_expected(folder, case), cases))
    wrong = sum(case.lemma is not None for case in cases)
    print(
        f"{wrong} altered files and {len(cases) - wrong} controls, {good.count(False)} surprises"
    )
    modules = [word for name in texts for word in ("-norec", f"Clpt.{Path(name).stem}")]
    started = time.monotonic()
    done = subprocess.run(
        ["coqchk", "-silent", "-Q", ".", "Clpt", *modules], cwd=folder
    )
    print(f"coqchk: exit status {done.returncode}, {time.monotonic() - started:.1f} s")
    sys.exit(not all(good) or done.returncode)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
