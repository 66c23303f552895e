"""Writes files of a Slocum's flight computer, as its maker describes their bytes."""

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
