"""A verdict as data: a status, a conclusion with the steps that it requires, and conditions.

The sentence is made from the fields.  A verdict has all conclusions whose requirements are shown by
steps that hold, and what these imply, in the order of `CONCLUSIONS`.  The sentence says the first;
code asks `verdict.implies("comes to rest")`.

    square-integrable       V' <= -q^2 and V >= 0            =>  int q^2 dt <= V(0)
    goes to zero            and q' is bounded where V is     =>  q -> 0 (Barbalat)
    all rates go to zero    where q = 0 for good all rates are zero (LaSalle)
    comes to rest           and the points at which they are zero stand alone
    ultimately bounded      V' <= -rate V + push             =>  V <= push/rate in the end
                            or V' < 0 above a level
"""

from collections.abc import Iterable
from dataclasses import dataclass, field, fields, replace
from typing import Any, Literal, NamedTuple

from sympy import Expr

from ...base.errors import ArgumentError
from ..algebra.texts import bound_text, cut, outward
from .statements import Statement, joined, said
from .steps import Step

Status = Literal["proved", "refuted", "open"]

LONGEST_SENTENCE = 300  # letters
LONGEST_BOUND = 60


class Conclusion(NamedTuple):
    """A row of the table of conclusions."""

    sentence: str  # of the fields of a verdict
    requires: frozenset[str]  # of `Step.shows`
    to_do: str  # by the reader, to use it or to show more
    implies: tuple[str, ...] = ()  # conclusions beside those that require less
    is_of_loss: bool = False  # whether it is about the most that V may lose


REQUIREMENTS = {  # what a step shows, `Step.shows` -> in words
    "values": "V and the equations have a value everywhere",
    "running": "the running blocks have the same V'",
    "definite": "V is positive definite in some forms",
    "all": "in all states",
    "falls": "V' <= 0",
    "loses": "V' <= -q^2",
    "limit": "the rate of q is bounded where V is (Barbalat)",
    "rates": "rates of what goes to zero do so too (Barbalat)",
    "rest": "V' < 0 but at the rest, or nothing else stays where V' = 0 (LaSalle)",
    "still": "where V' = 0 for good nothing moves (LaSalle)",
    "isolated": "rests stand alone, or each run comes to one",
    "pulled": "V' < 0 above a level",
    "ceiling": "V' <= 0 where V >= level",
    "mean": "V' <= -q^2/2 + c",
    "zone": "V' <= 0, and < 0 where e is outside a zone",
    "decays": "V' <= -k V, V of one power",
    "region": "V' < 0 in a box where V is below a level (`within=`)",
    "jumps": "V rises at no jump",
    "exists": "runs exist for all t",
    "fixes": "V changes at fixes by a known error at most",
    "claimed": "V' is at most the `claim`",
}


def _needs(text: str) -> frozenset[str]:
    names = frozenset(("values", "running", *text.split()))
    assert names <= REQUIREMENTS.keys()
    return names


