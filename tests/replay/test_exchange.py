"""GeoJSON and KML, read back: places, rings, what crosses 180 degrees, texts of files."""

import json
from xml.etree import ElementTree

import numpy as np
import pytest
from pyproj import Geod
from synthetic_vehicle import fixes_of, told

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
