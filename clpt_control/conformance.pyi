from .engine.conformance.checks import ConformanceReport, check_block, conformance

__all__ = ["ConformanceReport", "check_block", "conformance"]
