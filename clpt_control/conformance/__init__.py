"""Every reading of a block or diagram is asked, and a block is held to what every block must do.

`conformance(block)` raises an error with a sentence for each failure, `check_block` reports them;
`readings(diagram)` gives each reading of a diagram to ask by hand.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
