"""Ensembles: many runs with sampled parameters, on threads or a cluster, stored in Zarr."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
