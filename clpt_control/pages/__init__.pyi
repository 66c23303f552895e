from .making import report

__all__ = ["report"]
