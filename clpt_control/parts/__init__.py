"""Component library: each part is a Block, a few lines of NumPy with their source.

`limits` (tables, gaps, relays), `lags` (delays, holds), `controllers` (PID), `observers`
(observer, Kalman filter, noise) and `vehicles`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
