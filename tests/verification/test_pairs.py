"""Every two features work together in every method, but for those on a list, each with its reason."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.methods.registry import METHODS
from ropewalk.scene import SceneError
from verification.feature_pairs import FEATURES, MORE, scene_of

#: Pairs that no method takes, with words of the refusal.
APART = {
    ("rigid links", "winch"): "which a winch cannot wind segment by segment without a jolt",
    ("rigid links", "curve"): "leave it out with a curve",
    ("rigid links", "relaxation"): "nothing relaxes",
}
#: What changes nothing beside another feature, which has it already: the second of each.
IDLE = {"clamp": "bending", "rigid links": "limiter"}
IDLE |= {"curvature": "bending", "turning obstacle": "obstacle", "hauling winch": "winch"}
EXPLICIT = tuple(name for name, method in METHODS.items() if not method.implicit)
RINGING = ("implicit-midpoint", "generalized-alpha")
#: What some methods do not take: features, methods, words of the refusal.
OF_METHODS = (
    (("rigid links",), (*RINGING, "sdirk2"), "cannot hold the lengths of rigid links"),
    (("rigid links",), EXPLICIT, "cannot hold the lengths"),
    (("limiter",), (*RINGING, "sdirk2"), "a segment at its bound is rigid"),
    (("obstacle",), RINGING, "cannot work with obstacles"),
    (("contact",), RINGING, "cannot work with ropes that touch each other"),
)
ONE = "implicit-euler"  # in which more features are tried
NOT_BESIDE = {("curvature", "winch"): "curved by itself"}
NOT_BESIDE[("hauling winch", "rigid links")] = APART[("rigid links", "winch")]
#: Features of continuous materials, which springs do not have.
OF_MATERIALS = (
    "rigid links", "curve", "relaxation", "bending", "clamp", "tension only", "axial friction",
    "parting",
)  # fmt: skip
PAIRS = list(combinations(FEATURES, 2))
#: Methods without a stable step where nothing damps the stiffest modes, and the pair that has no damping.
GAINING, UNDAMPED = ("euler", "heun"), {"relaxation", "tension only"}


def refusals(method: str, *features: str) -> list[str]:
    """Words one of which a refusal of these features must have; none where they are to work."""
    found = [words for pair, words in APART.items() if set(pair) <= set(features)]
    for those, methods, words in OF_METHODS:
        if method in methods and set(those) <= set(features):
            found.append(words)
    return found


def end_of(method: str, *features: str) -> rw.Result:
    """The run of a scene with these features."""
    return rw.simulate(scene_of(method, *features, implicit=METHODS[method].implicit))


@pytest.mark.parametrize("method", METHODS)
def test_every_pair_of_features_works_or_is_on_the_list(method: str) -> None:
    """It runs to its end, its works and energies add up, and neither feature is lost beside the other: the
    rope would end elsewhere without it. A pair on the list is refused, with its reason.
    """
    alone = {name: end_of(method, name) for name in FEATURES if not refusals(method, name)}
    for first, second in PAIRS:
        words = refusals(method, first, second)
        if words:
            with pytest.raises(SceneError) as refused:
                end_of(method, first, second)
            assert any(one in str(refused.value) for one in words), (first, second, refused.value)
            continue
        if method in GAINING and {first, second} == UNDAMPED:
            continue
        look_at(end_of(method, first, second), alone, first, second)


@pytest.mark.parametrize("feature", MORE)
def test_more_features_work_beside_all_others(feature: str) -> None:
    """In one method: bodies that turn and move, natural curvature, a winch that hauls, and springs, which
    have no field of a material.
    """
    alone = {name: end_of(ONE, name) for name in (feature, *FEATURES)}
    for name in FEATURES:
        words = NOT_BESIDE.get((feature, name))
        if words:
            with pytest.raises(SceneError, match=words):
                end_of(ONE, feature, name)
        elif not (feature == "springs" and name in OF_MATERIALS):
            look_at(end_of(ONE, feature, name), alone, feature, name)


#: An explicit method and one that solves, their step [s], and how far apart they may come in 0.1 s [m].
BOTH, STEP, ALIKE = ("rk4", "esdirk3"), 2.5e-4, 3e-3
#: What both take. Which of many equally loaded segments parts is for much shorter steps.
COMPARED = [name for name in FEATURES if name not in ("rigid links", "parting")] + ["hauling winch"]


@pytest.mark.parametrize("first", COMPARED)
def test_an_explicit_method_comes_to_where_one_that_solves_does(first: str) -> None:
    """With every two features: both methods run, and one of them may be wrong beside another feature. Where a
    limiter did not know of a drum that hauls, it was by 11 mm. What goes slack needs friction: without any,
    how folds snap taut is for shorter steps.
    """
    for second in COMPARED[COMPARED.index(first) :]:
        pair = {first, second}
        if pair in (UNDAMPED, {"winch", "hauling winch"}):
            continue
        pair |= {"axial friction"} if "tension only" in pair else set()
        ends = []
        for method in BOTH:
            scene = scene_of(method, *pair, implicit=METHODS[method].implicit)
            ends.append(rw.simulate(scene.replace(run=scene.run.replace(time_step=STEP))))
        apart = np.abs(ends[0].positions[-1] - ends[1].positions[-1]).max()
        assert apart < ALIKE, (first, second, apart)


def look_at(both: rw.Result, alone: dict[str, rw.Result], first: str, second: str) -> None:
    """Check a run that has two features."""
    assert both.status == "finished", (first, second)
    scale = max(float(np.abs(values).max()) for values in both.energy.values())
    left = both.table["largest balance residual [J]"]
    assert left < 1e-9 * scale, (first, second, left, scale)
    for one, other in ((first, second), (second, first)):
        idle = IDLE.get(one) == other
        assert (moved_by(both, alone[one]) > 1e-9) != idle, (one, other)


def moved_by(result: rw.Result, other: rw.Result) -> float:
    """How far the first rope's eleven nodes end from those of another run [m]; a drum's come before them."""
    here, there = result.positions[-1], other.positions[-1]
    drum = bool(result.scene.winches or other.scene.winches)
    rows = slice(-11, None) if drum else slice(11)
    return float(np.abs(here[rows] - there[rows]).max())
