"""Contact of ropes with each other and with themselves: a law of pairs of segments. See `law`."""
