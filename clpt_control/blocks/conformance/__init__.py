"""Does a block, yours or the package's, do what a block must?

`conformance(block)` raises with every failure in plain sentences; `check_block`
gives them as a report.
"""

from .suite import Report, check_block, conformance

__all__ = ["Report", "check_block", "conformance"]
