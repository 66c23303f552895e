"""Where to drive: waypoints from which most can be learned, within limits."""
