"""Estimates of the flow parameters theta from data.

From samples of a flow (`least_squares.least_squares`), or from fix to fix of a vehicle that
sees itself at surfacings only (`FixModel`, `make_estimator`).
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
