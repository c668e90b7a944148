"""A model of which only what changes is made has the bits of one made anew, whatever path is varied."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import flatten
from ropewalk.lowering import Model, build
from ropewalk.lowering.pieces import same
from ropewalk.scene import SceneError, apply_overrides
from ropewalk.scene.overrides import Places
from ropewalk.scene.paths import by_tag, keys, kind_of, sections, tag
from ropewalk.scene.scene import Scene
from ropewalk.sweeps.parameters import TEXT
from ropewalk.sweeps.workshop import Workshop
from sweeps.scenes import DOWN, EA, alone, swing

HERE = Path(__file__).parent
STIFF, SPRINGY = rw.load(HERE / "all_of_material.toml"), rw.load(HERE / "all_of_springs.toml")
TOUCHING = rw.load(HERE / "all_of_obstacles.toml")
KNOTTED = rw.load(HERE / "all_of_knots.toml")
SLIDING = rw.load(HERE / "all_of_slides.toml")
TOLD = [k for k, body in enumerate(TOUCHING.obstacles) if not (body.spin and body.spin.free)]
BACK = ["contact.restitution=0.5", *(f"obstacle[{k}].restitution=0.5" for k in TOLD)]
THROWING = apply_overrides(TOUCHING, ["method=adaptive", *BACK])
#: What has only one value by itself: the version, files (read when a scene is loaded), a rope's stuff,
#: a plane, a curve of other numbers, nodes that are tied (others lie elsewhere), what turns freely.
CURVES = "TableCurve", "PolynomialCurve", "NeoHookeanCurve", "ExponentialCurve"
NEVER = {
    ("Scene", "schema_version"),
    ("Table", "file"),
    ("Points", "file"),
    ("TableCurve", "file"),
    ("Mesh", "file"),
    ("Mesh", "faces"),  # other ones are no solid
    ("Sdf", "faces"),
    ("Sdf", "file"),
    ("Sdf", "values"),  # taken at once, as files are
    ("Sdf", "spacing"),
    ("Sdf", "origin"),
} | {(name, "kind") for name in ("Springs", "Material", "Plane", *CURVES)}
NEVER |= {("Tie", "rope"), ("Tie", "node")}
NEVER |= {("RopePair", "other")}  # which of two ropes is first does not matter: `rope` is varied
NEVER |= {("Spin", "free")}  # it goes with an inertia
NEVER |= {("Spin", "center_of_mass")}  # it goes with a mass, of a body that turns freely
SPRINGS = '{kind = "springs", spring_constant = 5.0, node_mass = 0.1, segment_length = 0.1}'
MATERIAL = '{kind = "material", EA = 5.0, mass_per_length = 0.1}'
WORDS = ["true", "false", "1.5", "0.3", "2", "1", "none", "[0.1, 0.2, -0.9]", "b", "right", "e"]
WORDS += ["dynamic-single", "dynamic-single-8.9"]


def every_path(scene: Scene) -> Iterator[tuple[str, type, str, Any]]:
    """Yield path, model, key and present value of every field of every part of a scene.

    Of parts that have the same fields (ropes of one kind of material) those of the first.
    """
    met: set[tuple[type, frozenset[str]]] = set()

    def below(table: dict[str, Any], model: type, prefix: str) -> Iterator[Any]:
        given = (model, frozenset(key for key, value in table.items() if value is not None))
        known = given in met
        met.add(given)
        for key, field in keys(model).items():
            kind, value, path = kind_of(field), table.get(key), f"{prefix}{key}"
            if not kind.models:
                if not known:
                    yield path, model, key, value
            elif kind.listed:
                for number, item in enumerate(value or []):
                    one = by_tag(kind.models, item.get("kind", tag(kind.models[0])))
                    yield from below(item, one, f"{path}[{number}].")
            elif value is not None or not kind.optional:
                value = value or {}
                one = by_tag(kind.models, value.get("kind", tag(kind.models[0])))
                yield from below(value, one, f"{path}.")

    yield from below(scene.table(), Scene, "")


def near(value: Any) -> Any:
    """The same with all its numbers a little different."""
    if isinstance(value, list):
        return [near(item) for item in value]
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return value
    return value - 1 if isinstance(value, int) else 1.1 * value + 0.01


def candidates(model: type, key: str, value: Any) -> list[str]:
    """Texts to try in a field: its choices, something near, and what other fields may hold."""
    if key == "kind":
        found = {tag(one): None for _, owner in sections(Scene) for f in owner.model_fields.values()
                 for one in kind_of(f).models if model in kind_of(f).models}  # fmt: skip
        return [str(one) for one in found]
    choices = [str(one) for one in get_args(keys(model)[key].annotation) if isinstance(one, str)]
    started = [] if value is None else [json.dumps(near(value)), json.dumps(value)]
    return [*choices, *started, *WORDS]


def bits(model: Model) -> dict[str, Any]:
    """All that a model is, arrays as bytes."""
    arrays = flatten(model.system, "system.") | flatten(model.state, "state.")
    found: dict[str, Any] = {
        name: (np.asarray(array).dtype.str, np.shape(array), np.asarray(array).tobytes())
        for name, array in arrays.items()
    }
    plain = {"layout": repr(model.layout), "plan": repr(model.plan), "zero": model.gravity_zero}
    return found | plain | {"scene": repr(model.scene.table())}


def anew(scene: Scene, path: str, text: str) -> dict[str, Any] | str:
    """The bits of a model made anew, or what is wrong with it."""
    try:
        return bits(build(apply_overrides(scene, [f"{path}={text}"])))
    except SceneError as error:
        return str(error)


def kept(shop: Workshop, text: str) -> dict[str, Any] | str:
    """The same of a model of a sweep."""
    try:
        return bits(shop.model([text]))
    except SceneError as error:
        return str(error)


def compare(scene: Scene, path: str, texts: list[str]) -> int:
    """Compare models made after one another with those made anew; return how many different ones."""
    shop, seen, refused = Workshop(scene, [path], [TEXT]), {}, 0
    for text in texts:
        wanted = anew(scene, path, text)
        if isinstance(wanted, str):
            refused += 1
            if refused > 2:
                continue
        assert kept(shop, text) == wanted, f"{path}={text}"
        if not isinstance(wanted, str):
            seen[text] = wanted
        if len(seen) == 3 or (len(seen) == 2 and len({*map(repr, seen.values())}) == 2):
            break
    for text in [*seen, *reversed(seen)]:  # whatever came before
        assert kept(shop, text) == seen[text], f"{path}={text}, again"
    return len({repr(found) for found in seen.values()})


@pytest.mark.slow
def test_every_path_gives_the_bits_of_a_model_made_anew() -> None:
    varied: set[tuple[str, str]] = set()
    ringing = apply_overrides(swing(), ["start=at-rest", "run.ring.mode=1", "run.ring.speed=0.1"])
    for scene in (STIFF, SPRINGY, ringing, TOUCHING, KNOTTED, SLIDING, THROWING):
        for path, model, key, value in every_path(scene):
            name = (model.__name__, key)
            if scene is SLIDING and model.__name__ != "Slide":
                continue  # ropes are those of the others
            if scene is THROWING and key != "restitution":
                continue
            if name not in NEVER and compare(scene, path, candidates(model, key, value)) > 1:
                varied.add(name)
    fields = {
        (model.__name__, key)
        for _, model in sections(Scene)
        for key, field in keys(model).items()
        if not kind_of(field).models
    }
    assert fields - varied - NEVER == set()


def test_paths_that_reach_several_places_and_parts_that_are_not_there_yet() -> None:
    springy, plain = SPRINGY, swing()
    stiff = apply_overrides(plain, ["rope.made_of.EI=0.01"])  # a clamp has something to hold
    for scene, path, texts in [
        (springy, "rope.made_of.spring_constant", ["700.0", "inf", "750.0"]),
        (springy, "anchor.post.motion.velocity[1]", ["0.0", "-0.0", "1.0"]),
        (plain, "air.density", ["1.2", "0.0", "1.3"]),
        (stiff, "anchor.clamp.direction", ["[1, 0, 0]", "[0, 0, 1]"]),
        (plain, "gravity[0]", ["0.0", "-0.0", "1.0"]),
        (plain, "gravity", ["[0, 0, 0]", "[-0.0, 0.0, -1.0]", "[0.0, -0.0, -1.0]"]),
        (springy, "limiter", ["none", "{max_stretch = 1.3}"]),
        (plain, "rope.made_of", [SPRINGS, MATERIAL, "dynamic-single", MATERIAL]),
    ]:
        assert compare(scene, path, texts) > 1, path


def test_only_what_a_parameter_changes_is_made() -> None:
    wanted = {
        EA: {"stiffness", "break stretch"},
        "rope.made_of.mass_per_length": {"masses", "break stretch"},
        DOWN: {"break stretch", "obstacle", "slide"},  # they bear what hangs on ropes
        "run.duration": set(),
        "anchor.release_time": {"alike", "anchors", "starts", "kinks"},
        "rope.diameter": {"air"},
    }
    for path, pieces in wanted.items():
        value = Places(swing(), [path]).value(0) or 1.0
        shop = Workshop(swing(), [path], ["float"])
        for share in (1.0, 1.1, 1.2):
            shop.model([share * value])
        assert set(shop.pieces.made) == pieces, path


def test_minus_zero_is_another_number() -> None:
    assert not same(0.0, -0.0)
    assert not same((1.0, (0.0,)), (1.0, (-0.0,)))
    assert not same(np.zeros(2), -np.zeros(2))
    assert same((1.0, (0.0,), "a", None), (1.0, (0.0,), "a", None))
    assert not same(1, 1.0)


def test_runs_do_not_write_to_what_they_share() -> None:
    """Each run of a batch is that of its own, also when others were made of the same pieces before."""
    scene = apply_overrides(swing(), ["anchor.release_time=0.03"])
    values = [1000.0, 3000.0, 1000.0, 2000.0]
    ds = rw.sweep(scene, {EA: values, DOWN: [-9.0, -3.0]}, keep="positions[-1]", on="here")
    for place, stiffness in enumerate(values):
        for down in (-9.0, -3.0):
            own = alone(scene, **{EA: stiffness, DOWN: down}).positions[-1]
            found = ds.positions_last.isel(EA=place).sel(gravity_2=down).values
            np.testing.assert_array_equal(found, own)


def test_threads_of_one_worker_do_not_mix_their_runs() -> None:
    from concurrent.futures import ThreadPoolExecutor

    from ropewalk.sweeps.worker import batcher_of

    function = rw.sweep.function(swing(0.02), [EA, "rope.length"], "positions[-1]")
    recipe = json.dumps(function.recipe.plain())

    def mixed(number: int) -> int:
        mine = 1000.0 + number
        scenes = (batcher_of(recipe).scene([mine, 2.0]) for _ in range(300))
        return sum(mine != scene.ropes[0].made_of.EA for scene in scenes)

    often = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        with ThreadPoolExecutor(4) as pool:
            assert list(pool.map(mixed, range(8))) == [0] * 8
    finally:
        sys.setswitchinterval(often)


def test_a_piece_that_misses_a_change_would_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.lowering.pieces.same", lambda one, other: True)
    with pytest.raises(AssertionError, match="rope.length"):
        compare(swing(), "rope.length", ["2.0", "2.1"])
