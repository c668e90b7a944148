"""Winches that wind ropes with bending stiffness: beams of the length that is out, hinged and clamped."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.lowering.bends import bends, wound_bends
from ropewalk.lowering.chains import FREE, free_chains
from ropewalk.scene import (
    Anchor,
    Clamp,
    Material,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Straight,
    Velocity,
    Winch,
)

G, LINE, START = 9.81, 0.00815, 0.1  # m/s^2, kg/m, s
WEIGHT = LINE * G
CLOSED = {"cantilever": 1 / 8, "hinged": 5 / 384, "propped": 1 / 184.6}  # times w L^4 / EI


def beam(kind: str, length: float, speed: float, turns: float, end: str = "start") -> Scene:
    """A level beam of 10 segments a metre and EI = 1 N m^2, wound for a while, then at rest."""
    stop = START + turns
    near, far = (0.0, 0.0, 0.0), (length, 0.0, 0.0)
    rope = Rope(
        segments=round(10 * length),
        length=length,
        made_of=Material(
            EA=1e4 if kind == "cantilever" else 20.0,
            EI=1.0,
            mass_per_length=LINE,
            axial_damping=0.1,
            bending_damping=0.02,
        ),
        shape=Straight(start=near, end=far) if end == "start" else Straight(start=far, end=near),
    )
    clamp = Clamp(direction=(1.0 if end == "start" else -1.0, 0.0, 0.0))
    drum, other = (0, -1) if end == "start" else (-1, 0)
    anchors = [Anchor(node=drum, **({} if kind == "hinged" else {"clamp": clamp}))]
    moves = {"motion": Velocity(velocity=(speed, 0, 0), start=START, stop=stop)} if speed else {}
    if kind != "cantilever":
        anchors.append(Anchor(node=other, **moves))
    winches = [Winch(end=end, speed=speed, start=START, stop=stop)] if speed else []
    return Scene(
        ropes=[rope],
        anchors=anchors,
        winches=winches,
        gravity=(0.0, 0.0, -G),
        run=RunSettings(
            method="implicit-euler", time_step=0.02, duration=stop + 1.6, frame_rate=50.0
        ),
    )


def sag(
    kind: str, length: float, speed: float = 0.0, turns: float = 0.0, end: str = "start"
) -> float:
    """How far the beam hangs at rest over the closed form for what is out then [1]."""
    found = rw.simulate(beam(kind, length, speed, turns, end)).positions
    assert np.abs(found[-1] - found[-10]).max() < 1e-9
    out = length + speed * turns
    return float(-found[-1, :, 2].min() / (CLOSED[kind] * WEIGHT * out**4))


@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize(("length", "speed"), [(0.6, 0.4), (1.2, -0.4)])
@pytest.mark.parametrize("kind", CLOSED)
def test_a_beam_that_was_wound_hangs_as_one_of_its_length(
    kind: str, length: float, speed: float, end: str
) -> None:
    """To rounding where whole segments are out; between them to what the grid is off by anyhow."""
    whole = abs(1.0 - length) / 0.4
    assert sag(kind, length, speed, whole, end) == pytest.approx(sag(kind, 1.0), rel=1e-5)
    if end == "start":
        odd = (0.948 - length) / speed
        assert sag(kind, length, speed, odd) == pytest.approx(
            1.0, abs=0.07 if kind == "propped" else 0.02
        )


def swing(
    segments: int, clamped: bool, speed: float, method: str = "esdirk3", step: float = 2e-3
) -> rw.Result:
    """A soft rope that falls from level while it is wound; `segments` a metre."""
    length = 0.5 if speed > 0 else 0.8
    rope = Rope(
        segments=round(length * segments),
        length=length,
        made_of=Material(EA=40.0, EI=0.02, mass_per_length=0.05, axial_damping=0.2),
        shape=Straight(start=(0, 0, 0), end=(length, 0, 0)),
    )
    clamp = {"clamp": Clamp(direction=(1, 0, 0))} if clamped else {}
    return rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0, **clamp)],
            winches=[Winch(end="start", speed=speed, start=0.05, on_drum=0.4)],
            gravity=(0.0, 0.0, -G),
            run=RunSettings(method=method, time_step=step, duration=0.6, frame_rate=50.0),
        )
    )


@pytest.mark.parametrize("speed", [0.6, -0.6])
@pytest.mark.parametrize("clamped", [True, False])
def test_finer_segments_come_closer(clamped: bool, speed: float) -> None:
    """Twice as fine is less than half as far off, the winch's work converges, and the books close."""
    runs = {n: swing(n, clamped, speed) for n in (10, 20, 80)}
    ends = {n: run.positions[-1, -1] for n, run in runs.items()}
    off = {n: float(np.linalg.norm(ends[n] - ends[80])) for n in (10, 20)}
    assert off[20] < 0.45 * off[10] < 0.02
    work = {n: float(run.work["winch"][-1]) for n, run in runs.items()}
    assert work[20] == pytest.approx(work[80], rel=0.02)
    for run in runs.values():
        assert run.table["largest balance residual [J]"] < 1e-12
        assert run.table["largest energy error [J]"] < 2e-3


