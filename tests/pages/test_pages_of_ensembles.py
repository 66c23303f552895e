"""The page of an ensemble: whole, under way, failed or damaged."""

import pytest
from test_sent_pages import SHORT, checked

import clpt_control as clpt
from clpt_control.ensemble.store import Store, open_store
from clpt_control.errors import DataError
from clpt_control.pages.page import page_html
from clpt_control.pages.writing import page_of

VARY = "learning.gain=0.2:2.0"


def test_an_ensemble_has_its_page(tmp_path):
    clpt.run_ensemble(SHORT, VARY, 6, out=tmp_path / "e.zarr", chunk=2)
    text = page_html(page_of(open_store(tmp_path / "e.zarr", mode="r").dataset()))
    checked(text)
    assert "6 finished" in text
    assert "=0.2:2.0" in text


@pytest.mark.parametrize("name", ["member/c/0", "flow_parameter_error/c/0/0"])
def test_a_damaged_ensemble_is_a_sentence(tmp_path, name):
    out, page = tmp_path / "e.zarr", tmp_path / "e.html"
    clpt.run_ensemble(SHORT, VARY, 2, out=out)
    (out / name).write_bytes((out / name).read_bytes()[:5])
    with pytest.raises(DataError, match=r"is damaged"):
        clpt.report(out, page)
    assert not page.exists()


def test_an_ensemble_that_failed_has_its_page(tmp_path):
    long = SHORT.with_values({"run.duration": 250})
    failed = clpt.run_ensemble(
        long, "vehicle.position=[[1e200,0],[1e201,0]]", 2, out=tmp_path / "e.zarr"
    )
    text = page_html(page_of(failed))
    checked(text)
    assert "2 of 2 runs did not come to their end" in text
    assert "2 step too small" in text
    assert "the first member that did not finish is 0" in text


@pytest.mark.parametrize("done", [0, 1])
def test_an_ensemble_under_way_says_how_far_it_is(tmp_path, monkeypatch, done):
    write, count = Store.write, []

    def stops(self, index, arrays):
        if len(count) == done:
            raise KeyboardInterrupt
        count.append(index)
        write(self, index, arrays)

    monkeypatch.setattr(Store, "write", stops)
    # a process that is killed removes nothing
    monkeypatch.setattr("clpt_control.ensemble.run.remove_empty", lambda store: None)
    with pytest.raises(KeyboardInterrupt):
        clpt.run_ensemble(SHORT, VARY, 6, out=tmp_path / "e.zarr", chunk=2, threads=1)
    said = clpt.report(tmp_path / "e.zarr", tmp_path / "e.html")["sentences"]
    text = (tmp_path / "e.html").read_text("utf-8")
    checked(text)
    for told in (text, said[1]):  # on the page, and where the command ran
        assert f"not complete: {2 * done} of 6 members are done" in told


def test_the_command_writes_page_and_figures(printed, tmp_path):
    clpt.run_ensemble(SHORT, VARY, 3, out=tmp_path / "e.zarr")
    words = tmp_path / "e.zarr", "-o", tmp_path / "r.html", "--figures", tmp_path / "f"
    found = printed("report", *words)
    assert found["bytes"] == (tmp_path / "r.html").stat().st_size
    names = ["ensemble.pdf", "ensemble.svg"]
    assert sorted(path.name for path in (tmp_path / "f").iterdir()) == names
    assert sorted(found["figures"]) == [str(tmp_path / "f" / name) for name in names]
