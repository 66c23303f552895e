from .controllers import pid
from .lags import delay, hold, lag
from .limits import backlash, dead_zone, lookup_table, rate_limit, relay, saturation
from .observers import kalman_filter, noise, observer
from .vehicles import planar_vehicle, point_vehicle, thrusters

__all__ = [
    "backlash",
    "dead_zone",
    "delay",
    "hold",
    "kalman_filter",
    "lag",
    "lookup_table",
    "noise",
    "observer",
    "pid",
    "planar_vehicle",
    "point_vehicle",
    "rate_limit",
    "relay",
    "saturation",
    "thrusters",
]
