"""A made mission of a Slocum that adds the current of the dive before to its dead reckoning."""

import numpy as np
import pytest
from slocum_bytes import CRC, SENSORS, VARIATION, cac, ddmm, magnetic, place_at, segment

from clpt_control.gliders import read_dives, usable

T0, HOME = 1.7126e9, (51.6, -128.3)
STEP, LASTS, AFLOAT = 40.0, 7200.0, 600.0  # s
DIVES = 5  # in 1, 2, 3, 4 files and in 1
SEAS = np.array([[0.12 * np.cos(k), 0.12 * np.sin(1.3 * k)] for k in range(DIVES + 1)])


class Mission:
    """Writes a mission: what the glider knows is a dict, of which each file begins with all."""

    def __init__(self, folder, sensors=SENSORS, end=b"X", added=1.0):
        self.folder, self.sensors, self.end, self.added = folder, sensors, end, added
        self.knows = dict.fromkeys(SENSORS, 0.0) | {"u_use_current_correction": added}
        self.at, self.time, self.files, self.truth = HOME, T0, 0, []
        (folder / "cac").mkdir(parents=True)
        (folder / "cac" / f"{CRC}.cac").write_bytes(cac(sensors))
        self.says(m_gps_mag_var=-np.radians(VARIATION))
        self.works_out(SEAS[0])
        self.fixed()

    def says(self, **new):
        """Return a cycle: what is new at a time."""
        self.knows |= {"m_present_time": self.time, **new}
        return {k: v for k, v in {"m_present_time": self.time, **new}.items() if k in self.sensors}

    def works_out(self, sea):
        return self.says(**dict(zip(("m_water_vx", "m_water_vy"), magnetic(sea), strict=True)))

    def fixed(self):
        """Return the cycle of a fix, to which dead reckoning is set."""
        lat, lon = map(ddmm, self.at)
        zero = {"m_lat": lat, "m_lon": lon, "m_x_lmc": 0.0, "m_y_lmc": 0.0, "m_depth": 0.0}
        return self.says(m_gps_lat=lat, m_gps_lon=lon, m_gps_status=0.0, **zero)

    def dive(self, k, files=1, wrong=0.0, late=False):
        """Write a dive in so many files; its own current is worked out `late`, in the next one."""
        before, sea, swim = SEAS[k], SEAS[k + 1], 0.3 * np.array([np.sin(k), np.cos(k)])
        start, cycles, first = self.at, [], {**self.knows, "m_present_time": self.time}
        cuts = {round(LASTS / STEP * n / files) for n in range(1, files)}
        for n in range(round(LASTS / STEP) + 1):
            since = n * STEP
            self.at = place_at(start, (swim + sea) * since)
            if n == 0:
                cycles.append(self.fixed())
            else:
                reckoned = (swim + self.added * before + wrong) * since
                lat, lon = map(ddmm, place_at(start, reckoned))
                x, y = magnetic(reckoned)
                places = {"m_lat": lat, "m_lon": lon, "m_x_lmc": x, "m_y_lmc": y}
                deep = 60.0 if n < LASTS / STEP else 0.0
                cycles.append(self.says(m_depth=deep, m_heading=0.5, **places))
            if n in cuts:
                self.write(cycles, first)
                cycles, first = [], {**self.knows}
            self.time += STEP
        cycles.append(self.fixed())
        self.truth.append(sea)
        self.time += STEP
        worked_out = self.works_out(sea)
        self.write(cycles if late else [*cycles, worked_out], first)
        self.time += AFLOAT

    def write(self, cycles, first):
        path = self.folder / f"unit-2024-100-7-{self.files}.sbd"
        first = {name: first[name] for name in self.sensors}
        path.write_bytes(
            segment(cycles, self.sensors, f"0007{self.files:04d}", path.stem, 1, first, self.end)
        )
        self.files += 1


def flown(folder, without=(), **how):
    """Return the true currents and dives of a mission of segments of 1 to 4 files."""
    options = {key: how.pop(key) for key in ("end", "added") if key in how}
    mission = Mission(folder, tuple(n for n in SENSORS if n not in without), **options)
    for k in range(DIVES):
        mission.dive(k, 1 + k % 4, **how)
    dives, skipped = read_dives(folder)
    assert skipped == []
    return mission.truth, sorted(dives, key=lambda dive: dive.t_gpse)


def errors(truth, dives):
    """Return how far each dive's miss over its duration is from the truth, mm/s."""
    return [
        1e3 * np.hypot(d.miss_east / d.duration - sea[0], d.miss_north / d.duration - sea[1])
        for sea, d in zip(truth, dives, strict=True)
    ]


PLACES, OWN, FLAG = ("m_lat", "m_lon"), ("m_water_vx", "m_water_vy"), ("u_use_current_correction",)
MISSIONS = {
    "all is logged": {},
    "no final X": {"end": b""},
    "places on magnetic axes": {"without": PLACES},
    "the flag is not logged": {"without": FLAG},
    "the own current comes in the next file": {"late": True},
    "no correction": {"added": 0.0},
    "no correction, no flag": {"added": 0.0, "without": FLAG},
    "no correction, the own current comes in the next file": {"added": 0.0, "late": True},
}


@pytest.mark.parametrize("name", MISSIONS)
def test_each_dive_of_a_mission_has_the_current_of_its_sea(tmp_path, name):
    truth, dives = flown(tmp_path / "sbd", **MISSIONS[name])
    assert [d.number for d in dives] == [70000, 70002, 70005, 70009, 70010]
    assert max(errors(truth, dives)) < 5
    notes = [" ".join(dive.notes) for dive in dives]
    assert ["taken off" in note or "that current is" in note for note in notes] == [
        MISSIONS[name].get("added", 1.0) == 1.0
    ] * DIVES
    assert not any("cut short" in note for d in dives for note in d.notes)


def test_dead_reckoning_that_contradicts_the_own_current_is_not_used(tmp_path):
    truth, dives = flown(tmp_path / "sbd", wrong=np.array([0.1, -0.3]))
    assert max(errors(truth, dives)) < 5
    assert all(d.track is None and "not used, that current is" in d.notes[-1] for d in dives)
    assert len(usable(dives)[0]) == DIVES


@pytest.mark.parametrize("without", [OWN, FLAG])
def test_a_dive_that_may_hold_a_current_is_not_used(tmp_path, without):
    _, dives = flown(tmp_path / "sbd", without=without, late=True)
    used, skipped = usable(dives)
    assert used == []
    assert len(skipped) == DIVES
    assert all("holds a current" in s.why for s in skipped)


def test_what_nothing_says_is_said(tmp_path):
    _, dives = flown(tmp_path / "sbd", without=(*OWN, *FLAG))
    assert all("no file says whether" in d.notes[0] for d in dives)
