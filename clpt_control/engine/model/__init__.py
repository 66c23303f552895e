"""Models: blocks of equations on named ports, and python-control systems as blocks."""
