from .counterexamples import disturbance_counterexample, printed_bound
from .design.track_design import design_plot, design_track
from .excitation.certificates import certificate, ultimate_bound
from .excitation.certify import certify
from .excitation.excitation_report import excitation_plot
from .excitation.gramian import gramian, started_true
from .excitation.regressor import error_matrices
from .lyapunov_function import lyapunov
from .proofs.judge import Verdict
from .proofs.misprints import misprints
from .proofs.prove_law import prove
from .proofs.theorems import audit
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
