"""A scene's text on paper: lines that are too long for it are broken where TOML allows that."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator

_TEXT = re.compile(r'(?P<key>(?:[^"=]+ = )?\s*)"(?P<text>(?:[^"\\]|\\.)*)"(?P<end>,?)')
_MARK = re.compile(r'"(?:[^"\\]|\\.)*"|[\[\]{}]|, ')  # a text, a bracket, a comma
_SAME = "Long lines are broken as TOML allows: the scene is the same, the SHA-256 that without the breaks."
_OTHER = (
    "Long lines are broken for paper: copied from here this is not the scene. "
    "The sheet as HTML has it whole."
)


def on_paper(text: str, width: int) -> tuple[str, str]:
    """Return a TOML text with lines of at most `width` letters where that can be, and a note on them.

    Arrays are broken after commas, and texts in quotes after spaces; "" for a note where nothing is broken.
    """
    lines = text.split("\n")
    if max(map(len, lines)) <= width:
        return text, ""
    broken = "\n".join(_broken(line, width) if len(line) > width else line for line in lines)
    try:
        same = tomllib.loads(broken) == tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        same = False
    fits = max(map(len, broken.split("\n"))) <= width
    return broken, _SAME if same and fits else _OTHER


def _broken(line: str, width: int) -> str:
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    quoted = _TEXT.fullmatch(line)
    if quoted:
        words = re.findall(r"(?:[^ \\]|\\.)+ *| +", quoted["text"])
        rows, row = [], f'{quoted["key"]}"""'
        for word in words:
            if len(row) + len(word) > width - 5:  # room for a backslash, or the end
                rows.append(f"{row}\\")
                row = indent
            row += word
        return "\n".join([*rows, f'{row}"""{quoted["end"]}'])
    rows, row = [], ""
    for piece in _pieces(line):
        if row.strip() and len(row) + len(piece.rstrip()) > width:
            rows.append(row.rstrip())
            row = indent
        row += piece
    return "\n".join([*rows, row])


def _pieces(line: str) -> Iterator[str]:
    """Yield the pieces between which a line may be broken: after commas of arrays, not of texts or tables."""
    inside, start = "", 0
    for found in _MARK.finditer(line):
        if found[0] in "[{":
            inside += found[0]
        elif found[0] in "]}":
            inside = inside[:-1]
        elif found[0] == ", " and not inside.endswith("{"):
            yield line[start : found.end()]
            start = found.end()
    yield line[start:]
