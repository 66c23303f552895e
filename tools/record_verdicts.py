"""Guard of changes in `clpt_control.theory`: every verdict that tests ask for, before and after.

Record the verdicts of both versions, as a plug-in of pytest, and compare the two files:

    RECORD_TO=before.jsonl PYTHONPATH=tools pytest -p record_verdicts tests/theory/test_signs.py
    python tools/record_verdicts.py before.jsonl after.jsonl

A line of a file has the test, the number of the verdict in it, seconds of CPU, and texts of the
verdict: its sentence, steps and conditions, its file of Coq and its LaTeX.  A comparison prints the
first difference of each text and ends with status 1 if there are any.
"""

import functools
import json
import os
import re
import sys
import time
from collections import Counter
from itertools import takewhile
from pathlib import Path

TEXTS = (
    *("status", "conclusion", "sentence", "level", "bound"),
    *("V", "rate", "of", "conditions"),
)
SHOWN = 160  # letters of a difference, of which some stand before it
BEFORE = 60
test = {"name": "", "verdicts": 0, "is_inside": False}


def texts_of(verdict) -> dict[str, str]:
    """Return what a verdict prints."""
    texts = {name: str(getattr(verdict, name)) for name in TEXTS}
    texts["steps"] = str(
        [(str(s.claim), s.holds, s.how, str(s.detail), s.shows) for s in verdict.steps]
    )
    for name in ("coq", "latex"):
        try:
            text = getattr(verdict, name)()
        except Exception as error:  # an open verdict has no file
            text = f"{type(error).__name__}: {error}"
        texts[name] = text[max(0, text.find("Section Loop.")) :]
    return texts


def recording(judge):
    """Return a function that writes each verdict that the outermost call returns."""

    @functools.wraps(judge)
    def recorded(*arguments, **options):
        if test["is_inside"]:
            return judge(*arguments, **options)
        test["is_inside"], start = True, time.process_time()
        try:
            verdict = judge(*arguments, **options)
            seconds = time.process_time() - start
            if hasattr(verdict, "steps"):
                row = [test["name"], test["verdicts"], seconds, texts_of(verdict)]
                test["verdicts"] += 1
                with Path(os.environ["RECORD_TO"]).open("a") as file:
                    file.write(json.dumps(row) + "\n")
        finally:
            test["is_inside"] = False
        return verdict

    return recorded


def pytest_configure(config):
    """Record `clpt.lyapunov` and `clpt.prove`."""
    import clpt_control as clpt
    from clpt_control.theory.laws import prove_law
    from clpt_control.theory.proofs import lyapunov_function

    for module, name in ((lyapunov_function, "lyapunov"), (prove_law, "prove")):
        recorded = recording(getattr(module, name))
        for owner in (module, clpt):
            setattr(owner, name, recorded)


def pytest_runtest_logstart(nodeid, location):
    """Begin to count the verdicts of a test."""
    test.update(name=nodeid, verdicts=0)


def read(path: str) -> dict[tuple, tuple[float, dict[str, str]]]:
    """Return seconds and texts of each verdict in a file, without figures of random points."""
    with Path(path).open() as file:
        rows = map(json.loads, file)
        return {
            (name, number): (
                seconds,
                {k: re.sub(r"largest difference \S+", "", v) for k, v in texts.items()},
            )
            for name, number, seconds, texts in rows
        }


def main(before: str, after: str) -> int:
    """Print how two files differ."""
    old, new = read(before), read(after)
    common, kinds = sorted(old.keys() & new.keys()), Counter()
    for key in common:
        pairs = {k: (text, new[key][1][k]) for k, text in old[key][1].items()}
        changed = [k for k, (a, b) in pairs.items() if a != b]
        kinds[" ".join(changed) or "equal"] += 1
        if changed:
            print(f"## {key[0].rpartition('::')[2]} {key[1]}: {' '.join(changed)}")
        for k in changed:
            same = takewhile(
                lambda pair: len({*pair}) == 1, zip(*pairs[k], strict=False)
            )
            start = max(0, sum(1 for _ in same) - BEFORE)
            for sign, text in zip("-+", pairs[k], strict=True):
                print(f"   {k} {sign} {text[start : start + SHOWN]!r}")
    for file in (old, new):
        seconds = [file[key][0] for key in common]
        print(f"{sum(seconds):.0f} s of CPU, slowest verdict {max(seconds):.1f} s")
    print(
        f"only in {before}: {len(old.keys() - new.keys())}, {after}: {len(new.keys() - old.keys())}"
    )
    for kind, count in kinds.most_common():
        print(f"{count} {kind}")
    return int({*kinds} != {"equal"})


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
