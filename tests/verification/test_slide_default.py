"""How stiff slides are by default: their loads hang close to their lines, at the ropes' own steps."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import ropewalk as rw
from ropewalk.laws.obstacle import node_stiffness
from ropewalk.laws.slides.slide_force import slide_energy
from ropewalk.laws.slides.sliding import SINK
from ropewalk.laws.slides.table import APART
from ropewalk.lowering import build
from ropewalk.scene import Slack, Straight
from ropewalk.statics import Statics, checked_shape

g = 9.81
LOAD, LENGTH, SEGMENTS = 100.0, 11.0, 20
H = LENGTH / SEGMENTS


def light_wire(load: float = LOAD, EA: float = 2.8e6, **more: Any) -> rw.Scene:
    """100 kg that hang 0.6 m below the middle of 11 m of wire of 2.4 kg."""
    wire = rw.Rope(
        name="wire",
        segments=SEGMENTS,
        length=LENGTH,
        made_of=rw.Material(EA=EA, mass_per_length=2.4 / LENGTH, axial_damping=1e-4 * EA),
        shape=Slack(start=(0, 0, 0), end=(10.8, 0, 0)),
    )
    rider = rw.Rope(
        name="rider",
        segments=1,
        length=0.6,
        made_of=rw.Material(EA=3e4, mass_per_length=0.1, axial_damping=50.0),
        shape=Straight(end=(0, 0, -0.6)),
        loads=[rw.Load(node=0, mass=3.0), rw.Load(node=-1, mass=load - 3.0)],
    )
    slide = rw.Slide(rope="rider", on="wire", at=0.45 * LENGTH, **more.pop("slide", {}))
    anchors = [rw.Anchor(rope="wire", node=node) for node in (0, -1)]
    run = {"method": "esdirk3", "time_step": 2e-3, "duration": 1.0} | more.pop("run", {})
    return rw.Scene(ropes=[wire, rider], anchors=anchors, slides=[slide], run=run, **more)


def stiffness(scene: rw.Scene) -> np.ndarray:
    return build(scene).system.node.slide.stiffness


def as_contacts(scene: rw.Scene) -> float:
    """The stiffness of contacts of the two ropes [N/m], which was that of slides."""
    wire, rider = scene.ropes
    ours = node_stiffness(rider, rider.total_mass, rider.own_mass / 2 + rider.loads[0].mass)[0]
    theirs = node_stiffness(wire, wire.total_mass)[0]
    return ours * theirs / (ours + theirs)


def off_the_line(scene: rw.Scene) -> float:
    """How far the node is off its line at rest [m]."""
    found = checked_shape(scene)
    assert found.solved
    return float(found.memory.slide.sight[0, APART])


def test_a_heavy_load_hangs_close_to_a_light_line() -> None:
    """At rest within 1 % of a segment. The twin, as soft as contacts: 7 % of one, 37 mm."""
    scene = light_wire()
    off = off_the_line(scene)
    assert off == pytest.approx(SINK * H, rel=0.01)
    assert off < 0.01 * H
    soft = scene.replace(**{"slide.compliance": 1.0 / as_contacts(scene)})
    assert off_the_line(soft) > 0.06 * H


def test_it_stays_close_as_it_falls_into_the_line() -> None:
    """In a run, with its books closed: a load that is let go presses with a few times its weight."""
    scene = light_wire(slide={"brake": 30.0}, run={"time_step": 1e-3})
    result = rw.simulate(scene)
    assert result.status == "finished"
    turned = float(np.ptp(result.energy["kinetic"]) + np.ptp(result.energy["total"]))
    assert turned > 10.0
    assert result.table["largest balance residual [J]"] < 1e-12 * turned
    assert result.table["largest energy error [J]"] < 0.02 * turned
    load = result.slide("slide0").load
    assert load.max() > 1.5 * LOAD * g
    assert load.max() / stiffness(scene)[0] < 0.05 * H


@pytest.mark.parametrize("method", ["rk4", "semi-implicit-euler", "verlet"])
def test_steps_of_explicit_methods_know_it_and_hardly_shrink(method: str) -> None:
    """At the bound of the step it runs, energy kept; the bound is that of a soft slide to some percent."""
    scene = light_wire(run={"method": method, "duration": 0.2})
    soft = scene.replace(**{"slide.compliance": 1.0 / as_contacts(scene)})
    bound, other = (rw.check(one).stability.bound for one in (scene, soft))
    assert 0.97 * other < bound <= other
    result = rw.simulate(scene.replace(**{"run.time_step": 0.95 * bound}))
    assert result.status == "finished"
    turned = float(np.ptp(result.energy["kinetic"]) + np.ptp(result.energy["total"]))
    assert result.table["largest energy error [J]"] < 0.02 * turned


@pytest.mark.parametrize("EA", [2e4, 2e5])
def test_on_a_soft_line_it_is_no_stiffer_than_steps_allow_for(EA: float) -> None:
    """A load that stretches its line by percents: as stiff as a segment. The twin asks for more."""
    scene = light_wire(EA=EA, load=1000.0)
    asked = 1000.06 * g / (SINK * H)
    (found,) = stiffness(scene)
    assert found < 0.6 * asked
    bounds = []
    for compliance in (1.0 / as_contacts(scene), None, 1e-3 / asked):
        one = scene.replace(**{"slide.compliance": compliance, "run.method": "verlet"})
        bounds.append(rw.check(one).stability.bound)
    assert bounds[1] > 0.85 * bounds[0]
    assert bounds[2] < 0.1 * bounds[0]


def test_what_hangs_on_a_slide_pulls_it() -> None:
    """Its rope, loads, given forces, and what slides along its rope; at an anchored ring the line."""
    scene = light_wire()
    rider = scene.ropes[1]
    weight = g * rider.total_mass
    assert stiffness(scene) == pytest.approx([weight / (SINK * H)])
    pushed = rider.replace(forces=[rw.Force(node=-1, force=(300.0, 0.0, 400.0))])
    forced = scene.replace(ropes=[scene.ropes[0], pushed])
    assert stiffness(forced) == pytest.approx([(weight + 500.0) / (SINK * H)])
    hook = rider.replace(name="hook", segments=2, loads=[rw.Load(node=-1, mass=50.0)])
    strap = rider.replace(segments=4)
    more = rw.Slide(name="more", rope="hook", on="rider", at=0.3)
    for slides in ([*scene.slides, more], [more, *scene.slides]):
        both = scene.replace(ropes=[scene.ropes[0], strap, hook], slides=slides)
        upper = next(i for i, one in enumerate(both.slides) if one.rope == "rider")
        asked = (g * strap.total_mass + g * hook.total_mass) / (SINK * H)
        assert stiffness(both)[upper] == pytest.approx(asked)


def test_a_line_hangs_on_a_ring_that_is_held() -> None:
    scene = light_wire(load=3.1)
    wire = scene.ropes[0].replace(loads=[rw.Load(node=7, mass=200.0)])
    loose = scene.replace(ropes=[wire, scene.ropes[1]])
    made = build(loose)
    at = made.state.x[:, SEGMENTS + 1]
    here = Straight(start=tuple(map(float, at)), end=(float(at[0]), 0.0, float(at[2]) - 0.6))
    tied = loose.replace(
        ropes=[wire, scene.ropes[1].replace(shape=here)],
        anchors=[*scene.anchors, rw.Anchor(rope="rider", node=-1)],
    )
    free = made.system.node.slide.stiffness
    assert stiffness(tied)[0] > 5.0 * free[0]


def test_a_compliance_that_is_given_is_kept() -> None:
    (found,) = stiffness(light_wire(slide={"compliance": 3e-4}))
    assert found == 1.0 / 3e-4


def test_without_weight_it_is_as_stiff_as_contacts() -> None:
    scene = light_wire(gravity=(0, 0, 0))
    assert stiffness(scene) == pytest.approx([as_contacts(scene)])


def test_it_stores_what_the_load_puts_in() -> None:
    """F^2 / (2 k) at rest, [J]."""
    scene = light_wire()
    found, made = checked_shape(scene), build(scene)
    x = np.ascontiguousarray(found.positions.T)
    stored = slide_energy(x, made.system.node.slide, found.memory.slide)
    (seat,) = found.seats
    assert stored == pytest.approx(0.5 * seat.force**2 / stiffness(scene)[0], rel=1e-6)


SOFT, HEAVY = 2e4, 400.0  # [N, kg]: a line that its load stretches by 17 %


def soft_rest(segments: int, **slide: float) -> Statics:
    """The rest of a heavy load in the middle of a soft line that weighs nothing, nearly."""
    scene = light_wire(EA=SOFT, load=HEAVY, slide=slide)
    wire = scene.ropes[0]
    light = wire.made_of.replace(mass_per_length=1e-3)
    return checked_shape(
        scene.replace(ropes=[wire.replace(segments=segments, made_of=light), scene.ropes[1]])
    )


def exact_drop(force: float) -> float:
    """Of the middle of a weightless line of Hooke's law below its ends [m]: 2 T sin a = F."""
    half = 5.4

    def left(drop: float) -> float:
        side = math.hypot(half, drop)
        return 2.0 * SOFT * (2.0 * side / LENGTH - 1.0) * drop / side - force

    return float(brentq(left, 1.1, 20.0))  # from where it is taut on