CONCLUSIONS = {
    "asymptotically stable in a region": Conclusion(
        "so what begins there comes to rest",
        _needs("region exists"),
        "start below `level`",
    ),
    "comes to a zone": Conclusion(
        "V never rises, and {of}",
        _needs("definite zone limit jumps exists"),
        "a smaller zone needs a smaller disturbance",
    ),
    "exponentially stable": Conclusion(
        "so the rest is exponentially stable from every start, V <= {decay}",
        _needs("definite all falls rest decays jumps exists"),
        "`decay` bounds V",
    ),
    "asymptotically stable": Conclusion(
        "so the rest is asymptotically stable from every start",
        _needs("definite all falls rest jumps exists"),
        "to show a rate k, give `claim=lambda s: -k * V(s)`",
        ("comes to rest", "goes to zero"),
    ),
    "comes to rest": Conclusion(
        "so every run comes to rest and {of} to zero",
        _needs("definite falls still isolated jumps exists"),
        "several rests may be left: `within=` for the region of one",
    ),
    "all rates go to zero": Conclusion(
        "so {of} to zero, and all rates do",
        _needs("definite falls still jumps exists"),
        "a run may drift for ever along a line of rests",
        ("goes to zero",),
    ),
    "goes to zero": Conclusion(
        "so {of} to zero",
        _needs("definite falls loses limit jumps exists"),
        "what else converges needs excitation (`clpt.gramian`)",
    ),
    "ultimately bounded": Conclusion(
        "so V comes down to {bound}",
        _needs("definite pulled jumps exists"),
        "`level` is V of the set that is reached",
    ),
    "bounded": Conclusion(
        "so V stays below {level} where it begins below",
        _needs("definite ceiling jumps exists"),
        "start below `level`",
    ),
    "bounded in the mean": Conclusion(
        "in the mean {bound}",
        _needs("definite mean jumps exists"),
        "V may grow without end: a leak or a projection bounds it",
    ),
    "square-integrable": Conclusion(
        "so the integral of {bound} is at most {of}",
        _needs("definite falls loses jumps"),
        "a step says which signal keeps the rate from being bounded: bound it, or put it in V",
        is_of_loss=True,
    ),
    "stable": Conclusion(
        "so the rest is stable",
        _needs("definite all falls jumps exists"),
        "give a V, or a `claim`, whose loss is a sum of squares",
    ),
    "V does not increase": Conclusion(
        "so V does not increase",
        _needs("definite falls"),
        "give a V that holds the other states",
    ),
    "bounded by its fixes": Conclusion(
        "so 2 V stays below `B`, which grows by {bound} at a fix",
        _needs("definite fixes"),
        "`clpt excitation --bounds` computes B",
    ),
    "V' is at most the claim": Conclusion(
        "as claimed", _needs("claimed"), "without a `claim` V' <= 0 is judged"
    ),
}

CONDITIONS = {  # name -> sentence
    "t >= 0": "for t >= 0",
    "zero inputs": "where {} = 0",
    "bounded inputs": "where {} bounded",
    "input bounds": "where {}",
    "existence": "as long as runs of {} exist",
    "outside V, bounded": "{} not held by V, and bounded",
    "outside V": "{} not held by V, and not known to be bounded",
    "N": "for {}",
    "approximation": "of {}",
    "steps": "with V' the change of V in a step",
    "graphs": "on graphs of {}",
    "signs": "where {}",
    "between": "where {}",
    "values": "with the parameters' values {}",
    "rounding": "to the rounding of numbers",
    "start": "where {} at the start",
    "truth": "where {}",
    "slower flow": "where the flow stays slower than the vehicle (hedging)",
    "reads the truth": "the law reads {}, which no vehicle measures by itself",
    "limits": "within limits of noise, unmodelled flow and shear",
}


@dataclass(frozen=True)
class Condition:
    """A condition of a verdict: its name in `CONDITIONS`, and of what."""

    name: str
    of: str = ""

    @property
    def statement(self) -> Statement:
        """The condition in words and expressions."""
        return said(CONDITIONS[self.name].replace("{}", "{of}"), of=self.of)

    def __str__(self) -> str:
        return self.statement.strip()


def signs_of(symbols: Iterable[Any]) -> Statement:
    """Return the signs that symbols have: "a, b > 0 and c < 0"."""
    chosen = sorted(symbols, key=str)
    above = [s for s in chosen if s.is_positive]
    below = [s for s in chosen if s.is_negative]
    known = (("{} > 0", above), ("{} < 0", below))
    return joined(" and ", (said(sign, joined(", ", of)) for sign, of in known if of))


def for_sizes(sizes: Iterable[int]) -> Condition:
    """Return the condition of some numbers of basis functions: N = 1, 2."""
    return Condition("N", "N = " + ", ".join(map(str, sizes)))


