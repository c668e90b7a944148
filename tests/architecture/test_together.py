"""What the docs say cannot go together is what is refused, in words; and nothing else is."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from ropewalk.lowering import build
from ropewalk.methods.registry import METHODS
from ropewalk.scene import SceneError, apply_overrides
from ropewalk.simulation import Simulation
from verification.feature_pairs import scene_of
from verification.test_pairs import APART, OF_METHODS

ROOT = Path(__file__).parents[2]
#: How the page names the features of `feature_pairs`.
NAMES = {
    "rigid links": "rigid links",
    "stretch limiter": "limiter",
    "contact of ropes": "contact",
    "obstacles": "obstacle",
    "winch": "winch",
    "bending": "bending",
    "clamp": "clamp",
    "joint": "joint",
    "a curve": "curve",
    "relaxation": "relaxation",
    "ropes that part": "parting",
    "slide": "slide",
}
POINTS = 'rope.made_of={kind="springs", spring_constant=50.0, node_mass=0.1, segment_length=0.0}'
NO_LENGTH = (POINTS, "rope.length=none", 'rope.shape={kind="straight", end=[0.9, 0.0, 0.0]}')
SOLID = "rope.made_of.tension_only=true", "rope.made_of.axial_damping=0.1"
CURLED = "rope.made_of.EI=0.02", "rope.made_of.curvature=[0, 2, 0]"
#: The rows of the first table that name fields: a feature, the fields, words of the refusal.
OF_FIELDS = {
    "winch and a natural curvature (`curvature`)": [
        ("winch", CURLED, "curved by itself (curvature), with which a winch cannot wind it")
    ],
    "relaxation, `tension_only` and `axial_damping`, all three": [
        ("relaxation", SOLID, "the loss of such a rope is its relaxation")
    ],
    "winch and `submerged_weight` on one rope": [
        ("winch", ("rope.submerged_weight=0.1",), "a rope on a winch cannot have it")
    ],
    "winch, or `[limiter]`, and springs of no length": [
        ("winch", NO_LENGTH, "has springs of no length, which a winch cannot change"),
        ("limiter", NO_LENGTH, "cannot limit rope[0], whose springs have no length"),
    ],
}
EXPLICIT = tuple(name for name, method in METHODS.items() if not method.implicit)


def tables() -> list[list[list[str]]]:
    """Return the cells of the page's tables, without their heads."""
    text = (ROOT / "docs" / "concepts" / "together.md").read_text(encoding="utf-8")
    found = []
    for part in re.split(r"\n\n", text):
        rows = [line for line in part.splitlines() if line.startswith("|")]
        if rows:
            found.append([[cell.strip() for cell in row.strip("|").split("|")] for row in rows[2:]])
    return found


def features(text: str) -> list[str]:
    """Return the features named in a cell, in order."""
    found = sorted((text.find(shown), name) for shown, name in NAMES.items() if shown in text)
    return [name for _, name in found]


def documented_pairs() -> set[frozenset[str]]:
    """Return the pairs that the first table says no method takes: the first of a row with each other."""
    rows = [row[0] for row in tables()[0] if "`" not in row[0]]
    return {frozenset((first, other)) for first, *others in map(features, rows) for other in others}


def documented_methods() -> set[tuple[frozenset[str], str]]:
    """Return the features and methods that either table says do not go together."""
    found = set()
    for row in tables()[0]:
        for method in re.findall(r"with `([\w-]+)` only", row[0]):
            found.add((frozenset(features(row[0])), method))
    for row in tables()[1]:
        named = EXPLICIT if row[0].startswith("explicit") else re.findall(r"`([\w-]+)`", row[0])
        alone = [frozenset((name,)) for name in features(row[1])]
        sets = [frozenset(features(row[1]))] if " beside " in row[1] else alone
        found |= {(those, method) for those in sets for method in named}
    return found


def test_the_page_has_the_pairs_that_are_refused() -> None:
    named = [row[0] for row in tables()[0] if "`" in row[0]]
    assert named == list(OF_FIELDS)
    assert documented_pairs() == {frozenset(pair) for pair in APART}
    refused = {(frozenset(those), name) for those, names, _ in OF_METHODS for name in names}
    assert documented_methods() == refused


@pytest.mark.parametrize("row", OF_FIELDS)
def test_fields_that_do_not_go_together_are_refused(row: str) -> None:
    """The twin: without the feature the same fields are taken."""
    for feature, fields, words in OF_FIELDS[row]:
        with pytest.raises(SceneError) as refused:
            build(apply_overrides(scene_of("implicit-euler", feature, implicit=True), fields))
        assert [words in str(fault) for fault in refused.value.faults] == [True]
        build(apply_overrides(scene_of("implicit-euler", implicit=True), fields))


@pytest.mark.parametrize("pair", APART, ids=" and ".join)
def test_a_pair_is_refused_with_its_path_and_a_remedy(pair: tuple[str, str]) -> None:
    with pytest.raises(SceneError) as refused:
        Simulation(scene_of("implicit-euler", *pair, implicit=True))
    told = str(refused.value)
    assert APART[pair] in told
    assert re.match(r"[\w\[\].]+: ", told), told
    assert re.search(r"leave (it )?out|give|take|use|tie|instead|without|make", told), told


@pytest.mark.parametrize(
    ("those", "method", "words"),
    [(those, name, words) for those, names, words in OF_METHODS for name in names],
)
def test_a_method_says_what_it_cannot_do(those: tuple[str, ...], method: str, words: str) -> None:
    with pytest.raises(SceneError) as refused:
        Simulation(scene_of(method, *those, implicit=METHODS[method].implicit))
    assert words in str(refused.value)


def test_cells_are_read_as_they_are_meant() -> None:
    assert features("winch and bending (or a clamp)") == ["winch", "bending", "clamp"]
    assert features("air, ground") == []
