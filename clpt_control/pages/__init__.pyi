from .writing import report

__all__ = ["report"]
