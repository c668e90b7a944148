"""Every decision is found in the tables of the index, once, by its own title, with what it says."""

from __future__ import annotations

import re
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "docs/decisions"
ROW = re.compile(r"^\| (\d+) \| \[(.+)\]\((\S+)\) \| (.*) \|$", re.MULTILINE)


def heading(path: Path) -> tuple[int, str]:
    """Return number and title of a page."""
    found = re.match(r"# (\d+)\. (.+)", path.read_text(encoding="utf-8"))
    assert found, f"{path.name} does not begin with its number and title"
    return int(found[1]), found[2]


def faults(index: str, folder: Path) -> list[str]:
    """Return what is wrong with the tables of an index: pages that it lacks, rows that are not a page's."""
    pages = {path.name: heading(path) for path in folder.glob("0*.md")}
    rows = ROW.findall(index)
    named = [name for _, _, name, _ in rows]
    wrong = [
        f"{name}: {named.count(name)} rows" for name in sorted(pages) if named.count(name) != 1
    ]
    for number, title, name, words in rows:
        if pages.get(name) != (int(number), title) or len(words) < 15:
            wrong.append(f"{name}: {number}, {title}, {words}")
    return wrong


def test_every_page_is_in_the_index() -> None:
    assert faults((FOLDER / "index.md").read_text(encoding="utf-8"), FOLDER) == []


def test_numbers_are_those_of_the_files() -> None:
    assert [p.name for p in FOLDER.glob("0*.md") if int(p.name[:4]) != heading(p)[0]] == []


def test_a_page_that_is_missing_and_a_wrong_row_are_found(tmp_path: Path) -> None:
    (tmp_path / "0001-one.md").write_text("# 1. One thing\n", encoding="utf-8")
    (tmp_path / "0002-two.md").write_text("# 2. Another\n", encoding="utf-8")
    row = "| 1 | [One thing]({}) | what it says of one thing |\n"
    assert faults(row.format("0001-one.md"), tmp_path) == ["0002-two.md: 0 rows"]
    both = row.format("0001-one.md") + row.format("0002-two.md")
    assert faults(both, tmp_path) == ["0002-two.md: 1, One thing, what it says of one thing"]
