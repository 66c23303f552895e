from .native_diagram import NativeDiagram, compile

__all__ = ["NativeDiagram", "compile"]
