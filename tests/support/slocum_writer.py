"""Writes files of a Slocum's flight computer, as its maker describes their bytes; a mission."""

import struct

import numpy as np
from pyproj import Geod

WGS84 = Geod(ellps="WGS84")
HEAD = (  # lines, here between |
    "dbd_label: DBD(dinkum_binary_data)file|encoding_ver: 5|num_ascii_tags: 14|all_sensors: F|"
    "the8x3_filename: {short}|full_filename: {full}|filename_extension: sbd|mission_name: MADE.MI|"
    "fileopen_time: Tue_Apr__9_00:00:00_2024|total_num_sensors: {n}|sensors_per_cycle: {n}|"
    "state_bytes_per_cycle: {size}|sensor_list_crc: 0badcafe|sensor_list_factored: {factored}|"
)
KNOWN = b"sa" + struct.pack("<hfd", 4660, 123.456, 123456789.12345)
CRC = "0badcafe"
PLACES, OWN, FLAG = (
    ("m_lat", "m_lon"),
    ("m_water_vx", "m_water_vy"),
    ("u_use_current_correction",),
)
FIX = ("m_gps_lat", "m_gps_lon", "m_gps_status")
TURNS = ("m_gps_mag_var", "m_heading")
SENSORS = (
    "m_present_time",
    *FIX,
    *PLACES,
    "m_x_lmc",
    "m_y_lmc",
    *OWN,
    "m_depth",
    *TURNS,
    *FLAG,
)
VARIATION = 17.0  # degrees east


def magnetic(vector):
    """Return a vector on axes along magnetic north and east of it."""
    c, s = np.cos(np.radians(VARIATION)), np.sin(np.radians(VARIATION))
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


def cac(names):
    """Return the list of sensors: all are logged, in 8 bytes."""
    return "".join(
        f"s: T {k} {k} 8 {name} X\n" for k, name in enumerate(names)
    ).encode()


def segment(
    rows,
    names,
    short="00070001",
    full="unit-2024-100-7-1",
    factored=1,
    first=None,
    end=b"X",
):
    """Return a file whose cycles are dicts of new values, NaN where one says nothing.

    The first cycle is `first`, as far as it goes.
    """
    n, size = len(names), (len(names) + 3) // 4
    head = HEAD.format(
        short=short, full=full, n=n, size=size, factored=factored
    ).replace("|", "\n")
    out = head.encode() + (b"" if factored else cac(names)) + KNOWN
    for row in [dict.fromkeys(names, np.nan) | (first or {}), *rows]:
        values = [row[name] for name in names if name in row]
        bits = "".join("10" if name in row else "00" for name in names).ljust(
            8 * size, "0"
        )
        out += (
            b"d"
            + int(bits, 2).to_bytes(size)
            + struct.pack(f"<{len(values)}d", *values)
        )
    return out + end


def place_at(start, moved):
    """Return the place (latitude, longitude) at a displacement, m east and north, from another."""
    lon, lat, _ = WGS84.fwd(
        *start[::-1], np.degrees(np.arctan2(*moved)), np.hypot(*moved)
    )
    return lat, lon


def ddmm(place):
    """Return latitude and longitude as ddmm.mmm."""
    return [np.trunc(x) * 100 + (x - np.trunc(x)) * 60 for x in place]


STEP, LASTS, AFLOAT = 40.0, 7200.0, 600.0  # s
# m/s, by dive
SEAS = np.array([[0.12 * np.cos(k), 0.12 * np.sin(1.3 * k)] for k in range(9)])


class Mission:
    """Writes a mission: what the glider knows is a dict, of which each file begins with all.

    It adds the current of the dive before to its dead reckoning, `added` times, which it logs
    at each `every`-th cycle.
    """

    def __init__(self, folder, sensors=SENSORS, end=b"X", added=1.0, every=1):
        self.folder, self.sensors, self.end, self.added = folder, sensors, end, added
        self.knows = dict.fromkeys(SENSORS, 0.0) | {"u_use_current_correction": added}
        self.at, self.time, self.files, self.truth = (51.6, -128.3), 1.7126e9, 0, []
        self.every = every
        (folder / "cac").mkdir(parents=True)
        (folder / "cac" / f"{CRC.upper()}.CAC").write_bytes(cac(sensors))
        self.says(m_gps_mag_var=-np.radians(VARIATION))
        self.pair(OWN, magnetic(SEAS[0]))
        self.fixed()

    def says(self, **new):
        """Return a cycle: what is new at a time."""
        new = {"m_present_time": self.time, **new}
        self.knows |= new
        return {k: v for k, v in new.items() if k in self.sensors}

    def pair(self, names, values, **more):
        """Return a cycle of two sensors that belong together, and of others."""
        return self.says(**dict(zip(names, values, strict=True)), **more)

    def fixed(self):
        """Return the cycle of a fix, to which dead reckoning is set."""
        zero = dict.fromkeys(("m_gps_status", "m_x_lmc", "m_y_lmc", "m_depth"), 0.0)
        place = ddmm(self.at)
        return self.pair((*FIX[:2], *PLACES), (*place, *place), **zero)

    def dive(self, k, files=1, wrong=0.0, late=False):
        """Write a dive in so many files; its own current is worked out `late`, in the next one."""
        before, sea, swim = SEAS[k], SEAS[k + 1], 0.3 * np.array([np.sin(k), np.cos(k)])
        start, first = self.at, {**self.knows, "m_present_time": self.time}
        cuts = {round(LASTS / STEP * n / files) for n in range(1, files)}
        heading = (k - np.radians(VARIATION)) % (2 * np.pi)
        cycles = [self.fixed()]
        for since in STEP * np.arange(1, round(LASTS / STEP) + 1):
            self.time += STEP
            self.at, places = place_at(start, (swim + sea) * since), {}
            if since // STEP % self.every == 0:
                way = (swim + self.added * before + wrong) * since
                where = *ddmm(place_at(start, way)), *magnetic(way)
                places = dict(zip((*PLACES, "m_x_lmc", "m_y_lmc"), where, strict=True))
            deep = 60.0 if since < LASTS else 0.0
            cycles.append(self.says(m_depth=deep, m_heading=heading, **places))
            if since // STEP in cuts:
                self.write(cycles, first)
                cycles, first = [], {**self.knows}
        self.time += STEP
        cycles.append(self.fixed())
        self.truth.append(sea)
        self.time += STEP
        worked_out = self.pair(OWN, magnetic(sea))
        self.write(cycles if late else [*cycles, worked_out], first)
        self.time += AFLOAT

    def write(self, cycles, first):
        path = self.folder / f"unit-2024-100-7-{self.files}.sbd"
        first = {name: first[name] for name in self.sensors}
        path.write_bytes(
            segment(
                cycles,
                self.sensors,
                f"0007{self.files:04d}",
                path.stem,
                1,
                first,
                self.end,
            )
        )
        self.files += 1