@pytest.mark.parametrize("stiff", [False, True])
def test_on_a_soft_line_a_load_comes_to_the_closed_form_with_finer_segments(stiff: bool) -> None:
    """What it is off by, its corner and its spring, falls as 1 / n: extrapolated it is right to 5 mm."""
    heights = {}
    for n in (40, 80):
        found = soft_rest(n, **({"compliance": 1e-9} if stiff else {}))
        assert found.solved
        heights[n] = float(found.positions[n + 1, 2])
    drop = exact_drop(found.seats[0].force)
    assert abs(heights[80] + drop) < 0.6 * abs(heights[40] + drop)
    assert 2.0 * heights[80] - heights[40] == pytest.approx(-drop, abs=5e-3)


def test_what_is_told_of_a_soft_line_is_how_much_lower_its_load_hangs() -> None:
    """By the slide's spring: as soft as a segment, F h / EA, m / (m + m') of that with the nodes' masses. The
    twin is the same line with a slide that does not give; a stiff line has nothing to tell.
    """
    soft, firm = soft_rest(40), soft_rest(40, compliance=1e-9)
    (seat,), (held,) = soft.seats, firm.seats
    lower = float(firm.positions[41, 2] - soft.positions[41, 2])
    assert seat.off == pytest.approx(lower, rel=0.01)
    assert seat.off == pytest.approx(seat.force * LENGTH / 40 / SOFT, rel=0.01)
    assert seat.off > 0.15 * LENGTH / 40
    assert f"{seat.off:.3g} m off it" in str(seat)
    assert "off it" not in str(held)
    (told,) = told_of(light_wire(EA=SOFT, load=HEAVY))
    assert "112 mm off rope 'wire', 20.4 % of a segment" in told
    enough = float(told.split("at most ")[1].split()[0])
    assert not told_of(light_wire(EA=SOFT, load=HEAVY, slide={"compliance": enough}))
    assert off_the_line(light_wire(EA=SOFT, load=HEAVY, slide={"compliance": enough})) < 0.01 * H
    assert not told_of(light_wire())


