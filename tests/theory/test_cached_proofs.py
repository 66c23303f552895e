"""Verdicts that are cached: of the same equations by the same prover, and of nothing else."""

import os
import shutil
import signal
import time
from pathlib import Path

import pytest
from mutated_equations import altered, exchanged
from subprocesses import CLPT, GUARD, ran, started

import clpt_control as package

CACHE = "CLPT_CONTROL_CACHE"
WORDS = ("prove", "known-flow")
RATES = package.laws()["learned-flow"].rates.__globals__["driven_by"]


@pytest.fixture(autouse=True)
def folder(monkeypatch, tmp_path):
    monkeypatch.setenv(CACHE, str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def judged(printed):
    """Prove a law, and say when, and whether that was before."""

    def run(*words):
        found = printed(*(words or WORDS))
        return found["judged"]["time"], found["judged"]["before"], found["laws"]

    return run


def cached(folder):
    """The one file of the cache."""
    (file,) = folder.rglob("verdicts-*.json")
    return file


@pytest.mark.long
def test_the_second_time_says_the_same_and_that_it_was_judged_before(clpt, judged):
    first = clpt(*WORDS)
    assert first.status == 0
    at, before, laws = judged()
    assert before
    second = clpt(*WORDS)
    told, last = second.out.rstrip("\n").rsplit("\n", 1)
    assert told.rstrip("\n") == first.out.rstrip("\n")
    assert last == f"judged on {at} of the same equations; --again judges anew"
    assert judged() == (at, True, laws)
    assert judged(*WORDS, "--again")[1:] == (False, laws)


@pytest.mark.long
def test_each_statement_is_cached_by_itself(judged):
    assert not judged()[1]
    assert not judged("prove", "dead-zone")[1]
    assert judged()[1]
    assert judged("prove", "dead-zone")[1]


@pytest.mark.long
def test_what_fails_is_named_and_not_cached(clpt, judged, folder):
    """Of one sign of Eqs. (22), (23)."""
    code = altered(RATES.__globals__["adapt_gains"], 0)
    with exchanged(RATES.__globals__["adapt_gains"], code):
        outcome = clpt("prove", "learned-flow")
    assert outcome.status == 1
    assert "the proof fails: Law learned-flow at step" in outcome.err
    assert not judged("prove", "learned-flow")[1]
    assert judged("prove", "learned-flow")[1]


@pytest.mark.long
def test_the_engine_is_part_of_the_name(judged, folder, monkeypatch):
    assert not judged()[1]
    monkeypatch.setenv("CLPT_CONTROL_ENGINE", "python")
    assert not judged()[1]
    assert len([*folder.rglob("verdicts-*.json")]) == 2


@pytest.mark.long
def test_what_another_file_has_is_not_read(judged, folder):
    assert not judged()[1]
    file = cached(folder)
    file.rename(file.with_name("verdicts-of-other-equations.json"))
    assert not judged()[1]


@pytest.mark.long
@pytest.mark.parametrize(
    "damage",
    [lambda text: text[:-5], lambda text: "{}", lambda text: '[{"part": ["laws"]}]'],
    ids=["cut", "empty", "other rows"],
)
def test_what_is_damaged_is_not_read(judged, folder, damage):
    laws = judged()[-1]
    cached(folder).write_text(damage(cached(folder).read_text()))
    assert judged()[1:] == (False, laws)
    assert judged()[1:] == (True, laws)


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="of POSIX")
def test_what_others_could_have_written_is_not_read(judged, folder):
    judged()
    cached(folder).chmod(0o666)
    assert not judged()[1]


def test_without_a_folder_nothing_is_cached_and_the_work_goes_on(judged, monkeypatch):
    monkeypatch.setenv(CACHE, os.devnull + "/none/at/all")
    assert judged()[1:] == judged()[1:]
    assert not judged()[1]


def by_a_process(path):
    """Run the command with a package of this path, and return what it prints."""
    env = {**os.environ, "PYTHONPATH": str(path)}
    return ran(*CLPT, *WORDS, cwd=path, env=env).stdout


@pytest.mark.slow
def test_what_other_equations_gave_is_not_read(tmp_path):
    """A comment in a file of the package is another file."""
    copied = tmp_path / "clpt_control"
    shutil.copytree(Path(package.__file__).parent, copied)
    for before in (False, True):
        assert ("judged on" in by_a_process(tmp_path)) == before
    for file in ("paper/laws/paper.py", "data/paper.toml"):
        with (copied / file).open("a") as opened:
            opened.write("\n# a comment\n")
        assert "judged on" not in by_a_process(tmp_path)


@pytest.mark.processes
@pytest.mark.skipif(
    not Path("/proc").is_dir(), reason="asks /proc for the other process"
)
def test_a_process_that_ends_amid_its_work_ends_no_other():
    with started([*CLPT, "prove", "--again"]) as process:
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
        until = time.monotonic() + GUARD
        while process.poll() is None and time.monotonic() < until:
            for child in children.read_text().split():
                os.kill(int(child), signal.SIGKILL)
            time.sleep(0.5)
        out, err = process.communicate(timeout=GUARD)
    assert process.returncode == 0, err
    assert "Theorem 3.2: proved" in out