@dataclass(frozen=True)
class Judged:
    """Verdict on a law, a team or a V: fields, and the sentence made of them.

    Attributes
    ----------
    status : str
        ``"proved"``, ``"refuted"`` or ``"open"``.
    claim : str
        What is shown of V', or where it fails, or which step is missing.
    conclusions : tuple of str
        Rows of `CONCLUSIONS` that follow from the steps, the strongest first; none unless proved.
    of : str
        What the conclusion is about: "CLPE goes", "y - ym goes".
    bound : str
        Of what the integral or the mean is bounded.
    conditions : tuple of Condition
        Where the conclusion holds.
    steps : tuple of Step
        What was tried, and how.
    level : sympy.Expr, float or None
        V of the set that is reached, or below which a run comes to rest.
    decay : sympy.Expr or None
        V(0) e^(-k t), which V stays below if V' <= -k V.
    for_every_N : bool
        Whether it is proved for every number of basis functions.
    """

    status: Status
    claim: str
    conclusions: tuple[str, ...] = field(default=(), kw_only=True)
    of: str = field(default="", kw_only=True)
    bound: str = field(default="", kw_only=True)
    conditions: tuple[Condition, ...] = field(default=(), kw_only=True)
    steps: tuple[Step, ...] = field(default=(), kw_only=True)
    level: Any = field(default=None, kw_only=True)
    decay: Expr | None = field(default=None, kw_only=True)
    for_every_N: bool = field(default=False, kw_only=True)

    def __bool__(self) -> bool:
        raise ArgumentError(
            "a verdict is no truth value. Ask verdict.status == 'proved'"
        )

    @property
    def conclusion(self) -> str:
        """The strongest conclusion; "" unless proved."""
        return next(iter(self.conclusions), "")

    def implies(self, conclusion: str) -> bool:
        """Return whether a row of `CONCLUSIONS` follows from what is proved."""
        return conclusion in self.conclusions

    @property
    def follows(self) -> Statement:
        """The strongest conclusion and its data, in words and expressions."""
        level = self.level
        if level is not None and not isinstance(level, str):
            level = outward(level)
        data = {"of": self.of, "bound": self.bound or level, "decay": self.decay}
        return said(CONCLUSIONS[self.conclusion].sentence, level=level, **data)

    @property
    def shown(self) -> str:
        """The claim and the conclusion, without the conditions."""
        return self._shown(LONGEST_SENTENCE)

    def _shown(self, most: int) -> str:
        if not self.conclusion:
            return cut(self.claim, most)
        level = self.level
        if level is not None and not isinstance(level, str):
            level = bound_text(level)
        level = level and cut(level, LONGEST_BOUND)
        follows = replace(
            self, level=level, bound=cut(self.bound, LONGEST_BOUND)
        ).follows
        claim = cut(self.claim, most - len(follows) - 2)
        return ", ".join(filter(None, (claim, follows)))

    @property
    def sentence(self) -> str:
        """The verdict in a sentence: what is shown, what follows, and where."""
        where = cut("; ".join(map(str, self.conditions)), LONGEST_SENTENCE // 2)
        claim = self._shown(LONGEST_SENTENCE - len(where) - 2)
        return "; ".join(filter(None, (claim, where)))

    @property
    def statement(self) -> Statement:
        """The sentence without cuts, with its expressions."""
        follows = [self.follows] if self.conclusion else []
        shown = joined(", ", filter(None, [self.claim, *follows]))
        parts = shown, *(condition.statement for condition in self.conditions)
        return joined("; ", filter(None, parts))

    @property
    def judged(self) -> dict[str, Any]:
        """The fields that every verdict has, by name."""
        return {f.name: getattr(self, f.name) for f in fields(Judged)}

    @property
    def failed(self) -> tuple[Step, ...]:
        """The steps that do not hold, and that the conclusion needs."""
        return tuple(step for step in self.steps if step.needed and not step.holds)


def concluded(steps: Iterable[Step], given: str = "") -> tuple[str, ...]:
    """Return the conclusions whose requirements are given or shown by steps, and those implied."""
    shows = [step.shows for step in steps if step.holds]
    available = {*" ".join([given, *shows]).split()}
    follow = [name for name, row in CONCLUSIONS.items() if row.requires <= available]
    for name in follow:
        follow += {*CONCLUSIONS[name].implies}.difference(follow)
    return tuple(filter(follow.__contains__, CONCLUSIONS))


def strength(judged: Judged) -> int:
    """Return the place in the table of the strongest conclusion that needs no rate of V.

    For a rate of its fall a V is not judged with numbers for parameters.
    """
    names = (c for c in judged.conclusions if "decays" not in CONCLUSIONS[c].requires)
    return [*CONCLUSIONS, ""].index(next(names, ""))
