"""What a notebook shows: everything says itself, and escapes what others wrote."""

import re
from dataclasses import replace

import pytest
from html_parser import Reader

import clpt_control as clpt

EVIL = '<b onload="x">&'


def follower(name, takes, makes):
    return clpt.Block(
        name, output=lambda t, x, u, p: u[0], inputs={takes: 1}, outputs={makes: 1}
    )


@pytest.fixture(scope="module")
def things():
    scenario = clpt.paper_scenario().with_values({"run.duration": 60, "title": EVIL})
    dives = clpt.gliders.sample_dives()
    replay = clpt.replay.replay_dives([replace(dives[0], vehicle=EVIL)])
    block = follower("b<i>", "a<i>", "c&d")
    team = clpt.Team(members={"a": scenario, "b": scenario}, coupling=0.5)
    loop = clpt.closed_loop(scenario)
    return {
        "Scenario": scenario,
        "Team": team,
        "Block": block,
        "Diagram": clpt.connect([block], external=["a<i>"], name="d<i>"),
        "Drawing": clpt.draw(loop),
        "Replay": replay,
        "Verdict": clpt.prove(clpt.laws()["learned-flow"].of(1, gain=-0.5), points=200),
        "Excitation": clpt.gramian(team, 20.0),
        "Movie": clpt.animate(clpt.simulate(scenario), seconds=0.2, width=200),
    }


NAMES = "Scenario Team Diagram Drawing Replay Verdict Excitation Movie"


@pytest.mark.parametrize("name", NAMES.split())
def test_a_thing_shows_itself(things, name):
    """One short line as text; as HTML whole, small and harmless."""
    assert re.fullmatch(f"<{name}.{{0,190}}>", repr(things[name]))
    html = things[name]._repr_html_()
    tags = Reader(html).tags
    assert not {"b", "i", "script", "iframe", "link"} & {tag for tag, _ in tags}
    named = [pair for _, names in tags for pair in names.items()]
    far = [v or "" for k, v in named if k in ("src", "href") or "http" in (v or "")]
    assert all(one.startswith("data:image/gif;base64,") for one in far)
    assert name == "Movie" or len(html) < 40_000
    own = r"(fill|stroke|color)[:=]\W?(black|white|000|fff)"
    assert not re.search(rf"{own}|url\([^#]", html)  # takes the page's colour


def test_what_has_no_table_says_itself_in_one_line(things):
    for said, thing in {
        "NextDive: up 2016-02-01 ": things["Replay"].next_dive(),
        "Aim: aim at 42 48.00 S 8 24.00 E": things["Replay"].aims([(-42.8, 8.4)])[0],
    }.items():
        assert repr(thing).startswith(f"<{said}"), repr(thing)
        assert len(repr(thing)) < 300


def test_names_are_shown_as_they_are_and_keys_that_were_given(things):
    evil = "&lt;b onload=&quot;x&quot;&gt;&amp;"
    for name, *said in (
        *(("Replay", evil), ("Diagram", "d&lt;i&gt;")),
        ("Scenario", evil, "learning.gain</th><td>0.8<", "run.duration</th><td>60"),
    ):
        html = things[name]._repr_html_()
        assert [one for one in said if one not in html] == []
    assert str(things["Scenario"]) == repr(things["Scenario"])


def test_python_controls_markdown_is_not_the_same_again(things):
    """It would put the drawing into a notebook twice."""
    assert (
        things["Block"]._repr_markdown_() is things["Diagram"]._repr_markdown_() is None
    )


def test_a_large_diagram_is_said_in_words():
    row = [follower(f"b{k}", f"s{k}", f"s{k + 1}") for k in range(70)]
    diagram = clpt.connect(row, external=["s0"], name="chain")
    assert re.search("(?s)^(?!.*<svg).*more than 60 blocks", diagram._repr_html_())
    assert "70 blocks" in repr(diagram)


def test_what_cannot_be_wired_says_why():
    circle = clpt.connect(
        [follower("a", "s", "r"), follower("b", "r", "s")], name="circle"
    )
    assert re.search("(?s)^(?!.*<svg).*<p>", circle._repr_html_())
    assert repr(circle).startswith("<Diagram circle: 2 blocks")
