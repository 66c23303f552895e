"""The page of a replay, GeoJSON, KML and what goes onto the vehicle, as their readers read."""

import json
import math
import re
from base64 import b64encode
from dataclasses import replace
from hashlib import sha256
from xml.etree import ElementTree

import numpy as np
import pytest
from geodesics import WGS84, place_from
from html_parser import Reader, fetching_nothing
from matplotlib.path import Path
from refusals import refuses
from synthetic_vehicle import fixes_of, map_of, page_and_sentence, told

from clpt_control.gliders import sample_dives, write_dive_table

EVIL = "</title></script><script>alert(1)</script><img src=x onerror='alert(2)'>\x00\udc80\"&amp;"


@pytest.fixture(scope="module")
def evil():
    """A page of texts that a file may hold."""
    found = told(fixes_of(3))
    found["skipped"] = [{"dive": None, "why": EVIL}]
    found["vehicle"] = f"SG {EVIL}"
    found["each_dive"][0]["dive"] = found["next_dive"]["place"] = EVIL
    found["notes"] = [{"dive": 1, "note": EVIL}]
    return page_and_sentence(found)[0]


@pytest.fixture
def replayed(command, tmp_path):
    """Replay dives by the command: what it prints as JSON, next.geojson and track.kml."""

    def replay(dives, *words):
        write_dive_table(dives, tmp_path / "dives.csv")
        out = tmp_path / "out"
        said = command(tmp_path / "dives.csv", "--json", "--out", out, *words)
        texts = ((out / name).read_text() for name in ("next.geojson", "track.kml"))
        return json.loads(said.stdout), *texts

    return replay


@pytest.mark.long
def test_nothing_of_a_file_is_markup(evil):
    page = Reader(evil)
    assert [tag for tag, _ in page.tags].count("script") == 1
    shown = EVIL.replace("\x00", "\ufffd").replace("\udc80", "\ufffd")
    assert any(shown in text for text in page.texts)


def test_nothing_is_fetched(evil):
    page = fetching_nothing(evil)
    assert "//" not in re.sub(r"^// .*$", "", "".join(page.scripts), flags=re.M)
    policy = next(
        names["content"]
        for tag, names in page.tags
        if tag == "meta" and len(names) == 2
    )
    style, script = (
        f"'sha256-{b64encode(sha256(''.join(parts).encode()).digest()).decode()}'"
        for parts in (page.styles, page.scripts)
    )
    assert policy == f"default-src 'none'; style-src {style}; script-src {script}"
    charts_have_dates(evil)


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_a_page_that_is_written_again_is_loaded_again(command, follow, tmp_path):
    write_dive_table(fixes_of(3), tmp_path / "dives.csv")
    for again, run in ((False, command), (True, follow)):
        run(tmp_path, "--out", tmp_path / "out")
        tags = Reader((tmp_path / "out" / "replay.html").read_text("utf-8")).tags
        asked = [names for _, names in tags if names.get("http-equiv") == "refresh"]
        assert asked == [{"http-equiv": "refresh", "content": "60"}] * again
        assert [names["data-again"] for _, names in tags if "data-again" in names] == [
            "60"
        ] * again


def charts_have_dates(text):
    charts = re.findall(r"<figure>.*?</figure>", text, flags=re.S)
    assert len(charts) == 2
    for chart in charts:
        assert ">surfaced (UTC)<" in chart
        assert len(re.findall(r">\d\d:\d\d<|>[A-Z][a-z]{2}-\d\d<", chart)) in range(
            2, 12
        )


@pytest.mark.long
def test_sixty_dives_are_small_and_one_is_enough(replayed):
    text, _ = page_and_sentence(told(fixes_of(60)))
    assert len(text.encode()) < 2_000_000
    tags = Reader(text).tags
    rows = [names["id"] for tag, names in tags if tag == "tr" and "id" in names]
    # a fix leads to its row
    to_section = {f"#{names['id']}" for tag, names in tags if tag == "h2" and names}
    links = [names["href"] for tag, names in tags if tag == "a"]
    links = [one for one in links if one not in to_section]
    assert sorted(links) == sorted(f"#{one}" for one in rows) == sorted(set(links))
    assert len(links) == 60
    charts_have_dates(page_and_sentence(told(fixes_of(1)))[0])
    page_and_sentence(told(fixes_of(28)))  # 4.7 days, without a warning on dates
    _, places, track = replayed(fixes_of(1))
    assert len(json.loads(places)["features"]) == 4
    ElementTree.fromstring(track)


