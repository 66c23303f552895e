"""Component library: each part is a Block, a few lines of NumPy with their source.

`limits` (tables, gaps, relays), `lags` (delays, holds), `controllers` (PID), `observers`
(observer, Kalman filter, noise) and `vehicles`.
"""

from ..base.public_modules import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
