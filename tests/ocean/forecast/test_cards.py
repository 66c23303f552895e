"""The page of a replay as a pilot reads it: cards, an overdue vehicle, plain words, a legend."""

import json
import re
import time
from dataclasses import replace
from datetime import datetime

import pytest
from html_parser import Reader
from synthetic_vehicle import (
    along,
    chained,
    fixes_of,
    one_file_each,
    page_and_sentence,
    told,
    vehicle,
)

from clpt_control.gliders import sample_dives, write_dive_table
from clpt_control.replay import replay_dives

HOUR = 3600.0
DAY = 24 * HOUR


def seconds(date):
    """Seconds since 1970 of a date with its offset."""
    return datetime.fromisoformat(date).timestamp()


def recent(count, hours, **more):
    """Dives of which the last one ended some hours ago."""
    dives = fixes_of(count)
    late = time.time() - hours * HOUR - dives[-1].t_gpse
    return [
        replace(dive, t_gps2=dive.t_gps2 + late, t_gpse=dive.t_gpse + late, **more)
        for dive in dives
    ]


def shown(page):
    """The text of a page, with the texts that a script or a pointer shows."""
    read = Reader(re.sub("</?span[^>]*>", "", page))
    names = ("title", "aria-label", "data-words")
    hidden = [
        value for _, tag in read.tags for name, value in tag.items() if name in names
    ]
    return " ".join(" ".join([*read.texts, *hidden]).split())


def card_of(found, title):
    """The texts of a card: title, value, what is below."""
    page, _ = page_and_sentence(found)
    made = [Reader(one) for one in re.findall("<section.*?</section>", page, re.S)]
    (card,) = (one for one in made if one.texts[0].startswith(title))
    return " ".join("".join(card.texts[1:]).split()), card.tags[0][1]


@pytest.mark.usefixtures("undrawn")
def test_a_vehicle_that_is_overdue_is_so_on_its_own_page():
    late = told(recent(8, 9.0))
    text, section = card_of(late, "Overdue: next surfacing")
    assert re.search(r"expected \d\.\d h ago$", text)
    assert section["class"] == "card first alarm"
    page, sentence = page_and_sentence(late)
    assert re.search(
        r"Computed \d{4}-\d\d-\d\d \d\d:\d\d UTC, hours count from then\.", shown(page)
    )
    assert "overdue, expected" in sentence


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_script_knows_when_a_vehicle_becomes_overdue():
    found = told(recent(8, 1.0))
    ahead, last = found["next_dive"], found["each_dive"][-1]
    text, section = card_of(found, "Next surfacing")
    assert text.endswith(f"in {ahead['hours_from_now']:.1f} h")
    assert section["class"] == "card first"
    due = seconds(ahead["time"])
    assert section["data-time"] == ahead["time"]
    overdue, until = (seconds(section[f"data-{one}"]) for one in ("overdue", "until"))
    assert overdue == pytest.approx(due + ahead["time_half_width"], abs=1)
    assert until == pytest.approx(last["end_time"] + 30 * DAY, abs=1)


@pytest.mark.usefixtures("undrawn")
def test_an_old_record_is_never_overdue():
    found = told(fixes_of(8))
    text, section = card_of(found, "Next surfacing")
    assert text.endswith("h from the end of the last dive")
    assert [name for name in section if name.startswith("data-")] == []
    page, _ = page_and_sentence(found)
    assert "An old record: hours count from the end of its last dive" in shown(page)
    assert "data-since=" not in page


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_fleet_counts_on(command, tmp_path):
    ends = {}
    for name, hours in (("soon", 1.0), ("late", 9.0)):
        (tmp_path / name).mkdir()
        one_file_each(tmp_path / name, dives := recent(6, hours))
        ends[name] = dives[-1].t_gpse
    command("watch", tmp_path, "--fleet")
    page = (tmp_path / "replay" / "fleet.html").read_text("utf-8")
    marks = [
        tag for name, tag in Reader(page).tags if name == "tr" and "data-end" in tag
    ]
    found = [seconds(tag["data-end"]) for tag in marks]
    assert found == pytest.approx([ends["late"], ends["soon"]], abs=0.51)
    assert marks[1]["data-words"].startswith(
        "overdue after dive 6: should have surfaced at"
    )
    # the script finds its cells by these titles
    titles = [name for name in Reader(page).texts if name in ("age", "pilot")]
    assert titles == ["age", "pilot"]
    assert "2 vehicles, 1 needs a pilot" in shown(page)


