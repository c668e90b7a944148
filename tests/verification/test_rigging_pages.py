"""Each preset of rigging has a how-to with all its parts, whose numbers a run and a rest still give."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import ropewalk as rw
from ropewalk.scene.overrides import apply_overrides
from ropewalk.scene.presets import preset

PAGE = Path(__file__).resolve().parents[2] / "docs/how-to/rigging.md"
PRESETS = (
    *("zip-line", "highline", "hoist-stop", "climbing-fall", "rescue-lower", "tow"),
    *("crane-snap", "guyed-mast", "suspension-cable", "power-line-in-wind"),
)
PARTS = ("Question", "Result", "Your own job", "Not covered", "To check")
QUOTED = re.compile(r"(largest tension|largest anchor force|lowest point) (−?[\d.]+) (kN|m)\b")
AT_REST = re.compile(r"At rest(?: in that wind)? ([\d.]+) kN")
CHANGED = re.compile(
    r"((?:`--set [^`]+`(?: and )?)+)(?:[^`;\n]*?(?::| gives))? [^`;\n]*?([\d.]+) kN"
)
FACTORS = {"kN": 1e3, "m": 1.0}


def sections() -> dict[str, str]:
    """Return the page's sections by the preset that their one block of commands runs."""
    found = {}
    for text in PAGE.read_text(encoding="utf-8").split("\n## ")[1:]:
        runs = re.findall(r"```bash\nropewalk run ([\w-]+)\n```", text)
        assert len(runs) == 1, text
        found[runs[0]] = text
    return found


def part(text: str, name: str) -> str:
    """Return a part of a section."""
    match = re.search(rf"^\*{name}\*: (.+)$", text, re.MULTILINE)
    assert match, f"no {name}: {text}"
    return match[1]


def rounding(number: str) -> float:
    """Return half of a number's last digit, and a little for sums in another order."""
    return 0.51 * 10.0 ** -len(number.partition(".")[2])


def test_every_preset_has_its_section() -> None:
    assert tuple(sections()) == PRESETS


@pytest.mark.parametrize("name", PRESETS)
def test_a_section_has_all_parts(name: str) -> None:
    text = sections()[name]
    assert re.findall(r"^\*([\w ]+)\*: ", text, re.MULTILINE) == list(PARTS)
    assert part(text, "Question").endswith("?")
    assert "`--set" in part(text, "Your own job")
    assert all(len(part(text, which)) > 40 for which in PARTS)


@pytest.mark.parametrize("name", PRESETS)
def test_quoted_results_hold(name: str) -> None:
    told = part(sections()[name], "Result")
    quoted = QUOTED.findall(told)
    assert {"largest tension", "largest anchor force"} <= {row[0] for row in quoted}
    table = rw.simulate(preset(name)).table
    for row, number, unit in quoted:
        key = f"{row} [{'N' if unit == 'kN' else 'm'}]"
        value = float(number.replace("−", "-"))
        assert table[key] / FACTORS[unit] == pytest.approx(value, abs=rounding(number)), row
    for number in AT_REST.findall(told):
        rest = rw.equilibrium(preset(name)).table["largest tension [N]"] / 1e3
        assert rest == pytest.approx(float(number), abs=rounding(number))


def variants() -> list[tuple[str, list[str], str]]:
    """Return the presets that the page changes, with what it sets and the largest tension it tells [kN]."""
    return [
        (name, [one.strip('"') for one in re.findall(r"`--set ([^`]+)`", changes)], number)
        for name, text in sections().items()
        for changes, number in CHANGED.findall(text)
    ]


def test_all_variants_with_a_result_are_found() -> None:
    assert sorted(name for name, _, _ in variants()) == sorted(
        [*("highline", "hoist-stop", "climbing-fall", "crane-snap"), *2 * ("rescue-lower",)]
        + 3 * ["tow", "power-line-in-wind"]
    )


@pytest.mark.parametrize(("name", "changes", "number"), variants())
def test_quoted_results_of_variants_hold(name: str, changes: list[str], number: str) -> None:
    result = rw.simulate(apply_overrides(preset(name), changes))
    found = result.table["largest tension [N]"] / 1e3
    assert found == pytest.approx(float(number), abs=rounding(number))


def test_the_stiff_webbing_has_the_pretension_that_is_told() -> None:
    """Without a walker to speak of, at the same length."""
    told = re.search(r"([\d.]+) times the pretension", part(sections()["highline"], "Your own job"))
    assert told
    soft, stiff = (
        rw.equilibrium(
            apply_overrides(
                preset("highline"), [f"rope.made_of.library={webbing}", "rope.load.mass=0.001"]
            )
        ).table["largest tension [N]"]
        for webbing in ("webbing-soft", "webbing-stiff")
    )
    assert stiff / soft == pytest.approx(float(told[1]), abs=rounding(told[1]))
