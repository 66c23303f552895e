"""The paper's section III on the equations that run.

`audit` judges the four theorems, `misprints` lists the misprints, `design_track` finds waypoints.
Proofs of laws (`prove`, `lyapunov`), the Gramian of a track (`gramian`) and bounds for every start
(`certify`) are names of the package.
"""

from ..base.public_modules import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
