"""Design of waypoint tracks on which the flow parameters are identifiable."""
