"""What an ensemble refuses, its figure, and its command."""

import json
import os
import shutil

import pytest
from ensemble_stores import VARY, files
from pictures import inked

import clpt_control
from clpt_control.ensemble.run import run_ensemble
from clpt_control.ensemble.spread import ensemble_plot
from clpt_control.ensemble.store import Store, open_store
from clpt_control.errors import ClptError, DataError, ScenarioError

MISTAKES = [
    ({"vary": "learning.gain"}, "must be KEY=LOW:HIGH"),
    ({"vary": "learning.gain=2:1"}, "the first is the smaller"),
    ({"vary": "learning.gain=0:inf"}, "two finite numbers"),
    ({"vary": "learning.gain~gamma:1"}, "KEY~normal:DEVIATION"),
    ({"vary": "learning.gain=[0.5, 1"}, "KEY=[VALUE, ...]"),
    ({"vary": "learning.gain=[true]"}, "each value must be a number"),
    ({"vary": 'learning.gain=["a"]'}, "each value must be a number"),
    ({"vary": "learning.position=[[1, 2, 3]]"}, "must be an array of shape (2,)"),
    ({"vary": []}, "name at least one key"),
    ({"vary": ["learning.gain=1:2", "learning.gain=1:2"]}, "named 2 times"),
    ({"vary": "learning.gian=1:2"}, "did you mean learning.gain? May vary: basis.centers"),
    ({"vary": "nothing=1:2"}, "nothing cannot vary; may vary: basis.centers"),
    ({"vary": "adaptation.gain=1:2"}, "the scenario's key is learning.gain"),
    ({"vary": "reference.count=5:10"}, "cannot vary; "),
    ({"vary": "run.duration=1:2"}, "cannot vary; "),
    ({"vary": "learning.theta_estimate=1:2"}, "cannot vary; "),
    ({"vary": "learning.gain=-1:2"}, "must be greater than 0; or should be positive"),
    ({"vary": VARY[0], "members": 0}, "members = 0: must be a whole number, at least 1"),
    ({"vary": VARY[0], "members": 2.5}, "members = 2.5: must be a whole number"),
    ({"vary": VARY[0], "members": 10**20}, "would draw 1e+20 numbers; at most 2e+08"),
    ({"vary": VARY[0], "members": 10**20, "design": "grid"}, "would draw 1e+20 numbers"),
    ({"vary": "learning.gain=" + "[" * 5000, "members": 2}, "KEY=[VALUE, ...]"),
    ({"vary": f"learning.gain=[{'1' * 5000}]", "members": 2}, "KEY=[VALUE, ...]"),
    ({"vary": f"learning.gain=[{'1' * 400}]", "members": 2}, "each value must be a number"),
    ({"vary": VARY[0], "seed": -1}, "seed = -1: must be a whole number"),
    ({"vary": VARY[0], "design": "sobol"}, "must be one of lhs, grid, random"),
    ({"vary": VARY[0], "chunk": 0}, "chunk = 0: must be a whole number"),
    ({"vary": VARY[0], "threads": 0}, "threads = 0: must be a whole number"),
    ({"vary": VARY[0], "times": [11.0]}, "11.0 must lie between 0 and run.duration = 10"),
    ({"vary": "learning.gain=[1, 2]", "design": "grid", "members": 5}, "must have 2 members"),
    (
        {"vary": ["learning.gain=[1, 2]", "learning.position=0:1"], "design": "grid"},
        "must have 2 n^2 members, such as ",
    ),
]


@pytest.fixture(scope="module")
def stored(quick, tmp_path_factory):
    """An ensemble in a folder that is left as it is."""
    out = tmp_path_factory.mktemp("stored") / "e.zarr"
    run_ensemble(quick, VARY, 20, out=out)
    return out


@pytest.fixture(scope="module")
def halves(quick, tmp_path_factory):
    """The same in two chunks."""
    out = tmp_path_factory.mktemp("halves") / "e.zarr"
    run_ensemble(quick, VARY, 20, out=out, chunk=10)
    return out


@pytest.mark.parametrize(("given", "sentence"), MISTAKES)
def test_mistakes_are_one_sentence(quick, tmp_path, given, sentence):
    given = {"members": 10, **given}
    with pytest.raises(ClptError) as error:
        run_ensemble(quick, out=tmp_path / "e.zarr", **given)
    text = str(error.value)
    assert "\n" not in text
    if "greater" not in sentence:
        assert sentence in text
    else:
        assert "member " in text
        assert "narrow learning.gain=-1:2" in text
    assert list(tmp_path.iterdir()) == []


