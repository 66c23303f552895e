"""Writes files of a Slocum's flight computer, as its maker describes their bytes; a mission."""

import struct

import numpy as np
from pyproj import Geod

WGS84 = Geod(ellps="WGS84")
KNOWN = b"sa" + struct.pack("<hfd", 4660, 123.456, 123456789.12345)
CRC = "0badcafe"
SENSORS = (
    "m_present_time",
    "m_gps_lat",
    "m_gps_lon",
    "m_gps_status",
    "m_gps_mag_var",
    "m_lat",
    "m_lon",
    "m_x_lmc",
    "m_y_lmc",
    "m_water_vx",
    "m_water_vy",
    "m_depth",
    "m_heading",
    "u_use_current_correction",
)
VARIATION = 17.0  # degrees east


def magnetic(vector):
    """Return a vector on axes along magnetic north and east of it."""
    c, s = np.cos(np.radians(VARIATION)), np.sin(np.radians(VARIATION))
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


def cac(names):
    """Return the list of sensors: all are logged, in 8 bytes."""
    return "".join(f"s: T {k} {k} 8 {name} X\n" for k, name in enumerate(names)).encode()


def segment(
    rows, names, short="00070001", full="unit-2024-100-7-1", factored=1, first=None, end=b"X"
):
    """Return a file whose cycles are dicts of new values, NaN where one says nothing.

    The first cycle is `first`, as far as it goes.
    """
    head = [
        "dbd_label:    DBD(dinkum_binary_data)file",
        "encoding_ver:    5",
        "num_ascii_tags:    14",
        "all_sensors:    F",
        f"the8x3_filename:    {short}",
        f"full_filename:    {full}",
        "filename_extension:    sbd",
        "mission_name:    MADE.MI",
        "fileopen_time:    Tue_Apr__9_00:00:00_2024",
        f"total_num_sensors:    {len(names)}",
        f"sensors_per_cycle:    {len(names)}",
        f"state_bytes_per_cycle:    {(len(names) + 3) // 4}",
        f"sensor_list_crc:    {CRC}",
        f"sensor_list_factored:    {factored}",
    ]
    out = ("\n".join(head) + "\n").encode() + (b"" if factored else cac(names)) + KNOWN
    for row in [dict.fromkeys(names, np.nan) | (first or {}), *rows]:
        codes = [2 if name in row else 0 for name in names] + [0] * (-len(names) % 4)
        states = [
            sum(codes[k + j] << (6 - 2 * j) for j in range(4)) for k in range(0, len(codes), 4)
        ]
        values = b"".join(struct.pack("<d", row[name]) for name in names if name in row)
        out += b"d" + bytes(states) + values
    return out + end


def place_at(start, moved):
    """Return the place (latitude, longitude) at a displacement, m east and north, from another."""
    lon, lat, _ = WGS84.fwd(*start[::-1], np.degrees(np.arctan2(*moved)), np.hypot(*moved))
    return lat, lon


def ddmm(degrees):
    """Return degrees as ddmm.mmm."""
    whole = np.trunc(degrees)
    return whole * 100 + (degrees - whole) * 60


T0, HOME = 1.7126e9, (51.6, -128.3)
STEP, LASTS, AFLOAT = 40.0, 7200.0, 600.0  # s
SEAS = np.array([[0.12 * np.cos(k), 0.12 * np.sin(1.3 * k)] for k in range(9)])  # m/s, by dive


class Mission:
    """Writes a mission: what the glider knows is a dict, of which each file begins with all.

    It adds the current of the dive before to its dead reckoning, `added` times, which it logs
    at each `every`-th cycle.
    """

    def __init__(self, folder, sensors=SENSORS, end=b"X", added=1.0, every=1):
        self.folder, self.sensors, self.end, self.added = folder, sensors, end, added
        self.knows = dict.fromkeys(SENSORS, 0.0) | {"u_use_current_correction": added}
        self.at, self.time, self.files, self.truth, self.every = HOME, T0, 0, [], every
        (folder / "cac").mkdir(parents=True)
        (folder / "cac" / f"{CRC.upper()}.CAC").write_bytes(cac(sensors))
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
        heading = (k - np.radians(VARIATION)) % (2 * np.pi)
        for n in range(round(LASTS / STEP) + 1):
            since = n * STEP
            self.at = place_at(start, (swim + sea) * since)
            if n == 0:
                cycles.append(self.fixed())
            else:
                places = {}
                if n % self.every == 0:
                    reckoned = (swim + self.added * before + wrong) * since
                    lat, lon = map(ddmm, place_at(start, reckoned))
                    x, y = magnetic(reckoned)
                    places = {"m_lat": lat, "m_lon": lon, "m_x_lmc": x, "m_y_lmc": y}
                deep = 60.0 if n < LASTS / STEP else 0.0
                cycles.append(self.says(m_depth=deep, m_heading=heading, **places))
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
