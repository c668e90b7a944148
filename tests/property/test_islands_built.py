"""What is built for ropes that nothing ties together: each once, and no more often for one among many."""

from __future__ import annotations

import gc
import sys
from collections import Counter
from collections.abc import Callable
from types import FrameType

import numpy as np

from property.test_islands_kept import hung
from ropewalk.core.arrays import flatten
from ropewalk.lowering import build
from ropewalk.scene import (
    Anchor,
    Material,
    Rope,
    Scene,
    Slack,
)
from ropewalk.simulation import Simulation


def test_no_line_of_building_runs_more_often_for_a_rope_among_many() -> None:
    """No loop over all ropes within one over all ropes: lines run, not seconds, are counted."""

    def lines(count: int, act: Callable[[Scene], object]) -> Counter[tuple[str, int]]:
        ropes = [
            Rope(name=f"rope{k}", segments=2, length=1.0, shape=Slack(start=(0, k, 0), end=(0.9, k, 0)),
                 made_of=Material(EA=1e3, mass_per_length=0.1))
            for k in range(count)
        ]  # fmt: skip
        anchors = [Anchor(rope=rope.name, node=0) for rope in ropes]
        scene = Scene(ropes=ropes, anchors=anchors, run={"method": "sdirk2", "time_step": 0.01})
        seen: Counter[tuple[str, int]] = Counter()

        def look(frame: FrameType, event: str, _: object) -> Callable[..., object] | None:
            if event == "line":
                seen[frame.f_code.co_filename, frame.f_lineno] += 1
            return look if "ropewalk" in frame.f_code.co_filename else None

        before = sys.gettrace()
        sys.settrace(look)
        try:
            act(scene)
        finally:
            sys.settrace(before)
        return seen

    def steep(act: Callable[[Scene], object]) -> list[tuple[str, int]]:
        few, many = lines(10, act), lines(40, act)
        return [line for line, hits in many.items() if hits > 4.5 * few[line] + 40]

    def quadratic(scene: Scene) -> None:
        for rope in scene.ropes:
            scene.rope_index(rope.name)  # goes through all before it

    lines(2, lambda scene: Simulation(build(scene)))  # what is done once
    assert steep(lambda scene: Simulation(build(scene))) == []
    assert steep(quadratic)  # such a line is seen


def test_what_is_the_same_of_all_ropes_is_made_once() -> None:
    """Tables of the first rope are those of the second; anchors and flags each has for itself."""
    first, second, *_ = hung("sdirk2", 3)._engine.engines  # type: ignore[union-attr]
    one, other = flatten(first.system), flatten(second.system)
    own = {name for name, array in one.items() if np.size(array) and array is not other[name]}
    assert {name for name in own if not name.startswith("anchors.")} == {"acts", "flags", "gravity"}
    assert not np.array_equal(one["anchors.params"], other["anchors.params"])


def test_no_cycles_are_looked_for_while_ropes_are_built() -> None:
    """Every search went through all that was made so far."""
    model, searches = hung("sdirk2", 200).model, list[str]()

    def note(phase: str, _: object) -> None:
        searches.append(phase)

    gc.collect()
    gc.callbacks.append(note)
    try:
        Simulation(model)
    finally:
        gc.callbacks.remove(note)
    assert searches.count("start") <= 3  # else 44
    assert gc.isenabled()
