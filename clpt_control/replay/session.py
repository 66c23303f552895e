"""Dives fed to a replay, in the order of their ends.

Each is carried by the flow model first, if one was given.  Two tides need a
record that is long enough to tell them apart.
"""

from collections.abc import Callable, Iterable, Sequence

from ..currents.rayleigh import check_separable
from ..estimation.fix_model import OTHERS, FixModel
from ..gliders.dives import Dive
from ..progress.interrupt import check
from .flow_models import FlowModel, carried
from .replay import Replay


def check_tides(flow: Sequence[str], dives: Sequence[Dive]) -> None:
    """Refuse tides of `FixModel.flow` that dives, by time, are too few to tell apart.

    A single tide is allowed on any record: its prior holds it.
    """
    tides = [name for name in flow[1:] if name not in OTHERS]
    if len(tides) > 1 and dives:
        hours = round((dives[-1].t_gpse - dives[0].t_gps2) / 3600, 1)
        check_separable(tides, hours, f"flow {','.join(flow)}")


def feed(
    replay: Replay, dives: Sequence[Dive], report: Callable[[int], None] = lambda done: None
) -> Replay:
    """Feed dives to a replay, carried by its flow model; report how many are done."""
    for k, dive in enumerate(dives):
        check()
        model = replay.flow_model
        replay.step(dive if model is None else carried(dive, model))
        report(k + 1)
    return replay


def replay_dives(
    dives: Iterable[Dive],
    estimator: str = "kalman",
    model: FixModel | None = None,
    flow_model: FlowModel | None = None,
) -> Replay:
    """Feed used dives to a new replay.

    Parameters
    ----------
    dives : iterable of Dive
        In the order of their ends, as `usable` returns them.
    estimator : str, optional
        ``"kalman"``, ``"rls"`` or ``"gradient"``.
    model : FixModel, optional
        The parameters; by default steady, M2, inertial and speed.
    flow_model : FlowModel, optional
        Carries each dive before it is fed.

    Returns
    -------
    Replay
        After the last dive.

    Raises
    ------
    DataError
        If dives are out of order, or too few to tell the model's tides apart.
    ScenarioError
        If the estimator is unknown.
    """
    dives = list(dives)
    replay = Replay(estimator, model or FixModel(), flow_model)
    check_tides(replay.model.flow, dives)
    return feed(replay, dives)
