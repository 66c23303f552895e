"""Files of gliders and the dives in them: `read_dives`, `usable`."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
