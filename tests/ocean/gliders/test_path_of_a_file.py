"""A glider's file passes few files of the package, from stage to stage.

A return is a pair of files of which the second was entered before the first, and has a function
that the first calls. Properties are data and no calls.
"""

import inspect
import sys
from pathlib import Path

import pytest
from paths import TESTS

import clpt_control as clpt
from clpt_control.ocean.forecast import replay_summary

OCEAN = str(Path(clpt.__file__).parent / "ocean")
GLIDER = TESTS / "data" / "glider"
FILES = (
    "basestation",
    "og1/sg015_20040929T140907_delayed.nc",
    "slocum_rosie/sbd",
    "sea035m10_dives.csv",
)


def results_of(path):
    """Read, replay, forecast and put into words."""
    dives, skipped = clpt.gliders.read_dives(path)
    replay = clpt.replay.replay_dives(dives)
    report = replay.summary(skipped, replay.next_dive())
    return [*replay_summary.remarks(report), *replay_summary.coming(report)]


def calls(function, *arguments):
    """Names of functions of `ocean` in the order of their calls: file of the caller, own file."""
    entered = []

    def heard(frame, event, _):
        code = frame.f_code
        if event != "call" or not code.co_filename.startswith(OCEAN):
            return
        above = frame.f_back
        while above and not above.f_code.co_filename.startswith(OCEAN):
            above = above.f_back
        caller = above.f_code.co_filename if above else None
        if "<module>" not in (code.co_name, above and above.f_code.co_name):
            entered.append((caller, code.co_filename, code.co_name))

    before = sys.getprofile()
    sys.setprofile(heard)
    try:
        function(*arguments)
    finally:
        sys.setprofile(before)
    return entered


def properties():
    """Names of properties of the classes of `ocean`."""
    modules = [m for name, m in sys.modules.items() if "clpt_control.ocean" in name]
    classes = [c for m in modules for c in vars(m).values() if inspect.isclass(c)]
    return {
        name
        for c in classes
        for name, value in vars(c).items()
        if type(value).__name__ in ("property", "cached_property")
    }


@pytest.mark.parametrize("name", FILES)
def test_a_file_goes_from_stage_to_stage(name):
    entered = calls(results_of, GLIDER / name)
    order = list(dict.fromkeys(file for _, file, _ in entered))
    data = properties() | {"<genexpr>", "<lambda>"}
    returns = {
        (Path(caller).stem, Path(file).stem)
        for caller, file, function in entered
        if caller and function not in data and order.index(file) < order.index(caller)
    }
    assert Path(order[0]).stem == "dive_files"
    assert Path(order[-1]).stem in ("replay_summary", "table_rows")
    assert len(order) <= 17, [Path(file).stem for file in order]
    assert len(returns) <= 6, sorted(returns)
