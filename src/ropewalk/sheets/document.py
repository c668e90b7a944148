"""A finished sheet, and how it is written."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.sheets.content import Section, Table, Text
from ropewalk.sheets.html import html_page

if TYPE_CHECKING:
    from ropewalk.record.result import Result

FORMATS = ("html", "pdf")


@dataclass(frozen=True)
class Sheet:
    """All that a sheet says.

    Attributes:
        title: the scene's name.
        lead: a line below it: versions and date.
        sections: what follows, in order.
        result: of the run; of the equilibrium where nothing was run.
    """

    title: str
    lead: str
    sections: tuple[Section, ...]
    result: Result | None = field(default=None, repr=False, compare=False)

    def save(self, path: str | Path) -> Path:
        """Write the sheet as one file, HTML or PDF by its ending, and return its path.

        Raises ValueError for another ending, ImportError for a PDF without `ropewalk[sheet]`, OSError when
        it cannot be written.
        """
        path = Path(path)
        made = self._bytes(format_of(path))
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_name(f".{path.name}.part")
        try:
            part.write_bytes(made)
            os.replace(part, path)
        finally:
            part.unlink(missing_ok=True)
        return path

    def _bytes(self, kind: str) -> bytes:
        if kind == "html":
            return html_page(self.title, self.lead, self.sections).encode("utf-8")
        from ropewalk.sheets.pdf import pdf_pages

        return pdf_pages(self.title, self.lead, self.sections)

    def section(self, title: str) -> Section:
        """Return the section of that title. Raises KeyError when there is none."""
        for one in self.sections:
            if one.title == title:
                return one
        raise KeyError(
            f"no section {title!r}; there is {', '.join(s.title for s in self.sections)}"
        )

    def as_dict(self) -> dict[str, Any]:
        """Return texts, tables and what is said of these for JSON, by section; figures are left out."""
        found: dict[str, Any] = {"title": self.title, "lead": self.lead, "sections": {}}
        for one in self.sections:
            texts = [item.words for item in one.items if isinstance(item, Text)]
            tables = [_plain(item) for item in one.items if isinstance(item, Table)]
            notes = [item.note for item in one.items if isinstance(item, Table) and item.note]
            found["sections"][one.title] = {"texts": texts, "tables": tables, "notes": notes}
        return found

    def _repr_html_(self) -> str:
        return html_page(self.title, self.lead, self.sections, whole=False)


def _plain(table: Table) -> Any:
    """Return a table as a mapping from first to second column; with more, or two alike, as a list of rows.

    Whose a mapping is, the head of its first column, is its "what".
    """
    if len(table.head) == 2 and len({row[0] for row in table.rows}) == len(table.rows):
        whose = {"what": table.head[0]} if table.head[0] else {}
        return whose | {row[0]: row[1] for row in table.rows}
    heads = [head or "what" for head in table.head]
    return [dict(zip(heads, row, strict=True)) for row in table.rows]


def format_of(path: Path) -> str:
    """Return "html" or "pdf" by a path's ending. Raises ValueError for another one."""
    kind = path.suffix.lower().removeprefix(".")
    if kind not in FORMATS:
        raise ValueError(f"{path}: {path.suffix!r} - must end in .html or .pdf")
    return kind
