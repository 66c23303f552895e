from .app.pages.writing import report

__all__ = ["report"]
