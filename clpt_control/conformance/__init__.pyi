from .all_readings import readings
from .checks import ConformanceReport, check_block, conformance

__all__ = ["ConformanceReport", "check_block", "conformance", "readings"]
