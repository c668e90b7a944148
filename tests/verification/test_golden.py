"""Golden states: a change of code that changes no physics changes no bits.

Other tests compare a program with itself or with formulas to a tolerance; these find what both let pass.
"""

from __future__ import annotations

import json

import pytest

from golden.states import ROUNDING, final, kept_with, laws, machine, misfit, path, scene
from ropewalk.laws.registry import ELASTIC_LAWS, NODE_LAWS
from ropewalk.lowering import build
from ropewalk.methods.registry import METHODS


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("law", laws())
def test_golden_state(law: str, method: str) -> None:
    """The bits on machines that have written theirs; on another one the numbers to rounding.

    Processors of one name may do as those of another one (a Zen 4 writes for four states of slack
    ropes what an Emerald Rapids does): bits are those of any machine that has written. The twin: one
    step later the numbers differ by far more.
    """
    kept = json.loads(path(method).read_text(encoding="utf-8"))
    found = final(law, method)
    assert found.keys() == kept[law].keys(), f"{law} with {method}: refused before or now"
    if "refused" in found:
        assert found == kept[law]
        return
    assert misfit(found, kept[law]) <= ROUNDING
    if machine() in kept[law]["bits"]:
        assert found["bits"][machine()] in kept[law]["bits"].values()
    assert misfit(final(law, method, frames=7), kept[law]) > 1e3 * ROUNDING


def test_a_machine_adds_its_bits_where_the_numbers_agree() -> None:
    """Where they do not nothing is left of the others'."""
    kept = {"bits": {"another": "a"}, "x": [1.0, 2.0], "v": [3.0]}
    found = {"bits": {"this": "b"}, "x": [1.0, 2.0 + 1e-15], "v": [3.0]}
    both = kept_with(kept, found)
    assert both == kept | {"bits": {"another": "a", "this": "b"}}
    moved = found | {"x": [1.0, 2.0 + 1e-9]}
    assert kept_with(kept, moved) == moved
    assert kept_with(None, found) == found
    assert kept_with(kept, {"refused": "run"}) == {"refused": "run"}


def test_every_registered_law_acts_in_a_golden_state() -> None:
    """So that a new law is missed where it has none. The twin: the first states alone lack some."""
    registered = {law.name for law in (*NODE_LAWS, *ELASTIC_LAWS)}
    acting = {law: names_of(law) for law in laws()}
    assert set().union(*acting.values()) == registered
    assert set().union(*(acting[law] for law in list(laws())[:10])) < registered


def names_of(law: str) -> set[str]:
    """Return the registered laws that act in a golden state."""
    model = build(scene(law, "implicit-euler"))
    found = {one.name for one, acts in zip(NODE_LAWS, model.system.acts, strict=True) if acts}
    ropes = model.scene.ropes
    return found | {
        one.name for one in ELASTIC_LAWS if any(one.says(rope) is not None for rope in ropes)
    }
