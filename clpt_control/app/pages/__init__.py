"""Pages to send: a run, a team's run, an ensemble or a replay as one HTML file."""
