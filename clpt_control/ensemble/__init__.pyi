from .plots import ensemble_plot
from .run import run_ensemble
from .spread import ensemble_summary, percentiles
from .vary import Vary

__all__ = [
    "Vary",
    "ensemble_plot",
    "ensemble_summary",
    "percentiles",
    "run_ensemble",
]
