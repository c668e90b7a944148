"""Ropewalk behind the interfaces of other programs."""
