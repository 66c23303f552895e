from .design.track_design import design_track
from .excitation.gramian import started_true
from .proofs.misprints import misprints
from .proofs.theorems import audit

__all__ = ["audit", "design_track", "misprints", "started_true"]
