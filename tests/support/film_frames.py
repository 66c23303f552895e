"""Lines and arrows of one frame of a film, as matplotlib has them."""

import numpy as np
from matplotlib.figure import Figure

from clpt_control.simulation.animation import draw_samples


def frame_of(run, sample):
    """Return the Axes of a run's film at a sample."""
    ax = Figure().subplots()
    next(draw_samples(ax, run, np.array([sample])))
    return ax
