"""The command `clpt`.

Results go to standard output, progress and complaints to standard error.  Exit
status 0 is done, 1 a run that failed, 2 a user's mistake, 130 an interrupt;
each failure is one sentence.  Commands import what they need when they run, so
that `clpt --help` answers at once.
"""

import errno
import gc
import io
import logging
import os
import signal
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...base.errors import ClptError, SimulationError
from ...base.progress import discard, interrupt, tell

if TYPE_CHECKING:
    import typer

OUTPUT = {  # what can be wrong with standard output
    errno.ENOSPC: "no space left. Give it a place with more",
    errno.EBADF: "is closed. Give it a file or a terminal",
    errno.EFBIG: "may not become larger; allow more (ulimit -f)",
}
COMPLETES = "_CLPT_COMPLETE"  # set by a shell that asks how a word may go on
LONGEST = 1200  # letters of a sentence; longer ones lose their middle


def main(before: Any = signal.default_int_handler) -> None:
    """Run the command line; a failure is a sentence and a status.

    Interrupts are taken from the handler `before`.
    """
    _stand_in()
    interrupt.listen(before)
    gc.set_threshold(200_000, 50, 50)  # imports make many objects that stay
    warnings.showwarning = lambda *_: None  # commands print sentences, no warnings
    if isinstance(sys.stdout, io.TextIOWrapper):
        # names of files hold any bytes
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        status = _run()
        sys.stdout.flush()
    except (KeyboardInterrupt, SystemExit, Exception) as error:
        status = _answer(error)
    interrupt.end()
    if interrupt.pending():
        status = 130
    if status == 130:
        interrupt.say()
    gc.freeze()  # else the end looks at each object again, which takes up to a second
    sys.exit(status)


def _stand_in() -> None:
    """Open nothing in place of standard streams that are closed: no file may get their number."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # gets the lowest number
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w")  # noqa: SIM115


def _run() -> int:
    if sys.stdout is None:
        raise OSError(errno.EBADF, "standard output")
    logging.disable()  # commands print sentences, no logs
    words = sys.argv[1:] or ["--help"]  # `clpt` alone prints its page
    status = application()(args=words, standalone_mode=False, prog_name="clpt")
    return status if isinstance(status, int) else 0


def application() -> "typer.Typer":
    """Return the command line with all its commands."""
    import typer

    from .estimate import estimate
    from .laws_and_proofs import laws, prove, verify
    from .measurements import fit
    from .printing import Command, HelpPage, clpt, help_of
    from .replay import replay, watch
    from .runs import ensemble, export, init, paper, report, run, tune
    from .tracks import excitation

    app = typer.Typer(
        name="clpt",
        cls=HelpPage,
        context_settings={"help_option_names": ["-h", "--help"]},
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
    )
    app.callback(help=help_of(clpt))(clpt)
    groups = {  # in the order of a user's day
        "Simulation": (paper, init, run, ensemble, report, export),
        "Adaptive laws": (laws, prove, verify, excitation, tune),
        "Ocean data": (fit, estimate, replay, watch),
    }
    for title, commands in groups.items():
        for command in commands:
            app.command(cls=Command, help=help_of(command), rich_help_panel=title)(
                command
            )
    return app


def _answer(error: BaseException) -> int:
    """Print in one line what went wrong; return the status."""
    if interrupt.pending() or _interrupted(error):
        # an interrupted import raises anything
        return 130
    if isinstance(error, SimulationError):
        return _complain(str(error), 1)
    if isinstance(error, ClptError):
        return _complain(str(error), 2)
    if isinstance(error, SystemExit) and COMPLETES in os.environ:
        # fish reads the status
        return error.code if isinstance(error.code, int) else 0
    if isinstance(error, BrokenPipeError | SystemExit):
        # the reader of a page of help went away
        discard(sys.stdout)
        return 0
    if isinstance(error, MemoryError):
        return _complain(
            "out of memory. Take fewer samples, members, files or places at once", 1
        )
    if isinstance(error, OSError) and error.errno in OUTPUT and error.filename is None:
        if sys.stdout is not None:
            discard(sys.stdout)
        return _complain(f"standard output: {OUTPUT[error.errno]}", 2)
    if isinstance(error, OSError) and error.errno in (errno.EMFILE, errno.ENFILE):
        return _complain("too many files are open at once; allow more (ulimit -n)", 1)
    backend = os.environ.get("MPLBACKEND")
    if backend and isinstance(error, ValueError) and "Key backend" in str(error):
        sentence = f"MPLBACKEND = {backend!r:.40}: is not a backend of matplotlib. "
        return _complain(f"{sentence}Unset it, or set it to agg", 2)
    import typer

    if isinstance(error, typer.Abort):
        return 130
    if isinstance(error, typer.TyperException):
        return _complain(_usage(error), 2)
    if os.environ.get("CLPT_TRACEBACK"):
        raise error
    kind = type(error).__name__
    return _complain(f"fault in clpt: {kind}: {error}; CLPT_TRACEBACK=1 shows where", 1)


def _usage(error: Any) -> str:
    """Return what is wrong with the words of a command, and what to try."""
    fault = error.format_message().rstrip(".")
    for suggestion in (". Did you mean ", " (Possible options: "):
        if suggestion in fault:
            return fault.replace(suggestion, "; did you mean ").rstrip(")?") + "?"
    command = getattr(
        getattr(error, "ctx", None), "command_path", f"clpt {sys.argv[1]}"
    )
    return f"{fault}; `{command} --help` shows what it takes"


def _interrupted(error: BaseException | None) -> bool:
    """Return whether an interrupt is behind an error."""
    while error is not None:
        if isinstance(error, KeyboardInterrupt):
            return True
        error = error.__cause__ or error.__context__
    return False


def _complain(sentence: str, status: int) -> int:
    if interrupt.resume_hint:
        sentence = f"{sentence}; {interrupt.resume_hint}"
    line = " ".join(sentence.split()).encode(errors="backslashreplace").decode()
    if len(line) > LONGEST:
        line = f"{line[: LONGEST // 2]} ... {line[-LONGEST // 2 :]}"
    tell(f"clpt: {line}")
    return status
