from .paper.laws.table import laws

__all__ = ["laws"]
