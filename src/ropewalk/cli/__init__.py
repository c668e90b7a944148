"""The `ropewalk` command."""

from ropewalk.cli.app import main

__all__ = ["main"]
