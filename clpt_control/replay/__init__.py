"""A glider's dives replayed: `replay_dives`, `next_dive`."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
