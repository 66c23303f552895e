from .engine.solver.native_diagram import NativeDiagram, compile

__all__ = ["NativeDiagram", "compile"]
