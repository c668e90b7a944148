"""The engine knows no law of nodes by name: what knows air or ground beside their own files, and why."""

from __future__ import annotations

import ast
import re

from architecture.sources import PACKAGE, SOURCES, name_of
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.scene import Scene

ENGINE = {
    "core", "engine", "hands", "laws", "lowering", "methods", "motions", "simulation", "statics",
    "vibration",
}  # fmt: skip
OWN = {f"laws/{name}.py" for name in ("air", "air_drag", "air_tangent", "ground", "registry")}
ALLOWED = {
    "lowering/motion_rows.py": "above_ground, a field of the scene's anchors",
    "core/arrays.py": "above_ground, the same in the table of anchors",
    "laws/anchors.py": "above_ground, read there",
    "lowering/going_alike.py": "above_ground, which stops an anchor by itself",
    "lowering/release_checks.py": "where the ground has stopped an anchor before it lets go",
    "statics/rest.py": "grounded, a field of Statics that users read",
    "statics/refusal.py": "a sentence on what is missing",
    "lowering/chains.py": "'in the air', the name of a case of the bound of the step, which users read",
}


def words(source: str) -> set[str]:
    """Return the words for air and ground in a module's names and texts, docstrings left out."""
    tree = ast.parse(source)
    texts = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    found = set()
    for node in ast.walk(tree):
        parts = [getattr(node, key, None) for key in ("id", "attr", "arg", "name", "module")]
        if isinstance(node, ast.Constant) and id(node) not in texts:
            parts.append(node.value)
        for part in parts:
            if isinstance(part, str):
                found |= set(re.findall(r"(?i)\b\w*ground\w*|(?<![a-z])air(?![a-z])", part))
    return found - {"background"}


def test_air_and_ground_are_known_to_their_own_files_alone() -> None:
    """But for the places above, each with its reason; all of which still stand."""
    known = {
        name_of(path)
        for path in SOURCES
        if name_of(path).split("/")[0] in ENGINE or path.parent == PACKAGE
        if words(path.read_text(encoding="utf-8"))
    }
    known.discard("__init__.py")  # the names of the scene's sections
    assert known - OWN == set(ALLOWED)


def test_the_words_are_found() -> None:
    """The twin: each way in which a module could know the ground, and what is no such way."""
    for text in (
        "system.node.ground",
        "f(ground=1)",
        "def ground(): pass",
        "x = 'the ground'",
        "air.x",
    ):
        assert words(text), text
    for text in ("'''On the ground.'''", "pair = 1", "background = fair"):
        assert not words(text), text


def test_every_law_is_made_from_a_section_of_the_scene() -> None:
    """A name that the scene does not know would never act, and nothing would say so."""
    told = {name for name in vars(Scene) if isinstance(vars(Scene)[name], property)}
    assert {law.section for law in NODE_LAWS} <= set(Scene.model_fields) | told
    assert len({law.name for law in NODE_LAWS}) == len(NODE_LAWS)


def test_pieces_that_need_each_other_come_together() -> None:
    pairs = [("is_diagonal", "add_diagonal"), ("mark", "marked_force")]
    for law in NODE_LAWS:
        for one, other in pairs:
            assert (getattr(law, one) is None) == (getattr(law, other) is None), (law.name, one)
        if law.at_rest is not None and law.bears is None:
            assert "BEARS" not in law.at_rest.__code__.co_names, law.name