def test_a_member_that_is_not_allowed_is_named(quick):
    values = [0.5, 1.0, -0.1, 2.0, -3.0]
    with pytest.raises(ScenarioError, match=r"^member 4: learning.gain = -3.0: must be"):
        run_ensemble(quick, f"learning.gain={values}", 5, "grid")


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"seed": 1}, "holds an ensemble of another seed"),
        ({"members": 21}, "holds an ensemble of another members"),
        ({"design": "random"}, "holds an ensemble of another design"),
        ({"vary": "learning.gain=1:2"}, "holds an ensemble of another vary"),
        ({"trajectories": True}, "holds an ensemble of another trajectories"),
        ({"chunk": 7}, "holds an ensemble of another chunk"),
        ({"system": 1}, "holds an ensemble of another scenario"),
    ],
)
def test_another_ensemble_is_refused(quick, stored, given, sentence):
    before = files(stored)
    arguments = {"system": quick, "vary": VARY, "members": 20, **given}
    if given == {"system": 1}:
        arguments["system"] = quick.with_values({"learning.gain": 0.9})
    with pytest.raises(DataError) as error:
        run_ensemble(out=stored, **arguments)
    assert sentence in str(error.value)
    assert files(stored) == before


def test_folders_that_are_no_ensemble(quick, tmp_path):
    out = tmp_path / "e.zarr"
    cases = []
    file = tmp_path / "file"
    file.write_text("text")
    cases.append((file, "is a file"))
    filled = tmp_path / "filled"
    filled.mkdir()
    (filled / "notes.txt").write_text("mine")
    cases.append((filled, "is a folder without an ensemble"))
    cases.append((tmp_path / "no" / "e.zarr", "does not exist"))
    run_ensemble(quick, VARY, 4, out=out)
    for name, text in (("text", "{"), ("empty", "{}")):
        damaged = tmp_path / f"{name}.zarr"
        shutil.copytree(out, damaged)
        (damaged / "zarr.json").write_text(text)
        cases.append((damaged, "is no ensemble or is damaged"))
    lost = tmp_path / "lost.zarr"
    shutil.copytree(out, lost)
    shutil.rmtree(lost / "status")
    cases.append((lost, "is damaged, .* its status is not as it was made"))
    for kind, put in (("pipe", os.mkfifo), ("link", lambda at: at.symlink_to(out))):
        odd = tmp_path / f"{kind}.zarr"
        shutil.copytree(out, odd)
        (odd / "status" / "c" / "0").unlink()
        put(odd / "status" / "c" / "0")
        cases.append((odd, "c/0: is no regular file"))
    for path, sentence in cases:
        with pytest.raises(DataError, match=sentence):
            run_ensemble(quick, VARY, 4, out=path)
    assert (filled / "notes.txt").read_text() == "mine"
    empty = tmp_path / "new"
    empty.mkdir()
    assert run_ensemble(quick, VARY, 4, out=empty).sizes["member"] == 4


def test_numbers_of_other_versions_are_not_mixed(quick, halves, tmp_path):
    out = shutil.copytree(halves, tmp_path / "e.zarr")
    store = open_store(out)
    store.group.attrs["code"] = "another"
    store.group.attrs["digests"] = json.dumps(store.digests())
    run_ensemble(quick, VARY, 20, out=out, chunk=10)
    store.group["done"][1] = 0
    with pytest.raises(DataError, match="begun by other versions"):
        run_ensemble(quick, VARY, 20, out=out, chunk=10)


@pytest.fixture
def lacking(halves, tmp_path):
    """An ensemble of two chunks, of which the second is to be run again."""
    shutil.copytree(halves, tmp_path / "e.zarr")
    store = open_store(tmp_path / "e.zarr")
    store.group["done"][1] = 0
    return store.group


def test_a_foreign_array_is_refused_before_a_chunk_is_written(quick, lacking, tmp_path):
    out = tmp_path / "e.zarr"
    lacking.create_array("mine", shape=(3,), dtype="f8", dimension_names=["member"])
    before = files(out)
    for go_on in (
        lambda: run_ensemble(quick, VARY, 20, out=out, chunk=10),
        lambda: clpt_control.report(out, tmp_path / "e.html"),
    ):
        with pytest.raises(DataError, match=r"e.zarr: holds mine, which is no part of it"):
            go_on()
    assert files(out) == before
    assert not (tmp_path / "e.html").exists()


