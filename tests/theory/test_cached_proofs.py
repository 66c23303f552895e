"""Verdicts that are kept: of the same equations by the same prover, and of nothing else."""

import multiprocessing
import os
import threading

import pytest
from subprocesses import GUARD

from clpt_control.base.files import CACHE
from clpt_control.engine.codegen import machine
from clpt_control.paper.blocks import vehicle
from clpt_control.theory.proofs import cached_verdicts as outcomes
from clpt_control.theory.proofs.all_proofs import Statement, statements
from clpt_control.theory.proofs.cached_verdicts import (
    CachedOutcomes,
    digest,
    prove_all,
    second_process,
)
from clpt_control.theory.proofs.steps import Step, theorem

SHORT = Statement("limited_speed", "without hedging")
of_its_own = pytest.mark.usefixtures("folder")


def kept():
    """What a process would find to be judged already."""
    return CachedOutcomes().outcomes


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.setenv(CACHE, str(tmp_path / "cache"))


@of_its_own
def test_the_second_time_says_the_same_and_that_it_was_judged_before(
    clpt, printed, monkeypatch
):
    words = ("prove", "--theorem", "3.3")
    first = clpt(*words)
    assert first.status == 0
    with monkeypatch.context() as patch:
        patch.setattr(Statement, "prove", None)  # nothing is judged
        second, judged = clpt(*words), printed(*words)["judged"]
    told, last = second.out.rstrip("\n").rsplit("\n", 1)
    assert told.rstrip("\n") == first.out.rstrip("\n")
    assert last.startswith("judged on 2")
    assert judged["time"] in last
    assert (judged["before"], printed(*words, "--again")["judged"]["before"]) == (
        True,
        False,
    )


@of_its_own
def test_what_other_files_gave_is_not_read(monkeypatch, tmp_path):
    law = tmp_path / "package" / "law.py"
    law.parent.mkdir()
    monkeypatch.setattr(outcomes, "PACKAGE", law.parent)
    law.write_text("rate = -e * phi")
    CachedOutcomes().store({part: good(part) for part in statements()})
    assert set(kept()) == set(statements())
    law.write_text("rate = e * phi")
    assert kept() == {}
    law.write_text("rate = -e * phi")
    assert set(kept()) == set(statements())
    for own in ("paper.toml", "solver.ll"):  # counterexamples are computed with both
        law.with_name(own).write_text("1")
        assert kept() == {}
        law.with_name(own).unlink()
    law.rename(law.with_name("other.py"))
    assert kept() == {}


@of_its_own
def test_what_fails_is_named_and_not_kept(clpt, monkeypatch):
    """x' = F_R - v, not Eq. (1)."""
    monkeypatch.setattr(vehicle, "kinematics", lambda t, x, u, p: u.flow_x - u.v_x)
    outcome = clpt("prove", "--theorem", "3.2")
    assert outcome.status == 1
    assert (
        "the proof fails: Theorem 3.2 at step '(9) x' + KD x is made of phi and zc alone"
        in outcome.err
    )
    assert Statement("theorems", "3.2") not in kept()


def good(part):
    if part.room == "misprints":
        return [{"equation": "(1)", "confirmed": True}]
    step = Step("it holds", True, "exact")
    return theorem("printed", ("so",), (step,), "it holds", not_proved=("more",))


def test_versions_processor_and_engine_are_part_of_the_name(monkeypatch):
    names = {digest()}
    for name in outcomes.REQUIRED:
        with monkeypatch.context() as patch:
            patch.setattr(
                outcomes, "version", lambda one, name=name: "9" if one == name else "1"
            )
            names.add(digest())
    monkeypatch.setattr(machine, "processor", lambda: ("another", ""))
    names.add(digest())
    monkeypatch.setenv(outcomes.ENGINE, "python")
    names.add(digest())
    monkeypatch.setattr(outcomes.platform, "python_version", lambda: "4.0")
    assert len(names | {digest()}) == len(outcomes.REQUIRED) + 4


@of_its_own
def test_what_others_could_have_written_or_is_damaged_is_not_read():
    CachedOutcomes().store({SHORT: good(SHORT)})
    path = CachedOutcomes().path
    assert kept() == {SHORT: good(SHORT)}
    text = path.read_text()
    if hasattr(os, "getuid"):
        path.chmod(0o666)
        assert kept() == {}
        path.chmod(0o644)
    for damaged in (text[:-5], "{}", '[{"part": ["laws"]}]'):
        path.write_text(damaged)
        assert kept() == {}


def test_without_a_folder_nothing_is_kept_and_the_work_goes_on(monkeypatch):
    monkeypatch.setenv(CACHE, os.devnull + "/none/at/all")
    own = CachedOutcomes()
    own.store({SHORT: good(SHORT)})
    assert (own.outcomes, kept()) == ({SHORT: good(SHORT)}, {})


@pytest.mark.processes
def test_a_process_that_ends_amid_its_work_ends_no_other(monkeypatch):
    wanted, asked, raised = (
        [Statement("laws", f"unknown-{k}") for k in range(9)],
        [],
        [],
    )
    monkeypatch.setattr(threading, "excepthook", raised.append)

    def prove(part):
        asked.append(part)
        if len(asked) == 4:  # what was given to the other is not all that is left
            for process in multiprocessing.active_children():
                process.kill()
        return part.name

    monkeypatch.setattr(Statement, "prove", prove)
    before = set(threading.enumerate())
    with second_process() as pool:
        assert prove_all(wanted, pool=pool) == {one: one.name for one in wanted}
    for thread in set(threading.enumerate()) - before:
        thread.join(GUARD)
    assert (sorted(asked), raised) == (sorted(wanted), [])


@pytest.mark.processes
@of_its_own
def test_two_processes_judge_the_same_and_what_is_kept_comes_back(monkeypatch):
    wanted = [SHORT, Statement("misprints"), Statement("laws", "known-flow")]
    alone, asked = prove_all(wanted), []
    CachedOutcomes().store(alone)
    assert kept() == alone

    def prove(part):  # the other process knows it by this name, and has the real one
        asked.append(part)
        return alone[part]

    with second_process() as pool:
        monkeypatch.setattr(Statement, "prove", prove)
        assert prove_all(wanted, pool=pool) == alone
        assert wanted[-1] not in asked  # the other was asked
    for process in (ended := multiprocessing.active_children()):
        process.join(GUARD)
    assert not any(process.is_alive() for process in ended)
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    with second_process() as pool:
        assert pool is None
