"""Pages to send: a run, a team's run, an ensemble or a replay as one HTML file."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
