"""The paper's section III on the equations that run.

`audit` judges the four theorems, `prove` a law of your own, `misprints` lists what is misprinted.
`gramian` and `certificate` say what a track can teach and how fast; `disturbance_counterexample`
and `printed_bound` set the printed bounds beside a run.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