def told_of(scene: rw.Scene) -> list[str]:
    """What `check` says of slides."""
    return [line for line in rw.check(scene, measure=False).warnings if line.startswith("slide ")]


@pytest.mark.parametrize("end", ["free", "held"])
def test_what_is_tied_to_a_rope_that_slides_comes_along(end: str) -> None:
    """A sling drawn 5 cm off the wire, with a load tied to it: both are moved on to the wire. Where an anchor
    holds the load nothing moves, and the slide is refused.
    """
    scene = light_wire()
    wire, rider = scene.ropes
    top = float(build(scene).state.x[:, build(scene).layout.node(0, "rider")][2])
    at = float(build(scene).state.x[0, build(scene).layout.node(0, "rider")])
    sling = rider.replace(shape=Straight(start=(at, 0, top + 0.05), end=(at, 0, top - 0.55)))
    load = rider.replace(
        name="load", shape=Straight(start=(at, 0, top - 0.55), end=(at, 0, top - 1.15)), loads=[]
    )
    knot = {"points": [{"rope": "rider", "node": -1}, {"rope": "load", "node": 0}]}
    made = scene.replace(ropes=[wire, sling, load], joints=[knot])
    if end == "held":
        held = [*scene.anchors, rw.Anchor(rope="load", node=-1)]
        with pytest.raises(
            rw.SceneError, match=r"slide\[0\]\.node: .* as an anchor has its rope's"
        ):
            build(made.replace(anchors=held))
        return
    model = build(made)
    x, node = model.state.x, model.layout.node
    assert x[2, node(0, "rider")] == pytest.approx(top, abs=1e-12)
    assert x[2, node(-1, "load")] == pytest.approx(top - 1.2, abs=1e-12)
