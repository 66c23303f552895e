"""A whole watch: thirty files arrive, the follower is killed twice, what it writes is whole."""

import json
import signal
import subprocess
import threading
from pathlib import Path
from xml.etree import ElementTree

import pytest
import xarray
from html_reader import Reader
from processes import CLPT, GUARD, await_line, kill_while_it_writes, started
from synthetic_vehicle import fixes_of, one_file_each

DIVES = 30
KILLED = {11: ".replay.html.*.part", 21: ".map.png.*.part"}  # while this is being written
AGAIN = '<noscript><meta http-equiv="refresh" content="60"></noscript>\n', ' data-again="60"'
KML = "{http://www.opengis.net/kml/2.2}"


def dives_in_page(path):
    page = Reader(path.read_text("utf-8"))
    return len([1 for tag, names in page.tags if tag == "tr" and "data-dive" in names])


def dives_in_geojson(path):
    features = json.loads(path.read_text("utf-8"))["features"]
    return next(one["properties"]["dive"] for one in features if "dive" in one["properties"])


def dives_in_kml(path):
    document = ElementTree.fromstring(path.read_text("utf-8"))[0]
    return len(document.find(f"{KML}Folder").findall(f"{KML}Placemark"))


READ = {"replay.html": dives_in_page, "next.geojson": dives_in_geojson, "track.kml": dives_in_kml}


class Watcher(threading.Thread):
    """Parses the files of a folder all the time; keeps how many dives each had, and what broke."""

    def __init__(self, folder):
        super().__init__(daemon=True)
        self.folder, self.over, self.wrong = Path(folder), threading.Event(), None
        self.seen = {name: [] for name in READ}

    def run(self):
        try:
            while not self.over.is_set():
                for name, count in READ.items():
                    path = self.folder / name
                    if path.exists() or self.seen[name]:
                        self.seen[name].append(count(path))
        except Exception as error:
            self.wrong = error


@pytest.mark.slow
def test_a_whole_watch(tmp_path):
    inbox, out = tmp_path / "in", tmp_path / "out"
    inbox.mkdir()
    out.mkdir()
    words = (*CLPT, "replay", "--follow", inbox, "--out", out, "--every", "0.02")
    dives = iter(fixes_of(DIVES))
    arrived = 0
    watcher = Watcher(out)
    watcher.start()
    for until in (*KILLED, DIVES + 1):
        with started(words, stdout=subprocess.DEVNULL) as process:
            await_line(process, process.stderr, " used")
            for dive in dives:
                one_file_each(inbox, [dive])
                arrived += 1
                if arrived == until:
                    kill_while_it_writes(process, out, KILLED[until])
                    break
                await_line(process, process.stderr, f", {arrived} dive")
                assert watcher.wrong is None
            if arrived == DIVES:
                process.send_signal(signal.SIGTERM)
                assert process.wait(GUARD) == 0
    watcher.over.set()
    watcher.join(GUARD)
    assert watcher.wrong is None
    for name, counts in watcher.seen.items():
        assert counts == sorted(counts), name
        assert len(set(counts)) > DIVES / 2, name  # it looked while they came
        assert READ[name](out / name) == DIVES
    assert not list(out.glob("*.part")) + list(out.glob(".*.part"))
    at_once = tmp_path / "at_once"
    subprocess.run([*CLPT, "replay", inbox, "--out", at_once], check=True, capture_output=True)
    for name in READ:
        watched = (out / name).read_text("utf-8")
        for again in AGAIN:  # the page of a watch loads itself anew
            assert (again in watched) == (name == "replay.html")
            watched = watched.replace(again, "")
        assert watched == (at_once / name).read_text("utf-8"), name
    one, other = (xarray.open_dataset(folder / "replay.nc") for folder in (out, at_once))
    with one, other:
        assert one.identical(other)
