"""The report page: how verdicts follow from numbers, and what is written."""

from __future__ import annotations

import csv
import math
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from ropewalk.report import (
    CLAIMS,
    Claim,
    Number,
    Outcome,
    Part,
    Verdict,
    claim,
    draw,
    formulas,
    words,
    write_report,
)

GOOD = Number("length", 1.0, 1.0 + 1e-9, "m", 1e-6)
BAD = Number("length", 1.0, 1.1, "m", 1e-6)


def outcome(*parts: Part, note: str = "") -> Outcome:
    figure, ax = draw.axes()
    ax.plot([0.0, 1.0], [0.0, 1.0])
    return Outcome("1 < 2 & more", "theory", parts, figure, "a <caption>", note)


def test_a_number_agrees_within_its_tolerance() -> None:
    assert GOOD.agrees
    assert not BAD.agrees
    assert Number("x", 1.1, 1.0, "m", 0.2, False).agrees
    assert not Number("x", 1.3, 1.0, "m", 0.2, False).agrees
    assert Number("x", 110.0, 100.0, "m", 0.11).agrees
    assert not Number("x", math.nan, 1.0, "m", 1.0).agrees
    assert not Number("x", math.inf, 1.0, "m", 1.0).agrees


@pytest.mark.parametrize(
    ("parts", "verdict"),
    [
        ((Part("a", True, (GOOD,)), Part("b", True)), Verdict.CONFIRMED),
        ((Part("a", True, (GOOD,)), Part("b", False)), Verdict.IN_PART),
        ((Part("a", True, (BAD,)), Part("b", True)), Verdict.IN_PART),
        ((Part("a", True, (BAD,)),), Verdict.REFUTED),
        ((Part("a", False, (GOOD,)),), Verdict.REFUTED),
    ],
)
def test_the_verdict_follows_from_the_parts(parts: tuple[Part, ...], verdict: Verdict) -> None:
    assert outcome(*parts).verdict is verdict


def test_the_registry_has_all_claims_in_order() -> None:
    assert [one.id for one in CLAIMS] == [f"C{i}" for i in range(1, 19)]
    assert len({one.run for one in CLAIMS}) == 18
    assert claim("c8").title == "Better than plain Euler"
    with pytest.raises(KeyError, match="C1 to C18"):
        claim("C19")


@pytest.mark.parametrize(
    ("number", "unit", "text"),
    [
        (0.5, "m", "0.5 m"),
        (0.999, "1", "0.999"),
        (-2.5, "N", "−2.5 N"),
        (1.5e-12, "J", "1.50 × 10⁻¹² J"),
        (0.0, "m", "0 m"),
        (math.nan, "m", "none"),
    ],
)
def test_values_are_written_with_units(number: float, unit: str, text: str) -> None:
    assert words.value(number, unit) == text


def test_formulas_know_the_reference_values() -> None:
    assert formulas.largest_spring(0.05, 0.05, 60.0) == pytest.approx(174.0)
    assert formulas.decay_time(1, 19, 0.05, 0.05) == pytest.approx(81.2, abs=0.05)
    assert formulas.shallow_sag(1e4, 0.05, 1.0, 9.81, 20.0)[1] == pytest.approx(34.23, abs=0.005)
    assert formulas.hanging_stretch(20, 1e4, 0.05, 9.81) == pytest.approx(0.0103005)


class Page(HTMLParser):
    """Checks that every element is closed and collects what the tests ask about."""

    VOID = frozenset({"meta", "img", "br", "hr", "link"})

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.pictures: list[dict[str, str | None]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        if found.get("id"):
            self.ids.append(str(found["id"]))
        if tag == "a":
            self.links.append(str(found["href"]))
        if tag == "img":
            self.pictures.append(found)
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.fixture(scope="module")
def written(
    tmp_path_factory: pytest.TempPathFactory,
) -> tuple[dict[str, Path], list[tuple[int, int, str]]]:
    told: list[tuple[int, int, str]] = []
    made = Claim("C2", "Made up", "a < b | c", "Group", lambda: outcome(Part("b", True, (BAD,))))
    folder = tmp_path_factory.mktemp("report") / "new" / "folder"
    paths = write_report(folder, lambda *at: told.append(at), (claim("C3"), made))
    return paths, told


def test_the_page_is_whole_and_self_contained(
    written: tuple[dict[str, Path], list[tuple[int, int, str]]],
) -> None:
    text = written[0]["html"].read_text(encoding="utf-8")
    page = Page(text)
    assert page.open == []
    assert len(page.ids) == len(set(page.ids))
    assert {link.removeprefix("#") for link in page.links} <= set(page.ids)
    assert len(page.pictures) == 6  # figures 1 to 3, two claims, and the last section
    assert all(str(p["src"]).startswith("data:image/svg+xml;base64,") for p in page.pictures)
    assert all(p["alt"] for p in page.pictures)
    assert not re.search(r'(src|href)="(?!#|data:)', text)
    assert "1 &lt; 2 &amp; more" in text
    assert "1 < 2 & more" not in text


def test_the_page_shows_verdicts_and_disagreement(
    written: tuple[dict[str, Path], list[tuple[int, int, str]]],
) -> None:
    text = written[0]["html"].read_text(encoding="utf-8")
    assert "Of 2 claims: 1 confirmed, 0 confirmed in part, 1 refuted." in text
    assert '<td class="no">no</td>' in text
    assert "numba" in text
    assert re.search(r"Written on \d{4}-\d\d-\d\d", text)


def test_the_markdown_names_files_that_are_there(
    written: tuple[dict[str, Path], list[tuple[int, int, str]]],
) -> None:
    path = written[0]["markdown"]
    text = path.read_text(encoding="utf-8")
    pictures = re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)
    assert len(pictures) == 6
    assert all((path.parent / name).stat().st_size > 1000 for name in pictures)
    assert "a < b \\| c" in text  # a bar would end the cell
    assert "**no**" in text


def test_the_numbers_are_a_table(
    written: tuple[dict[str, Path], list[tuple[int, int, str]]],
) -> None:
    with written[0]["numbers"].open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert {row["claim"] for row in rows} == {"C3", "C2"}
    assert float(rows[0]["measured"]) == pytest.approx(-9.81, rel=1e-12)
    assert rows[-1]["agrees"] == "false"


def test_progress_names_every_claim(
    written: tuple[dict[str, Path], list[tuple[int, int, str]]],
) -> None:
    claims = ["C3 Only gravity at first", "C2 Made up"]
    lines = ["figures 1 to 3", *claims, "10 kN/m at 60 steps a second", ""]
    assert written[1] == [(number, 4, line) for number, line in enumerate(lines)]


def test_a_claim_has_the_same_numbers_and_picture_every_time() -> None:
    first, again = claim("C3").run(), claim("C3").run()
    assert [n.measured for n in first.numbers] == [n.measured for n in again.numbers]
    assert draw.svg(first.figure) == draw.svg(again.figure)