@pytest.mark.parametrize(
    ("lat", "lon"), [(-43.0, 8.0), (67.0, -179.9), (0.0, 180.0), (89.0, 0.0)]
)
def test_a_chart_is_true_to_scale_and_angle(lat, lon):
    ax = map_of(told(fixes_of(4, lat, lon)))
    low, high = ax.get_ylim()
    middle = (low + high) / 2
    # in a degree of longitude
    metres = WGS84.inv(lon, low, lon, high)[2] / (ax.get_aspect() * (high - low))
    for bearing in (0, 45, 90, 200):
        x, y, _ = WGS84.fwd(lon, middle, bearing, 100.0)
        east = (x - lon + 180) % 360 - 180
        away = complex(east, ax.get_aspect() * (y - middle)) * metres
        assert abs(away) == pytest.approx(100, rel=2e-3)
        turned = math.degrees(math.atan2(away.real, away.imag))
        assert turned % 360 == pytest.approx(bearing, abs=0.5)


@pytest.mark.parametrize("name", ["latitude", "from_latitude"])
def test_a_place_beyond_the_poles_is_not_drawn(name):
    found = told(fixes_of(4))
    found["next_dive"][name] = 1e9
    refuses("a latitude is beyond the poles", page_and_sentence, found)


@pytest.mark.long
def test_a_far_waypoint_leaves_the_chart_as_it_is():
    *_, last = dives = fixes_of(6)
    found, edges = told(dives), {}
    for bearing, away in ((0.0, 5e5), (90.0, 5e5), (225.0, 5e5), (300.0, 100.0)):
        place = WGS84.fwd(last.lon_gpse, last.lat_gpse, bearing, away)
        aimed = found | {"aim": told(dives, (place[1], place[0]))["aim"]}
        ax = map_of(aimed)
        edges[bearing] = *ax.get_xlim(), *ax.get_ylim()
    assert len({edge for bearing, edge in edges.items() if bearing != 300.0}) == 1
    page = Reader(page_and_sentence(aimed)[0])
    assert page.texts[page.texts.index("Aim") + 1].startswith("heading ")


def test_grid_names_its_lines():
    ax = map_of(told(fixes_of(4)))
    names = [*map(ax.xaxis.get_major_formatter(), (179 + 55 / 60, 180.0, 180 + 5 / 60))]
    assert names == ["179°55'E", "180°00'E", "179°55'W"]
    assert ax.yaxis.get_major_formatter()(59.9999 / 60) == "1°00'N"


KML = {"k": "http://www.opengis.net/kml/2.2"}


def shapes_of(places):
    """Coordinates of a GeoJSON text by name."""
    return {
        one["properties"]["name"]: one["geometry"]["coordinates"]
        for one in json.loads(places)["features"]
    }


def ring_of(found, shapes):
    """Return the outline of the forecast's ellipse."""
    return shapes[f"{100 * found['level']:g} % ellipse"][0]


@pytest.mark.parametrize("lat", [-43.0, 0.0, 67.0, 80.0])
@pytest.mark.usefixtures("undrawn")
def test_a_ring_is_the_ellipse_on_the_earth(replayed, lat):
    found, places, _ = replayed(fixes_of(5, lat))
    forecast, ring = found["next_dive"], ring_of(found, shapes_of(places))
    centre = forecast["longitude"], forecast["latitude"]
    assert ring[0] == ring[-1]
    far = [WGS84.inv(*centre, *point)[2] for point in ring]
    assert max(far) == pytest.approx(forecast["ellipse_long"], rel=2e-3)
    assert min(far) == pytest.approx(forecast["ellipse_short"], rel=5e-3)
    bearing = WGS84.inv(*centre, *ring[0])[0]
    # meridians turn
    assert abs((bearing - forecast["ellipse_bearing"] + 90) % 180 - 90) < 1.0


