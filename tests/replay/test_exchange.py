"""GeoJSON and KML, and what goes onto the vehicle, read back by rules of those who take them."""

import json
import re
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest
from pyproj import Geod
from synthetic_vehicle import fixes_of, told

from clpt_control.cli.replay_report import write
from clpt_control.geodesy import place_from
from clpt_control.gliders import slocum
from clpt_control.gliders.dive_files import read_dive_file, sample_dives
from clpt_control.gliders.dives import make_dive
from clpt_control.html import plain
from clpt_control.replay.exchange import next_geojson, track_kml
from clpt_control.replay.layers import ring_of

KML = {"k": "http://www.opengis.net/kml/2.2"}
GEOD = Geod(ellps="WGS84")


def turned(ring):
    """Twice the area of a ring, degrees^2, positive counter-clockwise."""
    x, y = np.array(ring).T
    return float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))


def inside(ring, lon, lat):
    """Whether a place lies in a convex ring that turns counter-clockwise."""
    x, y = np.array(ring).T
    return bool(np.all(np.diff(x) * (lat - y[:-1]) - np.diff(y) * (lon - x[:-1]) >= 0))


@pytest.mark.parametrize("lat", [-43.0, 0.0, 67.0, 80.0])
def test_a_ring_is_the_ellipse_on_the_earth(lat):
    row = told(fixes_of(5, lat))["each_dive"][-1]
    ring = ring_of(row)
    assert ring[0] == ring[-1]
    centre = row["forecast_longitude"], row["forecast_latitude"]
    far = [GEOD.inv(*centre, lon, lat)[2] for lat, lon in ring]
    assert max(far) == pytest.approx(row["ellipse_90_long"], rel=2e-3)
    assert min(far) == pytest.approx(row["ellipse_90_short"], rel=5e-3)
    bearing = GEOD.inv(*centre, ring[0][1], ring[0][0])[0]
    assert abs((bearing - row["ellipse_90_bearing"] + 90) % 180 - 90) < 1.0  # meridians turn


@pytest.mark.parametrize("lon", [8.0, 179.99, -180.0, 180.0, 180.01, -180.01])
def test_geojson_is_read_back_and_longitudes_count_on_at_180_degrees(lon):
    found = told(fixes_of(5, 51.0, lon))
    ahead, last = found["next_dive"], found["each_dive"][-1]
    shapes = {
        one["properties"]["name"]: one["geometry"]["coordinates"]
        for one in json.loads(next_geojson(found))["features"]
    }
    ring, goal = shapes["90 % ellipse"][0], shapes["next surfacing"]
    assert ring[0] == ring[-1]
    assert turned(ring) > 0
    assert any(inside(ring, goal[0] + turn, goal[1]) for turn in (-360, 0, 360))
    for (x, y), wanted, name in (
        (goal, ahead, ""),
        (shapes["way to the next surfacing"][0], last, "end_"),
    ):
        off = (x - wanted[f"{name}longitude"] + 180) % 360 - 180
        assert (off, y) == pytest.approx((0, wanted[f"{name}latitude"]), abs=1e-6)
    spans = [np.array(ring)[:, 0]]
    spans += [
        np.array([float(pair.split(",")[0]) for pair in one.text.split()])
        for one in ElementTree.fromstring(track_kml(found, "x")).iterfind(".//k:coordinates", KML)
    ]
    for span in spans:
        assert np.ptp(span) < 90
        assert abs(span[0]) <= 180


def test_kml_is_read_back():
    found = told(fixes_of(5, -43.0))
    root = ElementTree.fromstring(track_kml(found, "SG<1> & co \x00"))
    assert root.find("k:Document/k:name", KML).text == "SG<1> & co \ufffd"
    fixes = [
        (one.find("k:TimeStamp/k:when", KML).text, one.find("k:Point/k:coordinates", KML).text)
        for one in root.iterfind("k:Document/k:Placemark", KML)
        if one.find("k:name", KML).text.startswith("dive ")
    ]
    assert [when for when, _ in fixes] == [row["end"] for row in found["each_dive"]]
    for (_, text), row in zip(fixes, found["each_dive"], strict=True):
        lon, lat = map(float, text.split(","))
        assert (lat, lon) == pytest.approx((row["end_latitude"], row["end_longitude"]), abs=1e-6)
    names = {style.get("id") for style in root.iterfind(".//k:Style", KML)}
    assert {one.text[1:] for one in root.iterfind(".//k:styleUrl", KML)} <= names


def test_plain_text_can_be_written_and_parsed():
    text = plain("".join(map(chr, range(0x300))) + "\ud800\udcff\ufffe\U0001f600")
    assert text.encode().decode() == text
    made = ElementTree.Element("a")
    made.text = text.replace("\r", "")
    assert ElementTree.fromstring(ElementTree.tostring(made)).text == made.text


def test_one_dive_is_enough():
    dive = make_dive(1, (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02), (500.0, 0.0))
    found = told([dive])
    assert len(json.loads(next_geojson(found))["features"]) == 4
    ElementTree.fromstring(track_kml(found, "one"))


TARGETS = [(-42.8, 8.4), (-42.0, -351.75), (-42.0, -0.5)]
PLACES = [TARGETS[0], (-42.0, 8.25), TARGETS[2]]
NUMBER = re.compile(r"-?\d+\d\d\.\d{4}")


def found_of(kind, note="", targets=TARGETS):
    *dives, last = sample_dives()
    return told([*dives, replace(last, kind=kind, notes=(note,))], *targets)


