"""The aim of a replay as a vehicle takes it: a file to upload, or lines to type.

Places are degrees and minutes in one number, ddmm.mmmm, south and west negative.

Seaglider (University of Washington, Parameter Reference Manual 67; basestation3, validate.py).
`$HEADING` in the cmdfile, degrees from true north, puts a target 20 km away; the targets file
counts where it is -1.  Under `$NAV_MODE` 2 the glider corrects for the current of its last dive,
under 1 for that of its own filter, so the aim is for mode 0.  A line of the targets file is a
name, lat, lon, radius (m) and the name of the target that follows; a comment begins with `/`.

Slocum (Teledyne, Slocum G2 Operators Training Guide, 2012; mafiles of Rutgers' RU23, 2023).  A
mafile of goto_list: arguments, then a line for each waypoint, longitude first.  It steers straight
for a waypoint where u_use_current_correction is 0, so there it gets one far along the heading; a
glider that corrects for the current gets the waypoints.

SeaExplorer: its mission file is not public.  The lines say heading and waypoint, as its own
navigation files have them (DesiredH, Lat, Lon), to be typed.
"""

from math import cos, radians, sin

from ...base.geodesy import east_of, place_from
from ..gliders.slocum import CORRECTS
from .aim import ARRIVED
from .table_rows import REACHED, Report, Row, compass, minutes, place_in

FAR = 20_000.0  # m along the heading, as Seaglider has it
MOST = 8  # waypoints that a goto_list holds
UNTIL = (  # arguments of a goto_list
    "num_legs_to_run(nodim) -1  # loop",
    "start_when(enum) 0  # BAW_IMMEDIATELY",
    "list_stop_when(enum) 7  # BAW_WHEN_WPT_DIST",
    "list_when_wpt_dist(m) 100",
    "initial_wpt(enum) 0  # the first",
)


def paste(report: Report) -> dict[str, str] | None:
    """Return name and text of what goes onto the vehicle, of what `--json` prints.

    None where nothing is aimed at, or no file says which kind of vehicle it is.
    """
    write = WRITERS.get(report["kind"])
    if write is None or not report["aim"] or report["aim"][0]["heading"] is None:
        return None
    corrects = CORRECTS in report["each_dive"][-1]["notes"]
    name, lines = write(report["aim"], corrects)
    return {"file": name, "text": "\n".join(lines) + "\n"}


def _seaglider(legs: list[Row], _: bool) -> tuple[str, list[str]]:
    names = [f"AIM{k + 1}" for k in range(len(legs))]
    lines = [
        "/ in the cmdfile, for the next dive:",
        "/ $NAV_MODE,0",
        f"/ $HEADING,{legs[0]['heading']:.1f}",
        "/ this targets file counts where $HEADING is -1",
    ]
    for name, after, leg in zip(names, [*names[1:], names[-1]], legs, strict=True):
        lat, lon = _numbers(*place_in(leg, ""))
        lines.append(f"{name} lat={lat} lon={lon} radius={ARRIVED:.0f} goto={after}")
    return "targets", lines


def _slocum(legs: list[Row], corrects: bool) -> tuple[str, list[str]]:
    next_leg = legs[0]
    waypoints = [place_in(leg, "") for leg in legs[:MOST]]
    comment = (
        "the waypoints: this glider corrects for the current itself "
        "(u_use_current_correction 1)"
    )
    if not corrects:
        distance_ahead = (
            next_leg["through_water"] if next_leg["state"] == REACHED else FAR
        )
        angle = radians(next_leg["heading"])
        waypoints = [
            place_from(
                *place_in(next_leg, "from_"),
                distance_ahead * sin(angle),
                distance_ahead * cos(angle),
            )
        ]
        comment = f"heading {compass(next_leg['heading'])} (true), for u_use_current_correction 0"
    lines = ["behavior_name=goto_list", f"# {comment}", "<start:b_arg>"]
    lines += [
        f"b_arg: {argument}"
        for argument in (*UNTIL, f"num_waypoints(nodim) {len(waypoints)}")
    ]
    lines += ["<end:b_arg>", "<start:waypoints>"]
    lines += ["{1} {0}".format(*_numbers(*argument)) for argument in waypoints]
    return "goto_l10.ma", [*lines, "<end:waypoints>"]


def _seaexplorer(legs: list[Row], _: bool) -> tuple[str, list[str]]:
    lines = [f"DesiredH {compass(legs[0]['heading'])}"]
    lines += ["Lat {} Lon {}".format(*_numbers(*place_in(leg, ""))) for leg in legs]
    return "seaexplorer.txt", lines


def _numbers(lat: float, lon: float) -> tuple[str, str]:
    return minutes(lat), minutes(east_of(lon))


WRITERS = {"Seaglider": _seaglider, "Slocum": _slocum, "SeaExplorer": _seaexplorer}
