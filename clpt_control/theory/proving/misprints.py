"""The paper's misprints, each with a check that tells print from correction.

A check compares a form with what the blocks give; it is false for the
printed form and true for the corrected one.
"""

from collections.abc import Callable
from dataclasses import dataclass

from . import misprint_checks as check


@dataclass(frozen=True)
class Misprint:
    """One misprint."""

    equation: str  # where it stands in the paper
    printed: str
    corrected: str
    check: str  # what tells them apart
    holds: Callable[[bool], bool]  # holds(printed): whether the check passes on that form

    @property
    def confirmed(self) -> bool:
        """Whether the check fails on the print, passes corrected."""
        try:
            return not self.holds(True) and self.holds(False)
        except Exception:  # equations so changed that the check cannot run
            return False


MISPRINTS = (
    Misprint(
        "(18)",
        "(K - KD)^T (K' + z e)",
        "(K - KD)^T (K'/gamma + z e)",
        "V' of (17) along the loop, K' and Gamma' left free",
        check.equation_18,
    ),
    Misprint(
        "(25)",
        "K' + z e, and (theta + alpha) alpha'",
        "K'/gamma + z e, and (theta + alpha) alpha'/gamma",
        "V' of (24) along the loop, the law left free",
        check.equation_25_gains,
    ),
    Misprint(
        "(25)",
        "-2 e^T alpha_M phi",
        "-e^T [(alpha_M + alpha) phi(x) + (alpha_M - alpha) phi(z)]",
        "V' of (24) along the loop, the injection left free",
        check.equation_25_flow,
    ),
    Misprint(
        "V'' after (26)",
        "... - Psi - 2 alpha_M phi",
        "... - Psi - (alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z)",
        "e' of the loop, the injection left free",
        check.second_derivative,
    ),
    Misprint(
        "(34)",
        "(K - KD)^T (K' + z e)",
        "(K - KD)^T (K'/gamma + z e)",
        "V' of (24) along the loop with Delta, the law left free",
        check.equation_34,
    ),
    Misprint(
        "(27)",
        "x eta_3",
        "z eta_3, as in (28) and (31)",
        "e' of the loop",
        check.equation_27,
    ),
    Misprint(
        "(28), lower rows of A",
        "-gamma phi_1, -gamma phi_2, -gamma z, -gamma zc",
        "-gamma phi_1^T, -gamma phi_2^T, -gamma z^T, -gamma zc^T",
        "A of the error and parameter blocks, N = 2",
        check.equation_28_rows,
    ),
    Misprint(
        "(28), P",
        "blocks K_D^{-1}/2 and K_D^{-1}/(2 gamma)",
        "diag(I, I/gamma)/2",
        "A^T P + P A has no blocks but e e, for KD not a multiple of I (and the printed "
        "blocks fit N = 2 alone)",
        check.equation_28_P,
    ),
    Misprint(
        "L before (30)",
        "L = [KD; gamma W], which removes -KD",
        "L = [0; gamma W]",
        "the first block of A + L C is -KD, as (31) has it",
        check.output_injection,
    ),
    Misprint(
        "(12)-(16), Assumption 3.3",
        "theta where theta_hat is meant",
        "theta_hat in (13), theta - theta_hat in (16)",
        "V' of (17) along the traced known-flow loop",
        check.hats,
    ),
    Misprint(
        "(5)",
        "exp of -|x - c|/(2 sigma), called Gaussian",
        "exp(-|x - c|^2/(2 sigma^2)) is Gaussian; the printed exponent is ambiguous",
        "log phi is quadratic in the distance",
        check.gaussian,
    ),
    Misprint(
        "figures 3 and 4",
        "parameters converge to the true values",
        "alpha converges to -theta; -alpha is plotted",
        "V of (24) has its minimum there",
        check.converges_to,
    ),
    Misprint(
        "proof of 3.2",
        "z is bounded because (8) is linear with sinusoidal inputs",
        "z = x - e, with x bounded by (9) and e by V",
        "dz'/dz of the loop is free of adapting gains; z = x - e",
        check.bounded_z,
    ),
)


def misprints() -> tuple[Misprint, ...]:
    """Return the paper's misprints with their checks.

    Returns
    -------
    tuple of Misprint
        Each with `equation`, `printed`, `corrected`, `check` and `confirmed`, whether the check
        fails on the print and passes on the correction.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = clpt.theory.misprints()[0]
    >>> found.equation, found.holds(True), found.holds(False)
    ('(18)', False, True)
    """
    check.forget()
    return MISPRINTS
