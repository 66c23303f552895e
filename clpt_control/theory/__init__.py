"""The paper's section III on the equations that run.

`audit` judges the four theorems, `misprints` lists the misprints, `design_track` finds waypoints.
Proofs of laws (`prove`, `lyapunov`), the Gramian of a track (`gramian`) and bounds for every start
(`certify`) are names of the package.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