def degrees_of(word):
    """A number ddmm.mmmm as a vehicle reads it: the last two whole digits are minutes."""
    assert NUMBER.fullmatch(word)
    sign, whole = (-1, word[1:]) if word[0] == "-" else (1, word)
    at = whole.index(".") - 2
    assert float(whole[at:]) < 60
    return sign * (int(whole[:at] or 0) + float(whole[at:]) / 60)


def targets_of(text):
    """Lines of a targets file by the rules of basestation3's validate.py: name, then key=value."""
    read = {}
    for line in filter(None, text.splitlines()):
        if line[0] != "/":
            name, *pairs = line.split()
            read[name] = dict(pair.split("=") for pair in pairs)
    for one in read.values():
        assert set(one) == {"lat", "lon", "radius", "goto"}
        assert one["goto"] in read
    return read


def waypoints_of(text):
    """A goto_list as mafiles have it: arguments, then a line for each waypoint, lon lat."""
    lines = [line.partition("#")[0].strip() for line in text.splitlines()]
    assert lines[0] == "behavior_name=goto_list"
    first, last = lines.index("<start:b_arg>"), lines.index("<end:b_arg>")
    arguments = dict(
        re.fullmatch(r"b_arg: (\w+)\(\w+\) (-?\d+)", one).groups()
        for one in lines[first + 1 : last]
    )
    assert lines[last + 1] == "<start:waypoints>"
    assert lines[-1] == "<end:waypoints>"
    places = [line.split() for line in lines[last + 2 : -1]]
    assert int(arguments["num_waypoints"]) == len(places) <= 8
    assert arguments["list_stop_when"] == "7"
    assert int(arguments["list_when_wpt_dist"]) >= 10
    return [(degrees_of(lat), degrees_of(lon)) for lon, lat in places]


def test_a_seaglider_gets_targets_and_a_true_heading():
    found = found_of("Seaglider")
    assert found["paste"]["file"] == "targets"
    read = targets_of(found["paste"]["text"])
    places = [(degrees_of(one["lat"]), degrees_of(one["lon"])) for one in read.values()]
    assert places == [pytest.approx(place) for place in PLACES]
    assert [one["goto"] for one in read.values()] == ["AIM2", "AIM3", "AIM3"]
    said = re.search(r"\$HEADING,(\d+\.\d)", found["paste"]["text"])
    assert float(said[1]) == pytest.approx(found["aim"][0]["heading"], abs=0.051)
    assert "$NAV_MODE,0" in found["paste"]["text"]  # or it would correct for the current again


def test_a_slocum_that_does_not_correct_gets_a_waypoint_along_the_heading():
    found = found_of("Slocum")
    assert found["paste"]["file"] == "goto_l10.ma"
    ((lat, lon),) = waypoints_of(found["paste"]["text"])
    leg = found["aim"][0]
    start = leg["from_longitude"], leg["from_latitude"]
    heading, _, far = Geod(ellps="WGS84").inv(*start, lon, lat)
    assert heading % 360 == pytest.approx(leg["heading"], abs=0.01)
    assert far == pytest.approx(20_000, abs=20)
    time = leg["duration"]  # by the current alone, and a kilometre to the north
    way = leg["current_east"] * time, leg["current_north"] * time + 1000
    near = found_of("Slocum", targets=[place_from(*reversed(start), *way)])
    assert near["aim"][0]["state"] == "reached"
    ((lat, lon),) = waypoints_of(near["paste"]["text"])
    far = Geod(ellps="WGS84").inv(*start, lon, lat)[2]
    assert far == pytest.approx(near["aim"][0]["through_water"], abs=1)


def test_a_slocum_that_corrects_gets_the_waypoints_themselves():
    read = waypoints_of(found_of("Slocum", note=slocum.CORRECTS)["paste"]["text"])
    assert read == [pytest.approx(place) for place in PLACES]


def test_a_seaexplorer_gets_heading_and_waypoints():
    text = found_of("SeaExplorer")["paste"]["text"].splitlines()
    assert re.fullmatch(r"DesiredH \d{3}", text[0])
    assert text[1] == "Lat -4248.0000 Lon 824.0000"


@pytest.mark.parametrize(("kind", "targets"), [(None, TARGETS), ("Seaglider", [])])
def test_without_a_known_vehicle_or_a_waypoint_there_is_nothing_to_paste(kind, targets):
    assert found_of(kind, targets=targets)["paste"] is None


@pytest.mark.usefixtures("undrawn")
def test_the_file_lies_beside_the_page_which_shows_it(tmp_path):
    found = found_of("Seaglider", targets=TARGETS[:1])
    assert tmp_path / "targets" in write(found, tmp_path, ())
    text = (tmp_path / "targets").read_text()
    assert text == found["paste"]["text"]
    assert text in (tmp_path / "replay.html").read_text()


@pytest.mark.parametrize(
    ("file", "kind"),
    [
        ("basestation/p5420305.nc", "Seaglider"),
        ("sea035/SEA035.10.gli.sub.003", "SeaExplorer"),
        ("og1/sg015_20040929T140907_delayed.nc", None),
        ("sg171_dives.csv", None),
    ],
)
def test_the_files_say_which_vehicle_it_is(file, kind, facts):
    dives, _ = read_dive_file(facts / "glider" / file)
    assert {dive.kind for dive in dives} == {kind}
