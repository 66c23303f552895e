"""The team of the example, two vehicles in a strait, and small teams of paper vehicles."""

from paths import ROOT

import clpt_control as clpt

FILE = ROOT / "clpt_control" / "data" / "team.toml"
EXACT = {"run.rtol": 1e-11, "run.atol": 1e-13}
PAPER = clpt.paper_scenario().with_values(
    {"run.duration": 12, "run.output_step": 0.5, **EXACT}
)


def vehicle(**values):
    """A vehicle of the paper's, with values by key, _ in place of the first dot."""
    return PAPER.with_values({key.replace("_", ".", 1): v for key, v in values.items()})


def team(coupling=0.6, edges=None, **members):
    """A team of such vehicles."""
    return clpt.Team(members=members, edges=edges, coupling=coupling)


def write_team(path, of):
    """Write a team's TOML file: the text that its run carries."""
    path.write_text(clpt.simulate(of, [0.0, 0.5]).attrs["team"])


DIFFERENT = {
    "a": vehicle(vehicle_position=[1.0, -0.5], learning_position=[0.5, 0.5]),
    "b": vehicle(
        reference_radius=2.0, vehicle_feedback=[1.4, 0.8], reference_dwell=3.0
    ),
    "c": vehicle(
        reference={
            "kind": "waypoints",
            "points": [[4.0, 1.0], [1.0, 4.0]],
            "dwell": 5.0,
        },
        learning_parameters=[[0.3, 0.1, -0.2], [-0.5, 0.2, 0.4]],
        vehicle_feedforward=[0.9, 1.2],
    ),
}
ROW = [("a", "b"), ("b", "c")]
