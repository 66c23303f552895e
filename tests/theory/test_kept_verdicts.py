"""Verdicts that are kept: of the same equations by the same prover, and of nothing else."""

import json
import multiprocessing
import os

import pytest

from clpt_control.blocks import vehicle
from clpt_control.files.user_cache import FOLDER
from clpt_control.theory.proving import judgement
from clpt_control.theory.proving.judgement import Kept, Part, digest, parts
from clpt_control.theory.proving.proof import Step, theorem
from clpt_control.theory.proving.two_processes import judge, second_process

SHORT = Part("limited_speed", "without hedging")


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.setenv(FOLDER, str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def no_equations(monkeypatch):
    """A digest of no equations, made at once; `test_altered_equations` asks them."""
    monkeypatch.setattr(judgement, "_judged_blocks", list)


def test_the_second_time_says_the_same_and_that_it_was_judged_before(folder, clpt, monkeypatch):
    first = clpt("prove", "--theorem", "3.3")
    assert first.status == 0
    monkeypatch.setattr(Part, "judged", None)  # nothing is judged
    second = clpt("prove", "--theorem", "3.3")
    told, last = second.out.rstrip("\n").rsplit("\n", 1)
    assert told == first.out.rstrip("\n")
    assert last.startswith("judged on 2")
    printed = json.loads(clpt("prove", "--theorem", "3.3", "--json").out)
    assert printed["judged"]["before"] is True
    assert printed["judged"]["time"] in last
    monkeypatch.undo()
    monkeypatch.setenv(FOLDER, str(folder))
    printed = json.loads(clpt("prove", "--theorem", "3.3", "--json", "--again").out)
    assert printed["judged"]["before"] is False


def wrong_kinematics(t, x, u, p, dx):
    """x' = F_R - v, not Eq. (1): u = flow_x[2], v_x[2], state x[2]."""
    for i in range(2):
        dx[i] = u[i] - u[2 + i]


@pytest.mark.usefixtures("folder")
def test_altered_equations_are_judged_anew(clpt, monkeypatch):
    kept = Kept()
    kept.keep({part: good(part) for part in parts()})
    assert set(Kept().verdicts) == set(parts())
    before = digest()
    monkeypatch.setattr(vehicle, "kinematics", wrong_kinematics)
    assert digest() != before
    assert Kept().verdicts == {}
    assert clpt("prove", "--theorem", "3.2").status == 1
    assert clpt("prove", "--theorem", "3.2").status == 1  # what failed is not kept


def good(part):
    if part.room == "misprints":
        return [{"equation": "(1)", "confirmed": True}]
    step = Step("it holds", True, "exact")
    return theorem("printed", ("so",), (step,), "it holds", not_proved=("more",))


@pytest.mark.usefixtures("no_equations")
def test_versions_processor_and_engine_are_part_of_the_name(monkeypatch):
    names = {digest()}
    for name in judgement.STOOD_ON:
        with monkeypatch.context() as patch:
            patch.setattr(judgement, "version", lambda one, name=name: "9" if one == name else "1")
            names.add(digest())
    monkeypatch.setattr(judgement, "processor", lambda: ("another", ""))
    names.add(digest())
    monkeypatch.setenv(judgement.VARIABLE, "python")
    names.add(digest())
    monkeypatch.setattr(judgement.platform, "python_version", lambda: "4.0")
    names.add(digest())
    assert len(names) == len(judgement.STOOD_ON) + 4


@pytest.mark.usefixtures("folder", "no_equations")
def test_what_others_could_have_written_or_is_damaged_is_not_read():
    Kept().keep({SHORT: good(SHORT)})
    path = Kept().path
    assert Kept().verdicts == {SHORT: good(SHORT)}
    text = path.read_text()
    if hasattr(os, "getuid"):
        path.chmod(0o666)
        assert Kept().verdicts == {}
        path.chmod(0o644)
    for damaged in (text[:-5], "{}", '[{"part": ["laws"]}]'):
        path.write_text(damaged)
        assert Kept().verdicts == {}


@pytest.mark.usefixtures("no_equations")
def test_without_a_folder_nothing_is_kept_and_the_work_goes_on(monkeypatch):
    monkeypatch.setenv(FOLDER, os.devnull + "/none/at/all")
    kept = Kept()
    kept.keep({SHORT: good(SHORT)})
    assert kept.verdicts == {SHORT: good(SHORT)}
    assert Kept().verdicts == {}


@pytest.mark.usefixtures("folder", "no_equations")
def test_a_verdict_comes_back_as_it_was():
    found = {part: part.judged() for part in (SHORT, Part("misprints"), Part("laws", "known-flow"))}
    Kept().keep(found)
    assert Kept().verdicts == found


@pytest.mark.processes
@pytest.mark.usefixtures("folder")
def test_two_processes_judge_the_same(monkeypatch):
    wanted, own = [SHORT, Part("misprints"), Part("laws", "known-flow")], digest()
    alone = judge(wanted, own)
    asked = []
    with second_process() as pool:
        monkeypatch.setattr(Part, "judged", lambda part: asked.append(part) or alone[part])
        assert judge(wanted, own, pool=pool) == alone
        assert asked != wanted  # the other was asked too
        asked.clear()
        assert judge(wanted, "of other equations", pool=pool) == alone
        assert sorted(asked) == sorted(wanted)  # one that judges otherwise says nothing
        for process in multiprocessing.active_children():
            process.kill()
        asked.clear()
        assert judge(wanted, own, pool=pool) == alone
        assert sorted(asked) == sorted(wanted)  # and one that ended neither
    assert multiprocessing.active_children() == []
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    with second_process() as pool:
        assert pool is None
