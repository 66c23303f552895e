"""Names of a run's attributes, and the memory that a run may take."""

MOST_BYTES = 4 * 10**9  # memory of a run
CHANGED = "parameters_changed"  # attribute of a run: parameters given at call time
# attribute of a team's run, in place of its scenario: the team as TOML text
TEAM = "team"
OWN_LAW = "own_law"  # attribute of a run: the name of a law given in Python
# attribute of a run: other blocks of its diagram that were given in Python
OWN_PARTS = "own_parts"
REFERENCE = "reference"  # name of the block of the waypoints
FORM = "run_format"  # attribute of a run's file: the number of its format; default 1
IN_PYTHON = "the rest to closed_loop(replace=..., insert=...)"
BEYOND = {  # attribute of a run -> change that its scenario does not have, remedy in Python
    CHANGED: (
        "parameters given at call time",
        "the parameters to simulate(params=...)",
    ),
    OWN_LAW: ("a law given in Python", IN_PYTHON),
    OWN_PARTS: ("parts given in Python", IN_PYTHON),
}
