"""Replay a glider's dives and look at what was learned.

    python examples/glider_replay.py [FOLDER [FILES...]]

Without FILES the fourteen dives of Seaglider SG542 that ship with the package
are used.  Each dive is forecast from earlier dives alone, by a mixture of
Gaussian processes; FOLDER (default: out) gets its NetCDF file and figure.
"""

import sys
from pathlib import Path

import clpt_control as clpt


def main(folder="out", *files):
    """Replay, compare, write."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    dives, skipped = (
        clpt.gliders.read_dives(files) if files else (clpt.gliders.sample_dives(), [])
    )
    for dive in skipped:
        print(f"dive {dive.dive} skipped: {dive.why}")
    replay = clpt.replay.replay_dives(dives)
    rms = replay.summary()["clpe_rms_after_3"]
    if rms["adaptive"] is not None:
        print(
            f"CLPE rms after the third dive {rms['adaptive']:.0f} m; with the previous dive's "
            f"current {rms['previous_dive']:.0f} m, without flow {rms['no_flow']:.0f} m"
        )
    last = replay.steps[-1]
    print(f"speed factor {last.speed:.3f} +- {last.speed_error:.3f}")
    print(f"not yet known: {', '.join(last.not_learned) or 'nothing'}")
    data = replay.dataset()
    data.to_netcdf(folder / "replay.nc")
    data.clpt.plot()[0].figure.savefig(folder / "replay.png")
    for name in ("replay.nc", "replay.png"):
        print(f"Wrote {folder / name}")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except clpt.ClptError as problem:
        sys.exit(str(problem))