def test_a_folder_in_the_place_of_a_chunk_is_named(quick, lacking, tmp_path):
    place = tmp_path / "e.zarr" / "clpe_rms_whole" / "c" / "1"
    place.unlink()
    place.mkdir()
    (place / "mine").touch()
    with pytest.raises(DataError, match=r"clpe_rms_whole.c.1: cannot be written"):
        run_ensemble(quick, VARY, 20, out=tmp_path / "e.zarr", chunk=10)


@pytest.mark.parametrize("name", ["members", "chunk", "keys", "scenario"])
def test_arguments_that_do_not_fit_are_told(lacking, tmp_path, name):
    out, text = tmp_path / "e.zarr", lacking.attrs["ensemble"]
    for value in (None, 10**12, [], "x", -1, 0):
        lacking.attrs["ensemble"] = json.dumps({**json.loads(text), name: value})
        with pytest.raises(DataError, match=r"is damaged"):
            clpt_control.report(out, tmp_path / "e.html")


def test_numbers_that_are_not_those_of_a_chunk_are_told(lacking, tmp_path):
    lacking["clpe_rms_whole"][3] = 0.5
    with pytest.raises(DataError, match="chunk 0 is not as written"):
        clpt_control.report(tmp_path / "e.zarr", tmp_path / "e.html")


@pytest.mark.parametrize("duration", [10, 125])
def test_the_figure(scenario, duration):
    data = run_ensemble(scenario.with_values({"run.duration": duration}), VARY, 8)
    axes = ensemble_plot(data)
    assert [len(ax.get_title(loc="left")) > 0 for ax in axes] == [True, True]
    assert axes[1].get_yscale() == "log"


def test_the_command(clpt, printed, refused, quick, tmp_path):
    file, out, figure = tmp_path / "s.toml", tmp_path / "e.zarr", tmp_path / "e.png"
    clpt_control.save_scenario(quick, file)
    many = ("--members", 12, "--vary", VARY[0], "--vary", VARY[1], "--seed", 4, "--out", out)
    found = printed("ensemble", file, *many, "--figure", figure)
    assert found["ended"] == {"finished": 12}
    assert inked(figure) > 0.01
    table = clpt("ensemble", file, *many)
    assert table.status == 0
    assert f"{quick.title or file}: 12 finished" in table.out
    wrong = ("--members", 3, "--vary", "x=1:2", "--out", tmp_path / "f.zarr")
    assert "x cannot vary; may vary" in refused("ensemble", file, *wrong)
    assert not (tmp_path / "f.zarr").exists()
    named = refused("ensemble", file, *many, "--figure", tmp_path / "e.gif")
    assert ".png, .pdf or .svg" in named


def test_what_ends_an_ensemble_says_what_is_kept(clpt, quick, tmp_path, monkeypatch):
    clpt_control.save_scenario(quick, tmp_path / "s.toml")
    out = tmp_path / "e.zarr"
    words = ("ensemble", tmp_path / "s.toml", "--members", "4", "--vary", "learning.gain=1:2")
    words = (*words, "--out", out, "--chunk", "2", "--threads", "1")
    whole = Store.write

    def full(store, index, arrays):
        if index >= fails:
            raise DataError("e.zarr: cannot be written: No space left on device")
        whole(store, index, arrays)

    monkeypatch.setattr(Store, "write", full)
    said = "clpt: e.zarr: cannot be written: No space left on device"
    fails = 0
    assert clpt(*words) == (2, "", f"{said}\n")
    in_batches = [{"4": "24", "2": "24"}.get(str(word), word) for word in words]
    ended = clpt(*in_batches)  # members are done, and none is stored
    assert (ended.status, ended.err.splitlines()[-1]) == (2, said)
    assert not out.exists()
    fails = 1
    kept = f"{out} holds 2 of 4 members; the same command goes on from there"
    assert clpt(*words) == (2, "", f"{said}; {kept}\n")
    fails = 2
    outcome = clpt(*words)
    there = "clpt: running s.toml: 2 of 4 members were there already\n"
    assert (outcome.status, outcome.err) == (0, there)
