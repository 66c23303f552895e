"""The first import of the command `clpt`: from here on an interrupt is answered in one line.

It stands beside the package, whose import takes longer, and imports next to nothing itself.
"""

import os
import signal


def main() -> None:
    """Run the command line, which answers interrupts from where it begins."""
    from clpt_control.app.cli import main

    main(_leave)


def _leave(number: int, frame: object) -> None:
    """End at once: nothing was begun."""
    try:
        os.write(2, b"clpt: interrupted; nothing half-written was left\n")
    finally:
        os._exit(130)


if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, _leave)
