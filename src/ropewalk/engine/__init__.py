"""What steps the ropes of a scene: its islands, how they start, are paused, break and stand still."""
