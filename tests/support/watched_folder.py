"""`clpt watch` of a folder that changes between its looks."""

import json
import time

EVERY = 10.0  # s between looks


def watched(clpt, monkeypatch, folder, changes, *words):
    """Watch a folder, with a change before each further look; return what is found and told.

    The clock moves by waits alone; patience ends five looks after the last change.
    """
    now, ahead = [0.0], list(changes)

    def sleep(seconds):
        now[0] += seconds
        done = len(changes) - len(ahead)
        if ahead and now[0] > EVERY * (done + 0.5):
            ahead.pop(0)()

    with monkeypatch.context() as patch:
        patch.setattr(time, "monotonic", lambda: now[0])
        patch.setattr(time, "sleep", sleep)
        patience = EVERY * (len(changes) + 5)
        pace = "--every", EVERY, "--patience", patience
        done = clpt("watch", folder, *pace, "--json", *words)
    assert done.status == 0, done.err
    return json.loads(done.out), done.err
