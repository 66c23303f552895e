"""Verdicts that are kept: of the same equations by the same prover, and of nothing else."""

import json
import os

import pytest

from clpt_control.blocks import vehicle
from clpt_control.files.user_cache import FOLDER
from clpt_control.theory.proving import kept_verdicts, two_processes
from clpt_control.theory.proving.judgement import Part, parts, plain, restored
from clpt_control.theory.proving.kept_verdicts import Kept, digest
from clpt_control.theory.proving.proof import Proof, Step
from clpt_control.theory.proving.two_processes import judge

SHORT = Part("limited_speed", "without hedging")


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.setenv(FOLDER, str(tmp_path / "cache"))
    return tmp_path / "cache"


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
    return Proof(part.name, "printed", ("so",), (step,), True, "it holds", not_proved=("more",))


def test_versions_processor_and_engine_are_part_of_the_name(monkeypatch):
    names = {digest()}
    for name in kept_verdicts.STOOD_ON:
        with monkeypatch.context() as patch:
            patch.setattr(
                kept_verdicts, "version", lambda one, name=name: "9" if one == name else "1"
            )
            names.add(digest())
    monkeypatch.setattr(kept_verdicts, "processor", lambda: ("another", ""))
    names.add(digest())
    monkeypatch.setenv(kept_verdicts.VARIABLE, "python")
    names.add(digest())
    monkeypatch.setattr(kept_verdicts.platform, "python_version", lambda: "4.0")
    names.add(digest())
    assert len(names) == len(kept_verdicts.STOOD_ON) + 4


@pytest.mark.usefixtures("folder")
def test_what_others_could_have_written_or_is_damaged_is_not_read():
    Kept().keep({SHORT: good(SHORT)})
    path = Kept().path
    assert Kept().verdicts == {SHORT: good(SHORT)}
    text = path.read_text()
    if hasattr(os, "getuid"):
        path.chmod(0o666)
        assert Kept().verdicts == {}
        path.chmod(0o644)
    for damaged in ("", text[:-5], "[1]", "{}", '[{"part": ["laws"]}]', "null"):
        path.write_text(damaged)
        assert Kept().verdicts == {}


def test_without_a_folder_nothing_is_kept_and_the_work_goes_on(monkeypatch):
    monkeypatch.setenv(FOLDER, os.devnull + "/none/at/all")
    kept = Kept()
    kept.keep({SHORT: good(SHORT)})
    assert kept.verdicts == {SHORT: good(SHORT)}
    assert Kept().verdicts == {}


def test_a_verdict_comes_back_as_it_was():
    for part in (SHORT, Part("misprints"), Part("laws", "known-flow")):
        found = part.judged()
        assert restored(json.loads(json.dumps(plain(found)))) == found


@pytest.mark.usefixtures("folder")
def test_two_processes_judge_the_same(monkeypatch):
    wanted = [SHORT, Part("misprints"), Part("laws", "known-flow")]
    monkeypatch.setattr(two_processes.os, "cpu_count", lambda: 1)
    alone = judge(wanted, digest())
    monkeypatch.setattr(two_processes.os, "cpu_count", lambda: 2)
    assert judge(wanted, digest()) == alone
    for refused in (["false"], ["echo", "another"]):  # one that judges otherwise is let go
        monkeypatch.setattr(two_processes, "COMMAND", refused)
        assert judge(wanted, digest()) == alone
