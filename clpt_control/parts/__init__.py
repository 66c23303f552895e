"""A shelf of parts for any loop: each is a Block, ten lines of NumPy with their source.

`actuators` (limits, gaps, switches, lags, delays), `controllers` (PID), `estimators` (observer,
Kalman filter, noise, sampler, table) and `vehicles`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