@pytest.mark.parametrize("lon", [8.0, 179.99, -180.0, 180.0, 180.01, -180.01])
@pytest.mark.usefixtures("undrawn")
def test_geojson_is_read_back_and_longitudes_count_on_at_180_degrees(replayed, lon):
    found, places, track = replayed(fixes_of(5, 51.0, lon))
    ahead, last, shapes = found["next_dive"], found["each_dive"][-1], shapes_of(places)
    ring, goal = np.array(ring_of(found, shapes)), shapes["next surfacing"]
    assert ring[0].tolist() == ring[-1].tolist()
    # counter-clockwise
    assert np.linalg.det(np.stack([ring[:-1], ring[1:]], axis=1)).sum() > 0
    assert any(
        Path(ring).contains_point((goal[0] + turn, goal[1])) for turn in (-360, 0, 360)
    )
    way = shapes["way to the next surfacing"][0]
    for (x, y), wanted, name in ((goal, ahead, ""), (way, last, "end_")):
        off = (x - wanted[f"{name}longitude"] + 180) % 360 - 180
        assert (off, y) == pytest.approx((0, wanted[f"{name}latitude"]), abs=1e-6)
    root = ElementTree.fromstring(track)
    lines = [one.text.split() for one in root.iterfind(".//k:coordinates", KML)]
    lines = [[float(pair.split(",")[0]) for pair in line] for line in lines]
    for span in (ring[:, 0], *lines):
        assert np.ptp(span) < 90
        assert abs(span[0]) <= 180


@pytest.mark.usefixtures("undrawn")
def test_kml_is_read_back(replayed):
    named = [replace(dive, vehicle="SG<1> & co") for dive in fixes_of(5, -43.0)]
    found, _, track = replayed(named)
    root = ElementTree.fromstring(track)
    assert root.find("k:Document/k:name", KML).text == "SG<1> & co"
    fixes = [
        [
            one.find(f"k:{name}", KML).text
            for name in ("TimeStamp/k:when", "Point/k:coordinates")
        ]
        for one in root.iterfind("k:Document/k:Placemark", KML)
        if one.find("k:name", KML).text.startswith("dive ")
    ]
    for (when, text), row in zip(fixes, found["each_dive"], strict=True):
        assert when == row["end"]
        there = row["end_longitude"], row["end_latitude"]
        assert [*map(float, text.split(","))] == pytest.approx(there, abs=1e-6)
    names = {style.get("id") for style in root.iterfind(".//k:Style", KML)}
    assert {one.text[1:] for one in root.iterfind(".//k:styleUrl", KML)} <= names


@pytest.mark.usefixtures("undrawn")
def test_any_character_of_a_name_is_in_a_page_that_xml_can_hold():
    name = "".join(map(chr, range(0x300))) + "\ud800\udcff\ufffe\U0001f600"
    page = page_and_sentence(told(fixes_of(1)) | {"vehicle": name})[0]
    title = re.search(r"<h1>.*?</h1>", page, re.DOTALL)[0]
    shown = ElementTree.fromstring(title).text
    assert {*map(chr, range(0x20, 0x7F)), "\u00e9", "\U0001f600"} <= {*shown}
    assert not {"\x00", "\x1f", "\ud800", "\ufffe"} & {*shown}


TARGETS = [(-42.8, 8.4), (-42.0, -351.75), (-42.0, -0.5)]
CORRECTS = "the glider corrects for the current itself (u_use_current_correction)"
PLACES = [TARGETS[0], (-42.0, 8.25), TARGETS[2]]


def report_of(kind, note="", targets=TARGETS):
    *dives, last = sample_dives()
    return told([*dives, replace(last, kind=kind, notes=(note,))], *targets)


def degrees_of(word):
    """A number ddmm.mmmm as a vehicle reads it: the last two whole digits are minutes."""
    sign, whole, minutes = re.fullmatch(r"(-?)(\d+?)(\d\d\.\d{4})", f"{word}").groups()
    assert float(minutes) < 60
    return (-1 if sign else 1) * (int(whole) + float(minutes) / 60)


