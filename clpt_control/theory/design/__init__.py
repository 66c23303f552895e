"""Design of waypoint tracks on which the flow parameters are identifiable.

`track_design` has the public functions, `search` the multistart search, and `waypoint_tracks`
the batch simulation of tracks with their limits.
"""
