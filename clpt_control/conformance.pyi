from .engine.conformance.all_backends import readings
from .engine.conformance.checks import ConformanceReport, check_block, conformance

__all__ = ["ConformanceReport", "check_block", "conformance", "readings"]
