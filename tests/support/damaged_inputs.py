"""Damaged inputs of every command, made from valid files, and what each is answered.

`python tests/support/damaged_inputs.py FIRST COUNT` prints a line of JSON for each case.
Case k is the same everywhere: a use (a command with its files), one of its files
or options, and a damage.  A case is a process of its own, forked where all is imported, with
limits of time and memory, so that a crash or a hang of a library is an answer too.
"""

import gc
import json
import os
import resource
import shutil
import signal
import sys
import tempfile
import traceback
from pathlib import Path

import numpy as np
from damaged_commands import OPTIONS, RUNS, USES, call, make_valid, put
from file_damages import NUMBERS, damaged, one_of

SECONDS, BYTES = 20, 10**9  # of an answer: time of the processor, and memory
WAIT = 150  # s, after which a command waits for ever


def case(k, valid, folder):
    """Make case k in a folder; return its words and what is damaged."""
    rng = np.random.default_rng([7, k])
    if rng.random() < 0.12:
        words, options = one_of(rng, OPTIONS)
        put(valid, folder, words)
        name, value = one_of(rng, options.split()), one_of(rng, NUMBERS)
        return f"{words} {name}={value}", f"{name}={value[:30]}"
    words, _, target = one_of(rng, USES).partition(" | ")
    first = put(valid, folder, words)
    path = min(folder.glob(target or first))
    return words, f"{path.relative_to(folder)}: {damaged(rng, path)}"


def held(folder):
    """Return what lies in a folder, without what says that somebody works there."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.name != ".clpt-lock":
            plain = path.is_file() and not path.is_symlink()
            found[str(path)] = hash(path.read_bytes()) if plain else None
    return found


def answer(folder, words):
    """Run a command in a process of its own; return status, outputs, time and memory."""
    out, err = folder.parent / "out.txt", folder.parent / "err.txt"
    child = os.fork()
    if child == 0:
        _run(folder, words, out, err)
    _, status, used = os.wait4(child, 0)
    return {
        "status": os.waitstatus_to_exitcode(status),
        "out": out.read_text("utf-8", "replace"),
        "err": err.read_text("utf-8", "replace"),
        "seconds": used.ru_utime + used.ru_stime,
        "bytes": 1024 * used.ru_maxrss,
    }


def _run(folder, words, out, err):
    status = 70
    try:
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(WAIT)
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
        resource.setrlimit(resource.RLIMIT_FSIZE, (BYTES, BYTES))
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        most = pages * resource.getpagesize() + 3 * BYTES // 2
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        os.chdir(folder)
        for place, number in ((out, 1), (err, 2)):
            os.dup2(os.open(place, os.O_CREAT | os.O_TRUNC | os.O_WRONLY), number)
        sys.stdout, sys.stderr = (
            os.fdopen(number, "w", closefd=False) for number in (1, 2)
        )
        sys.argv = ["clpt", *words.split(" ")]
        from clpt_control.app.cli import main
        from clpt_control.base import progress

        progress.PATIENCE = float("inf")  # no lines that only a slow machine shows
        try:
            main()
        except SystemExit as ended:
            status = ended.code or 0
        sys.stdout.flush()
        sys.stderr.flush()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


def fault(words, found, before, after):
    """Return what is wrong with an answer, or ''."""
    status, err = found["status"], found["err"]
    lines = err.splitlines()
    if status < 0:
        return f"ended by signal {-status}"
    if status not in (0, 1, 2):
        return f"status {status}"
    if "fault in clpt" in err or "Traceback" in err:
        return "a fault"
    if found["seconds"] > SECONDS or found["bytes"] > BYTES:
        return "too long or too large"
    if status == 0:
        if "--json" in words:
            try:
                json.loads(found["out"], parse_constant=lambda name: 1 / 0)
            except (ValueError, ZeroDivisionError):
                return "its output is no JSON"
        return ""
    said = [line for line in lines if line.startswith("clpt: ")]
    if len(said) != 1 or lines[-1] != said[0]:
        return "not one sentence"
    if status == 1 and not words.startswith(RUNS):
        return "status 1"
    if found["out"]:
        return "output beside an error"
    return "" if before == after else "something was written"


def draw_nothing():
    """Let figures be made and not drawn, which takes most of the time."""
    from matplotlib.figure import Figure

    from clpt_control.base import figures  # before pages take it

    figures.inline_svg = lambda *_: ""
    Figure.savefig = lambda self, file, **_: Path(file).write_bytes(b"drawn")


def main(first, count, drawn=1):
    """Print the answers of some cases."""
    if not drawn:
        draw_nothing()
    with tempfile.TemporaryDirectory() as base:
        valid = Path(base, "valid")
        valid.mkdir()
        import matplotlib.pyplot  # noqa: F401
        import typer
        from PIL import Image  # noqa: F401

        from clpt_control.app import cli

        made = typer.main.get_command(cli.application())
        cli.application = lambda: made
        make_valid(valid)
        kinds = {use.split()[0]: use.partition(" | ")[0] for use in USES}
        for words in kinds.values():  # now most is imported and compiled
            folder = Path(base, "warm")
            folder.mkdir()
            put(valid, folder, words)
            call(words, folder)
            shutil.rmtree(folder)
        gc.collect()
        gc.freeze()  # so that a fork copies less
        for k in range(first, first + count):
            folder = Path(base, "case", "work")
            folder.mkdir(parents=True)
            words, how = case(k, valid, folder)
            before = held(folder)
            found = answer(folder, words)
            wrong = fault(words, found, before, held(folder))
            found |= {"case": k, "words": words[:200], "how": how, "wrong": wrong}
            found |= {"out": found["out"][-300:], "err": found["err"][-500:]}
            print(json.dumps(found), flush=True)
            shutil.rmtree(folder.parent)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