@pytest.mark.usefixtures("undrawn")
def test_speed_and_distance_made_good_are_those_of_the_last_day():
    ways = [(along(90.0, 3000.0), along(90.0, 4000.0), 5 * HOUR)] * 12
    found = told(chained(ways, stay=HOUR))
    # five dives of six hours, with the time at the surface but for the last
    speed = 20_000 / (29 * HOUR)
    text, _ = card_of(found, "Speed made good, last 29 h")
    assert text.startswith(f"{speed:.2f} m/s, {speed * DAY / 1000:.1f} km per day")
    assert text.endswith("to 090; fix to fix, dives 7 to 11")
    few = found | {"each_dive": found["each_dive"][:1]}
    text, _ = card_of(few, "Speed made good, last 5 h")
    assert text.startswith(f"{4000 / (5 * HOUR):.2f} m/s")


@pytest.mark.usefixtures("undrawn")
def test_the_last_dive_has_age_and_depth():
    found = told(recent(4, 9.0, depth_max=987.4))
    text, section = card_of(found, "Last dive, 4")
    assert text.startswith("9.0 h ago")
    assert text.endswith("; 987 m deep")
    assert section["data-end"] == found["each_dive"][-1]["end"]
    text, _ = card_of(told(recent(4, 80.0)), "Last dive, 4")
    assert text.startswith("3 d ago")
    assert text.endswith("; depth not in its file")


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_distance_to_go_is_that_of_the_plan():
    found = told(sample_dives(), (-42.8, 8.4))
    text, _ = card_of(found, "Distance to go")
    assert text.startswith(f"{found['aim'][0]['distance'] / 1000:.1f} km to 349")
    assert re.search(r"there in [\d.]+ dives, \d+ h; 12.2 km per day nearer", text)
    without, _ = page_and_sentence(told(sample_dives()))
    assert "Distance to go" not in without


@pytest.mark.usefixtures("undrawn")
def test_a_waypoint_against_the_current_is_said_on_its_card():
    found = told(sample_dives(), (-42.8, 8.4))
    leg = found["aim"][0] | {"state": "cannot be made", "dives": None, "hours": None}
    text, _ = card_of(found | {"aim": [leg]}, "Aim")
    assert re.search(
        r"cannot be made against the current, 0\.\d\d m/s to \d{3}, at", text
    )
    assert "there in" not in card_of(found | {"aim": [leg]}, "Distance to go")[0]


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize(
    ("basis", "plan", "says"),
    [
        ("repeated", False, "wide: no plan in the files. Give --next or --aim"),
        (
            "planned",
            True,
            "wide: few dives went along the plan in the files. Give --next",
        ),
        ("given", False, "wide: longer than the way through the water; more dives"),
    ],
)
def test_a_wide_forecast_says_so_and_what_helps(basis, plan, says):
    found = told(sample_dives())
    ahead = found["next_dive"] | {"basis": basis, "plan_in_files": plan}
    assert ahead["ellipse_long"] > 3000
    found["next_dive"] = ahead
    assert says in page_and_sentence(found)[1]
    assert says in card_of(found, "Place of the next surfacing")[0]
    ahead["ellipse_long"] = 1000.0
    assert "wide: " not in page_and_sentence(found)[1]


def test_a_forecast_knows_of_a_plan_in_the_files():
    dives = sample_dives()
    assert not replay_dives(dives).surfacing().plan_in_files
    planned = [*dives[:-1], replace(dives[-1], next_course=77.0)]
    assert replay_dives(planned).surfacing().as_dict()["plan_in_files"]


PLAIN = re.compile(
    r"\b(headlines?|doubt\w*|habits?|miss|misses|way made good|carried|(come|came|comes) up|"
    r"ask\w* for)\b",
    re.IGNORECASE,
)


def wild_fix():
    """A page with notes on a wild fix."""
    ways = [
        (along(77.0 * k, 2500.0), along(77.0 * k, 2600.0), 9000.0) for k in range(9)
    ]
    dives = chained(ways, stay=300.0)
    dives[4] = replace(dives[4], lat_gpse=dives[4].lat_gpse + 0.05)
    return dives


