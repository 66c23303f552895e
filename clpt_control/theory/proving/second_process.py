"""The other process of `two_processes`: a part a line in, its verdict a line out."""

import gc
import json
import os
import signal
import sys
import threading
from queue import SimpleQueue

signal.signal(signal.SIGINT, signal.SIG_IGN)  # the one that asks is told
gc.set_threshold(200_000, 50, 50)  # as in `clpt`: expressions are many objects


def main() -> None:
    """Answer until nothing more is asked, or nobody is there to ask."""
    asked: SimpleQueue[str] = SimpleQueue()

    def read() -> None:
        for line in sys.stdin:
            asked.put(line)
        os._exit(0)  # also amid a part

    threading.Thread(target=read, daemon=True).start()
    from .judgement import Part, plain
    from .kept_verdicts import digest

    print(digest(), flush=True)
    while True:
        said = plain(Part(*json.loads(asked.get())).judged())
        print(json.dumps(said), flush=True)


if __name__ == "__main__":
    main()
