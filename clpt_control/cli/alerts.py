"""A command of the user's own that is run when something asks for a pilot (`replay.fleet`).

It is run without a shell.  `{}` in its words is the sentence; its standard input has the sentence
on the first line, and on the second one JSON object: vehicle, event, dive, sentence, next_dive.
It is run once for each event: what was told is kept beside the state of the folder that is
followed.  One that fails or lasts too long is one sentence, and is run again at the next look.
"""

import json
import shlex
import shutil
import subprocess
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from ..errors import DataError, ScenarioError
from ..files import write_text
from ..files.reading import read_text
from ..progress import tell

LONGEST = 60.0  # s that a command may take
TOLD = ".clpt-told"  # in the state


def checked_command(text: str) -> list[str]:
    """Return the words of a command, or refuse what cannot be run."""
    try:
        words = shlex.split(text)
    except ValueError as error:
        raise ScenarioError(f"--alert {text}: {str(error).lower()}") from None
    if not words or shutil.which(words[0]) is None:
        raise ScenarioError(f"--alert {text}: no such command; give one that can be run")
    return words


class Alerts:
    """Runs a command, or none, once for each event; `out` has the state of the followed folder."""

    def __init__(self, command: Sequence[str], out: Path) -> None:
        self.command, self.path = list(command), out / "state" / TOLD
        self.told: list[str] = []
        self.failed: set[str] = set()
        with suppress(DataError, ValueError):  # none yet, or none that can be read: told again
            told = json.loads(read_text(self.path, "is no text"))
            self.told = [str(one) for one in told] if isinstance(told, list) else []

    def tell(self, found: dict[str, Any]) -> None:
        """Run the command for what is new in what `--json` prints of a vehicle."""
        from ..replay.fleet import events

        if not (self.command and found["each_dive"]):
            return
        vehicle = found["vehicle"]
        for event in events(found, time.time()):
            key = f"{vehicle} {event.name} {event.dive}"
            if key in self.told:
                continue
            said = f"{vehicle}: {event.said}"
            told = {"vehicle": vehicle, "event": event.name, "dive": event.dive, "sentence": said}
            why = self._run(said, json.dumps(told | {"next_dive": found["next_dive"]}))
            if not why:
                self.told.append(key)
                write_text(self.path, json.dumps(self.told))
            elif why not in self.failed:
                self.failed.add(why)
                tell(f"--alert {shlex.join(self.command)}: {why}; is run again at the next look")

    def _run(self, said: str, data: str) -> str:
        """Run the command; return why it failed, empty where it did not."""
        words = [said if word == "{}" else word for word in self.command]
        try:
            done = subprocess.run(
                words, input=f"{said}\n{data}\n", text=True, capture_output=True, timeout=LONGEST
            )
        except subprocess.TimeoutExpired:
            return f"takes longer than {LONGEST:g} s"
        except OSError as error:
            return f"cannot be run: {error.strerror or error}"
        last = "".join(done.stderr.strip().splitlines()[-1:])
        return f"ended with status {done.returncode}: {last}" if done.returncode else ""
