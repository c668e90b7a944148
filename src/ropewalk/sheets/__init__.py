"""The sheet of a job: one scene, what it is, what it carries, and how far its numbers can be trusted."""

from ropewalk.sheets.document import Sheet
from ropewalk.sheets.make import sheet

__all__ = ["Sheet", "sheet"]
