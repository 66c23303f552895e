"""Priors of the estimators: each number with its source.

"Judgement" is engineering judgement: plausible for any glider, in no paper.
`python -m analysis.prior_sensitivity` halves and doubles the numbers one at a time.
"""

from typing import Any, NamedTuple

DAY = 86400.0  # s


class Sea(NamedTuple):
    """Slow current and noise of a kind of sea: numbers, or arrays (m,) of m processes."""

    size: Any  # S, m/s, of the slow current
    memory: Any  # tau, s
    smooth: Any = 1.0  # 1: a smooth current, 0: a rough one (`dive_regression`)
    scatter: Any = 0.005  # s, m/s, white noise from dive to dive
    mapped: Any = 0.0  # m/s, of a steady current that depends on position


class Priors(NamedTuple):
    """Standard deviations and times before any dive, m, s and rad.

    `FixModel(priors=Priors(speed=0.3))` has other ones.
    """

    # GPS has 4 m (Rudnick, Sherman, Wu, J. Atmos. Oceanic Technol. 35, 1665, 2018); two fixes, and
    # the drift at the surface between a fix and the water beneath: judgement
    fix: float = 30.0  # m, one component of the difference of two fixes
    # judgement: most of the ocean has less, jets have more
    current: float = 0.3  # m/s
    # judgement: 0.02 in the deep sea, 0.1 to 0.5 on shelves
    tide: float = 0.1  # m/s, of each constituent's four numbers
    # strong events have 0.2 at the surface (Poulain, "Near-inertial and diurnal motions in the
    # trajectories of mixed layer drifters", J. Marine Research 48, 1990), a dive's mean has less;
    # with 0.05 the 90 % ellipses after a made storm held 83 % of the surfacings
    inertial: float = 0.1  # m/s
    # judgement: eddies of 0.3 m/s have half of it at 200 m, or at 1000
    shear: float = 0.1  # m/s, of a dive e times as deep
    # judgement: half a current
    gaussian: float = (
        0.15  # m/s, of a steady current that depends on position, and of a gaussian
    )
    # judgement: a forecast may be nothing, right, or half as strong again
    model: float = 0.7  # of the factor on a flow model
    # judgement, settled with the sample's vehicle in view: flight models that are not trimmed yet
    speed: float = 0.15  # of the factor on speed, less one
    # judgement: makers of compasses promise 1 degree, hulls and batteries add as much
    compass: float = 0.03  # rad

    # shelves are 9 % of the ocean (Harris et al., "Geomorphology of the oceans", 2014)
    shelf: float = 0.1  # probability that tides are strong
    present: float = 0.5  # of any other part: nothing is known

    # ten inertial periods at mid-latitudes are a week (Poulain 1990); gliders leave the place: half
    inertial_fading: float = 4 * DAY
    # neaps come after 7 days, other places after weeks: judgement
    tide_fading: float = 60 * DAY
    # judgement: what grows on a hull changes the speed by 4 % in 100 days
    speed_fading: float = 2800 * DAY
    # judgement: a degree in 100 days
    compass_fading: float = 450 * DAY

    # from currents that hardly change to a jet's edge: chosen on the made seas of `analysis` and
    # the real vehicles of `docs/gliders_method.md`, the fewest that forecast as well, and find a
    # lost speed as often, as forty covariances
    kinds: tuple[Sea, ...] = (
        Sea(0.05, 8 * DAY),
        Sea(0.05, 8 * DAY, scatter=0.01),
        Sea(0.1, DAY / 2),
        Sea(0.35, 2 * DAY),
        Sea(0.35, 4 * DAY, scatter=0.02),
        Sea(0.1, 8 * DAY, scatter=0.05),
        Sea(0.08, 8 * DAY, smooth=0.0),
        Sea(0.16, 8 * DAY, smooth=0.0),
        Sea(0.35, 8 * DAY, smooth=0.0),
    )

    # judgement: a missed front counts little (Lange, Little, Taylor, J. Am. Stat. Assoc. 84, 1989)
    degrees_of_freedom: float = 8.0  # of the density that weights processes
    # judgement: a voyage comes to another sea in weeks
    weight_memory: float = 20 * DAY

    # the gradient's.  With 1 the parameters explain the last dive (Goodwin, Sin 1984, projection)
    gain: float = 1.0  # mu, between 0 and 2 for stability
    # judgement: the gradient's one sea; a current that it forgets walks 0.04 m/s in six hours
    gradient: Sea = Sea(0.0, 28.125 * DAY, scatter=0.04)
