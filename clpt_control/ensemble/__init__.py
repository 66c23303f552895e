"""Many runs of one scenario: designed, run on threads or a cluster, kept in Zarr."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
