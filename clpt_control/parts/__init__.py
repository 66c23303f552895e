"""A shelf of parts for any loop: each is a Block, ten lines of NumPy with their source.

`limits`, `hysteresis` (gaps, switches), `lags` (delays, holds), `controllers` (PID), `observers`
(observer, Kalman filter, noise) and `vehicles`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
