from .design.track_design import design_track as design_track
from .theorems.misprints import misprints as misprints
from .theorems.theorems import audit as audit
