from .run import run_ensemble
from .spread import ensemble_plot
from .tune import tune_law

__all__ = ["ensemble_plot", "run_ensemble", "tune_law"]
