"""How a run can end, and the sentence that says so."""

from enum import IntEnum


class Status(IntEnum):
    """How a run ended.

    Attributes
    ----------
    sentence : str
        What it means, and what to try.
    """

    sentence: str

    def __new__(cls, value: int, sentence: str) -> "Status":
        """Make a member with its sentence."""
        member = int.__new__(cls, value)
        member._value_, member.sentence = value, sentence
        return member

    RUNNING = 0, "under way"
    FINISHED = 1, "finished: the end of the span was reached"
    TOO_SMALL = 2, "the step became too small; loosen rtol and atol, or look for a singularity"
    NOT_FINITE = 3, "a number is not finite; check parameters and the initial state"
    LEFT = 4, "a guard was left; flow.outside says what happens there"
    TOO_MANY = (
        5,
        "too many steps: the equations are stiff; lower the gains, or loosen rtol and atol",
    )
