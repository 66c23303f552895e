from .engine.conformance.checks import ConformanceReport, check

__all__ = ["ConformanceReport", "check"]