@pytest.mark.parametrize("clamped", [True, False])
def test_explicit_steps_agree(clamped: bool) -> None:
    one, other = swing(10, clamped, 0.6), swing(10, clamped, 0.6, "rk4", 1e-4)
    assert np.abs(one.positions[-1] - other.positions[-1]).max() < 5e-4
    assert one.work["winch"][-1] == pytest.approx(other.work["winch"][-1], rel=0.01)


@pytest.mark.parametrize("clamped", [True, False])
def test_predicted_steps_know_the_bends_at_the_drum(clamped: bool) -> None:
    """What is out as it stands is the case without a winch; shorter working segments are stiffer."""
    anchor = Anchor(node=0, **({"clamp": Clamp(direction=(1, 0, 0))} if clamped else {}))
    rope = Rope(
        segments=6,
        length=0.6,
        made_of=Material(EA=40.0, EI=0.5, mass_per_length=0.05, bending_damping=1e-3),
        shape=Straight(start=(0, 0, 0), end=(0.6, 0, 0)),
    )
    winch = Winch(end="start", speed=0.5, on_drum=0.3)
    model = build(Scene(ropes=[rope], anchors=[anchor], winches=[winch]))
    system, state = model.system, model.state
    as_it_is = wound_bends(system, state, state.rest_length.copy(), state.winch_exit.copy())
    for found, wanted in zip(as_it_is, bends(system, state), strict=True):
        np.testing.assert_allclose(found, wanted, rtol=1e-12)
    chains = free_chains(system, state)
    working = int(state.winch_exit[0])
    short = next(chain for name, chain in chains.items() if "0.4" in name)
    paid = chains["with all rope paid out"]
    base = chains[FREE]
    assert short.bending[working] > 4.0 * base.bending[working]
    np.testing.assert_array_equal(short.bending[working + 2 :], base.bending[working + 2 :])
    assert (paid.bending[: working + 1] > 0.0).all()
    assert (base.bending[:working] == 0.0).all()


@pytest.mark.parametrize("end", ["start", "end"])
def test_a_clamp_at_a_drum_that_lets_go_leaves_no_bend_there(end: str) -> None:
    """Rope on the drum does not bend. The twin: a clamp further out does, and is so much stiffer."""

    def springs(node: int, release: float | None) -> np.ndarray:
        scene = beam("cantilever", 0.6, 0.4, 1.0, end)
        drum = scene.anchors[0]
        clamp = drum.replace(name="clamp", node=node, release_time=release)
        anchors = [clamp] if scene.anchor_node(clamp) == scene.anchor_node(drum) else [drum, clamp]
        model = build(scene.replace(anchors=anchors))
        found: np.ndarray = bends(model.system, model.state)[0]
        return found

    for node in (0, 3) if end == "start" else (-1, 3):
        held, lets_go = springs(node, None), springs(node, 0.2)
        assert np.array_equal(held, lets_go) == (node != 3)
        assert (lets_go >= held).all()


@pytest.mark.parametrize("amplitude", [1e-4, 1e-6])
def test_nearly_straight_ropes_with_friction_have_solutions(amplitude: float) -> None:
    """Bends of 1e-8 to 1e-5: rounding turns their plane. Shaken so a rope moves as the shake is large."""
    made_of = Material(
        EA=40.0, EI=0.02, mass_per_length=0.05, axial_damping=0.2, bending_damping=2e-3
    )

    def shaken(size: float) -> np.ndarray:
        shake = Shake(axis=(1, 0, 0), amplitude=size, frequency=1.3)
        run = RunSettings(method="esdirk3", time_step=2e-3, duration=0.1, frame_rate=50.0)
        rope = Rope(segments=80, length=1.0, made_of=made_of, shape={"kind": "hanging"})
        scene = Scene(
            ropes=[rope], anchors=[Anchor(node=0, motion=shake)], gravity=(0, 0, -G), run=run
        )
        aside: np.ndarray = rw.simulate(scene).positions[-1, :, 0] / size
        return aside

    np.testing.assert_allclose(shaken(amplitude), shaken(1e-3), atol=2e-3)
