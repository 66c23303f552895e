"""The paper's section III as checks on the equations that run.

`audit` judges the four theorems, `prove` a law of your own.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
