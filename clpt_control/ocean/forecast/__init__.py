"""A glider's dives replayed: `replay_dives`, `Replay.next_dive`."""
