"""A glider's dives replayed: `replay_dives`, `next_dive`."""
