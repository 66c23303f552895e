from .ensemble_statistics import ensemble_plot
from .run import run_ensemble
from .tune import tune_law

__all__ = ["ensemble_plot", "run_ensemble", "tune_law"]