def targets_of(text):
    """Lines of a targets file by the rules of basestation3's validate.py: name, then key=value."""
    lines = [line.split() for line in filter(None, text.splitlines()) if line[0] != "/"]
    read = {name: dict(pair.split("=") for pair in pairs) for name, *pairs in lines}
    for one in read.values():
        assert set(one) == {"lat", "lon", "radius", "goto"}
        assert one["goto"] in read
    return read


def waypoints_of(text):
    """A goto_list as mafiles have it: arguments, then a line for each waypoint, lon lat."""
    lines = [line.partition("#")[0].strip() for line in text.splitlines()]
    assert lines[0] == "behavior_name=goto_list"
    first, last = lines.index("<start:b_arg>"), lines.index("<end:b_arg>")
    asked = (
        re.fullmatch(r"b_arg: (\w+)\(\w+\) (-?\d+)", one)
        for one in lines[first + 1 : last]
    )
    arguments = dict(one.groups() for one in asked)
    assert (lines[last + 1], lines[-1]) == ("<start:waypoints>", "<end:waypoints>")
    places = [line.split() for line in lines[last + 2 : -1]]
    assert int(arguments["num_waypoints"]) == len(places) <= 8
    assert arguments["list_stop_when"] == "7"
    assert int(arguments["list_when_wpt_dist"]) >= 10
    return [(degrees_of(lat), degrees_of(lon)) for lon, lat in places]


def test_a_seaglider_gets_targets_and_a_true_heading():
    found = report_of("Seaglider")
    assert found["paste"]["file"] == "targets"
    read = targets_of(found["paste"]["text"])
    places = [(degrees_of(one["lat"]), degrees_of(one["lon"])) for one in read.values()]
    assert places == [pytest.approx(place) for place in PLACES]
    assert [one["goto"] for one in read.values()] == ["AIM2", "AIM3", "AIM3"]
    said = re.search(r"\$HEADING,(\d+\.\d)", found["paste"]["text"])
    assert float(said[1]) == pytest.approx(found["aim"][0]["heading"], abs=0.051)
    # or it would correct for the current again
    assert "$NAV_MODE,0" in found["paste"]["text"]


def test_a_slocum_that_does_not_correct_gets_a_waypoint_along_the_heading():
    found = report_of("Slocum")
    assert found["paste"]["file"] == "goto_l10.ma"
    ((lat, lon),) = waypoints_of(found["paste"]["text"])
    leg = found["aim"][0]
    start = leg["from_longitude"], leg["from_latitude"]
    heading, _, far = WGS84.inv(*start, lon, lat)
    assert heading % 360 == pytest.approx(leg["heading"], abs=0.01)
    assert far == pytest.approx(20_000, abs=20)
    time = leg["duration"]  # by the current alone, and a kilometre to the north
    way = leg["current_east"] * time, leg["current_north"] * time + 1000
    near = report_of("Slocum", targets=[place_from(*reversed(start), *way)])
    assert near["aim"][0]["state"] == "reached"
    ((lat, lon),) = waypoints_of(near["paste"]["text"])
    far = WGS84.inv(*start, lon, lat)[2]
    assert far == pytest.approx(near["aim"][0]["through_water"], abs=1)


def test_a_slocum_that_corrects_gets_the_waypoints_themselves():
    read = waypoints_of(report_of("Slocum", note=CORRECTS)["paste"]["text"])
    assert read == [pytest.approx(place) for place in PLACES]


def test_a_seaexplorer_gets_heading_and_waypoints():
    text = report_of("SeaExplorer")["paste"]["text"].splitlines()
    assert re.fullmatch(r"DesiredH \d{3}", text[0])
    assert text[1] == "Lat -4248.0000 Lon 824.0000"


def test_without_a_known_vehicle_or_a_waypoint_there_is_nothing_to_paste():
    for kind, targets in (None, TARGETS), ("Seaglider", []):
        assert report_of(kind, targets=targets)["paste"] is None


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_file_lies_beside_the_page_which_shows_it(command, tmp_path):
    aim = ("--aim", *TARGETS[0])
    said = command("--sample", *aim, "--json", "--out", tmp_path / "out")
    text = (tmp_path / "out" / "targets").read_text()
    assert text == json.loads(said.stdout)["paste"]["text"]
    assert text in (tmp_path / "out" / "replay.html").read_text()
