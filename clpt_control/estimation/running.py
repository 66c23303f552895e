"""A mean that runs with the dives: of the last twenty, after a first guess.

m <- (n m + x) / (n + 1),  n <- min(n + 1, LAST)
"""

FIRST, LAST = 4.0, 20.0  # how many dives a first guess weighs, and the past


class RunningMean:
    """A mean over the last dives.

    Attributes
    ----------
    value : float
        The mean.

    Parameters
    ----------
    guess : float
        Before any dive; it weighs as `FIRST` of them.

    Examples
    --------
    >>> mean = RunningMean(1.0)
    >>> mean.add(6.0)
    >>> mean.value
    2.0
    """

    def __init__(self, guess: float) -> None:
        self.value, self.count = guess, FIRST

    def add(self, seen: float) -> None:
        """Take what the last dive showed."""
        self.value = (self.count * self.value + seen) / (self.count + 1)
        self.count = min(self.count + 1, LAST)
