"""A replay of all dives that are known, continued as more arrive.

Dives are sorted and chosen by `usable`, carried by the flow model if one was
given, and fed to a `Replay`.  Where new dives come after the old ones the replay
goes on; where one arrived late it begins anew, so that the result is always that
of all dives at once.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from ..currents.rayleigh import check_separable
from ..errors import ScenarioError
from ..estimation.fix_model import OTHERS, FixModel
from ..gliders.dives import Dive, Skipped
from ..gliders.usable_dives import LEAST_DURATION, usable
from ..progress.interrupt import check
from .flow_models import FlowModel, carried
from .replay import Replay


class Session:
    """A replay and what it was not fed.

    Attributes
    ----------
    replay : Replay
        Of the used dives so far.
    skipped : list of Skipped
        The others.

    Parameters
    ----------
    replay : Replay
        That has seen no dive.
    least_duration : float, optional
        Dives must last longer than this, s.

    Raises
    ------
    ScenarioError
        If the duration is negative or not a number.
    """

    def __init__(self, replay: Replay, least_duration: float = LEAST_DURATION) -> None:
        if not least_duration >= 0:
            raise ScenarioError(f"least duration = {least_duration:g} s: must be 0 s or more")
        self.replay, self.least_duration = replay, least_duration
        self.used: list[Dive] = []
        self.skipped: list[Skipped] = []

    def take(self, dives: Iterable[Dive], unread: Sequence[Skipped] = ()) -> None:
        """Choose the dives to use of all that are known.

        Parameters
        ----------
        dives : iterable of Dive
            In any order.
        unread : sequence of Skipped
            What the readers left out.
        """
        self.used, unused = usable(dives, self.least_duration)
        self.skipped = [*unread, *unused]

    def run(self, report: Callable[[int], None] = lambda done: None) -> None:
        """Feed the replay what it has not seen yet.

        Parameters
        ----------
        report : callable, optional
            Told how many dives are done.
        """
        self.replay, rest = continued(self.replay, self.used)
        known = len(self.used) - len(rest)
        for k, dive in enumerate(rest):
            check()
            model = self.replay.flow_model
            self.replay.step(dive if model is None else carried(dive, model))
            report(known + k + 1)


def continued(replay: Replay, dives: Sequence[Dive]) -> tuple[Replay, list[Dive]]:
    """Return the replay to go on with, and the dives it has yet to see.

    Parameters
    ----------
    replay : Replay
        Of the dives that were known before.
    dives : sequence of Dive
        All used dives, by time.

    Returns
    -------
    replay : Replay
        The same where new dives come after the old ones; else, as when a file
        arrived late, a new one.
    rest : list of Dive
    """
    known = [replace(step.dive, model_east=None, model_north=None) for step in replay.steps]
    if known == list(dives[: len(known)]):
        return replay, list(dives[len(known) :])
    return Replay(replay.estimator, replay.model, replay.flow_model), list(dives)


def check_tides(flow: Sequence[str], dives: Sequence[Dive]) -> None:
    """Refuse tides that the dives are too few to tell apart.

    A single tide is allowed on any record: its prior holds it.

    Parameters
    ----------
    flow : sequence of str
        As `FixModel.flow` has it.
    dives : sequence of Dive
        By time.

    Raises
    ------
    DataError
        If two tides need a longer record.
    """
    tides = [name for name in flow[1:] if name not in OTHERS]
    if len(tides) > 1 and dives:
        hours = round((dives[-1].t_gpse - dives[0].t_gps2) / 3600, 1)
        check_separable(tides, hours, f"flow {','.join(flow)}")


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
        In the order of their ends, as `usable` gives them.
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
    for dive in dives:
        check()
        replay.step(dive if flow_model is None else carried(dive, flow_model))
    return replay
