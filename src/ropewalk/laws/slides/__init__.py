"""Nodes that slide along other ropes: a law of nodes. See `sliding`."""
