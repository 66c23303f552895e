from .counterexamples import disturbance_counterexample, printed_bound
from .designing.design import design_track
from .designing.plot import design_plot
from .excitation.certificates import certificate, ultimate_bound
from .excitation.certify import certify
from .excitation.error_matrices import error_matrices
from .excitation.excitation_report import excitation_plot
from .excitation.gramian import gramian, started_true
from .lyapunov_function import lyapunov
from .proving.misprints import misprints
from .proving.own_law import prove
from .proving.theorems import audit
from .proving.verdict import Verdict
from .refuting import Search, refute

__all__ = [
    "Search",
    "Verdict",
    "audit",
    "certificate",
    "certify",
    "design_plot",
    "design_track",
    "disturbance_counterexample",
    "error_matrices",
    "excitation_plot",
    "gramian",
    "lyapunov",
    "misprints",
    "printed_bound",
    "prove",
    "refute",
    "started_true",
    "ultimate_bound",
]
