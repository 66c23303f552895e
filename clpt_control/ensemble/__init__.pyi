from .run import run_ensemble
from .spread import ensemble_plot, ensemble_summary, percentiles
from .tune import tune_law

__all__ = [
    "ensemble_plot",
    "ensemble_summary",
    "percentiles",
    "run_ensemble",
    "tune_law",
]
