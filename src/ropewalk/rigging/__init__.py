"""Lines set up by what one knows of them, and loads that roll along them, at rest."""

from ropewalk.rigging.lines import Line, line
from ropewalk.rigging.rolling import Rolling

__all__ = ["Line", "Rolling", "line"]