@pytest.mark.long
@pytest.mark.parametrize(
    "dives", [sample_dives(), recent(8, 9.0), wild_fix(), fixes_of(1)]
)
def test_the_words_of_a_page_are_plain(dives, command, tmp_path, request):
    found = told(dives, (-42.8, 8.4), (-42.5, 8.4))
    if len(dives) < 14:  # figures of one page are drawn, with their words
        request.getfixturevalue("undrawn")
    text = shown(page_and_sentence(found)[0])
    request.getfixturevalue("undrawn")
    assert PLAIN.findall(text) == []
    assert "half axes" in text
    one_file_each(tmp_path, dives)
    command("watch", tmp_path, "--fleet")
    text = shown((tmp_path / "replay" / "fleet.html").read_text("utf-8"))
    assert PLAIN.findall(text) == []
    assert "half axes (m)" in text


@pytest.mark.usefixtures("undrawn")
def test_cards_are_not_repeated_in_prose():
    found = told(sample_dives(), (-42.8, 8.4), (-42.5, 8.4))
    page, sentence = page_and_sentence(found)
    page = shown(page)
    first, _ = found["aim"]
    assert sentence not in page
    assert page.count(found["next_dive"]["place"]) == 1
    assert f"{first['distance'] / 1000:.1f} km to 349:" not in page
    second = replay_dives(sample_dives()).aims([(-42.8, 8.4), (-42.5, 8.4)])[1]
    assert repr(second).removeprefix("<Aim: ").removesuffix(">") in page


KEYS = ("track", "drift", "miss", "ring", "next", "target", "made", "outside")


def keys_of(found):
    """The kinds in the legend of the map."""
    styles = [
        tag.get("class", "") for _, tag in Reader(page_and_sentence(found)[0]).tags
    ]
    return {style.removeprefix("key ") for style in styles if style.startswith("key ")}


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_legend_has_what_is_drawn_alone():
    one, many = told(fixes_of(1)), told(fixes_of(8))
    for row in many["each_dive"]:
        row["forecast"] = row["forecast"] and row["forecast"] | {"inside": True}
    assert keys_of(one) == {"track", "miss", "next"}
    assert keys_of(many) == {"track", "drift", "miss", "ring", "next"}
    aimed = many | {"aim": told(fixes_of(8), (40.5, 9.0))["aim"]}
    assert keys_of(aimed) - keys_of(many) == {"target", "made"}
    first, *rows = many["each_dive"]
    away = {"forecast": rows[0]["forecast"] | {"inside": False}}
    rows = [first, *(row | away for row in rows)]
    more = keys_of(many | {"each_dive": rows}) - keys_of(many)
    assert more == {"outside"}
    assert keys_of(aimed) | more == set(KEYS)


@pytest.mark.long
@pytest.mark.parametrize(("lat", "lon"), [(12.1, 85.8), (-42.0, -128.3)])
def test_the_degrees_of_a_telephone_have_room(lat, lon):
    """Letters of 11 units, each 0.62 of their height, and a tick, left of the chart."""
    dives = [replace(one, lat_gps2=lat) for one in fixes_of(4, lat, lon)]
    svg, _ = page_and_sentence(told(dives))
    left = float(re.search(r'data-chart="([\d.]+)', svg)[1])
    names = re.findall(r">(\d+°[\d.]+'[NS])<", svg)
    assert names
    assert left > 11 * 0.62 * max(map(len, names)) + 4


def test_a_vehicle_without_a_name_is_called_by_its_file(command, tmp_path):
    write_dive_table(fixes_of(3), tmp_path / "north 7.csv")
    found = json.loads(command(tmp_path / "north 7.csv", "--json").stdout)
    assert found["vehicle"] == "north 7"
    (tmp_path / "south").mkdir()
    one_file_each(tmp_path / "south", fixes_of(3))
    files = sorted((tmp_path / "south").iterdir())
    for words in ([tmp_path / "south"], files):
        assert json.loads(command(*words, "--json").stdout)["vehicle"] == "south"
    named = json.loads(command("--sample", "--json").stdout)
    assert named["vehicle"] == "SG542"


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_factor_on_speed_is_beside_that_of_a_week_ago():
    """A made vehicle that loses a fifth of its speed; 4 h dives, about six a day."""
    found = told(vehicle(3, 60, fault=30, lost=0.2))
    rows = found["each_dive"]
    text, _ = card_of(found, "Factor on speed")
    now, before = map(float, re.findall(r"(\d\.\d\d) ± ", text))
    assert now < before - 0.1
    (number,) = re.findall(r"a week ago .*, dive (\d+)", text)
    ended = {row["dive"]: row["end_time"] for row in rows}
    away = rows[-1]["end_time"] - ended[int(number)]
    assert 7 * DAY <= away < 8 * DAY
    text, _ = card_of(told(vehicle(3, 20)), "Factor on speed")
    assert "a week ago" not in text
