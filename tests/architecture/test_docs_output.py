"""What pages show of what `settle` and `modes` print is what they print."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from ropewalk.cli import main

ROOT = Path(__file__).resolve().parents[2]
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]\d+)?(?![\w.]*\w)")
#: Page, the text block with these words, and the command; a scene is the page's with these words.
SAMPLES = [
    ("settle", "R4: three anchors: at rest", ["settle", "r4"], ""),
    ("modes", "R4: three anchors: modes", ["modes", "r4"], ""),
    ("settle", "of rope 'falling'", ["settle", "crossing"], ""),
    ("settle", "slide 'trolley' rests", ["settle", "zip-line-ride"], ""),
    ("obstacles", "lie on 'drum'", ["settle", "scene.toml"], 'name = "drum"'),
]


def block(page: str, language: str, words: str) -> str:
    """Return the first block of a how-to in this language that has these words."""
    text = (ROOT / f"docs/how-to/{page}.md").read_text(encoding="utf-8")
    found: list[str] = re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    return next(body for body in found if words in body)


def pieces(text: str) -> tuple[str, list[float]]:
    """Return a text without its numbers, in even spaces, and the numbers, rounding's as 0."""
    numbers = [float(number) for number in NUMBER.findall(text)]
    return " ".join(NUMBER.sub("#", text).split()), [x if abs(x) > 1e-9 else 0.0 for x in numbers]


def is_in(shown: str, printed: str) -> bool:
    """Tell whether the shown lines, of which some may be left out, are in what is printed, to 1 %."""
    lines = [pieces(line) for line in printed.splitlines()]
    for line in shown.splitlines():
        words, numbers = pieces(line)
        if not any(
            words in there and any(near(numbers, found[i:]) for i in range(len(found) + 1))
            for there, found in lines
        ):
            return False
    return True


def near(numbers: list[float], others: list[float]) -> bool:
    """Tell whether the others begin with the numbers, to 1 %."""
    return len(others) >= len(numbers) and others[: len(numbers)] == pytest.approx(
        numbers, rel=0.01
    )


@pytest.mark.parametrize(("page", "words", "command", "scene"), SAMPLES)
def test_a_page_shows_what_is_printed(
    page: str,
    words: str,
    command: list[str],
    scene: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The drum's page said 3.922 N and 1.492 N, where 3.986 N and 1.499 N were printed."""
    monkeypatch.chdir(tmp_path)
    if scene:
        (tmp_path / "scene.toml").write_text(block(page, "toml", scene), encoding="utf-8")
    done = CliRunner().invoke(main, command, env={"COLUMNS": "200"})
    assert done.exit_code == 0, done.output
    shown = block(page, "text", words)
    assert is_in(shown, done.output), f"{shown}\n{done.output}"


def test_other_numbers_and_words_are_seen() -> None:
    printed = "a\n holds 3.986 N in segment 0,  left 2e-14\nb 5"
    assert is_in("holds 3.99 N in segment 0, left 3e-12\nb 5", printed)
    for other in (
        "holds 3.922 N in segment 0",
        "holds 3.986 N in segment 19",
        "held 3.986 N",
        "b 0",
    ):
        assert not is_in(other, printed)
