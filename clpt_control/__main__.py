"""The command `clpt`, also `python -m clpt_control`.

An interrupt is answered in one line from here on, before slower imports.
"""

import os
import signal


def main() -> None:
    """Run the command line, which answers interrupts from where it begins."""
    from .app.cli import main

    main(_leave)


def _leave(number: int, frame: object) -> None:
    """End at once: nothing was begun."""
    try:
        os.write(2, b"clpt: interrupted; nothing half-written was left\n")
    finally:
        os._exit(130)


if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, _leave)
if __name__ == "__main__":
    main()
