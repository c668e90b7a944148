"""What is pressed at rest: Euler's elastica far beyond its load, folds, and what tables say of a push.

Closed forms 2.5.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import ropewalk as rw
from ropewalk.scene import Points, Polyline
from ropewalk.statics import static_shape
from verification.relations import given

EI, LENGTH = 0.5, 1.0  # N m^2, m


def arch(chord: float, segments: int = 40, up: float = 1.0) -> rw.Scene:
    """A weightless beam, pinned at both ends, which are pushed together to a chord [m]."""
    share = np.linspace(0.0, 1.0, segments + 1)
    rise = 0.6 * (LENGTH - chord) ** 0.5  # about right; the equations find the rest
    points = [(chord * s, 0.0, up * rise * np.sin(np.pi * s)) for s in share]
    made_of = rw.Material(EA=1e7, mass_per_length=0.1, EI=EI)
    rope = rw.Rope(segments=segments, length=LENGTH, made_of=made_of, shape=Points(points=points))
    return rw.Scene(
        gravity=(0, 0, 0), ropes=[rope], anchors=[rw.Anchor(node=0), rw.Anchor(node=-1)]
    )


def elastica(chord: float) -> tuple[float, float]:
    """Return thrust [N] and rise [m] of the elastica: chord / L = 2 E/K - 1, P = EI (2K/L)^2, rise = k L/K.

    Love, Mathematical Theory of Elasticity, sec. 263; Timoshenko and Gere, Theory of Elastic Stability, 2.7.
    """
    m = brentq(lambda m: 2.0 * ellipe(m) / ellipk(m) - 1.0 - chord / LENGTH, 1e-9, 0.999)
    return EI * (2.0 * ellipk(m) / LENGTH) ** 2, m**0.5 * LENGTH / ellipk(m)


@pytest.mark.parametrize(("chord", "within"), [(0.95, 4e-4), (0.7, 2e-3), (0.3, 7e-3)])
def test_a_buckled_beam_is_the_elastica_and_its_push_is_told(chord: float, within: float) -> None:
    """Thrust, rise, and the same thrust as H, whichever way the arch stands.

    The tension alone, without the shear, is 1.06 N across gravity at a foot of the second arch, for 5.84 N
    of thrust; and its largest tension is the least that is pressed, -2.48 N.
    """
    thrust, rise = elastica(chord)
    for up in (1.0, -1.0):
        scene = arch(chord, up=up)
        found, rest = rw.equilibrium(scene), static_shape(scene)
        carried = found.reactions[0, 0, 0]
        assert carried == pytest.approx(thrust, rel=within)
        assert np.abs(found.positions[0, :, 2]).max() == pytest.approx(rise, rel=within)
        (span,) = rest.spans
        assert span.horizontal == pytest.approx(-carried, rel=1e-6)
        least = found.tension.min()
        assert span.largest_push == rest.largest_push == pytest.approx(-least, rel=1e-6)
        if found.tension.max() < 0.0:
            assert span.pull_words(5) == f"pushes {-least:.5g} N"
        assert repr(rest).endswith(f", largest push {-least:.4g} N.")
        assert found.table["least tension [N]"] == least
        assert least == pytest.approx(-thrust, rel=within)
        assert "push" in found.table["about the least tension"]
    (of_rope,) = rw.check(scene).ropes
    assert of_rope.largest_push == pytest.approx(-least, rel=1e-6)
    assert f"largest push {-least:.5g} N" in "\n".join(of_rope.lines())


def test_what_hangs_pushes_nowhere_and_nothing_is_said_of_it() -> None:
    """The twin: neither the table nor the check speaks of rounding."""
    made_of = rw.Material(EA=1e4, mass_per_length=0.1, EI=1e-6)
    for shape in ({"kind": "slack", "end": (0.8, 0, 0)}, {"kind": "hanging"}):
        rope = rw.Rope(segments=20, length=1.0, made_of=made_of, shape=shape)
        held = [rw.Anchor(node=0)] + [rw.Anchor(node=-1)] * (shape["kind"] == "slack")
        scene = rw.Scene(ropes=[rope], anchors=held)
        assert "least tension [N]" not in rw.equilibrium(scene).table
        (span,) = static_shape(scene).spans
        assert span.pull_words(4) == f"{span.largest_tension:.4g} N"
        assert rw.check(scene).ropes[0].largest_push == 0.0


def hairpin(length: float) -> rw.Rope:
    made_of = rw.Material(EA=1e6, mass_per_length=0.1, EI=EI)
    fold = Polyline(points=[(0, 0, 0), (length / 2, 0, 0), (0, 0, 0)])
    return rw.Rope(name="hairpin", segments=20, length=length, made_of=made_of, shape=fold)


def test_a_stiff_hairpin_opens() -> None:
    """Exactly folded no force opens it, but a push does: it was said to rest with 14 EI / l in the fold."""
    anchor = rw.Anchor(node=0)
    found = rw.equilibrium(rw.Scene(gravity=(0, 0, 0), ropes=[hairpin(LENGTH)], anchors=[anchor]))
    x = found.positions[0]
    assert np.linalg.norm(x[-1] - x[0]) == pytest.approx(LENGTH, rel=1e-6)
    assert found.energy["bending"][0] < 1e-9 * 14.0 * EI / (LENGTH / 20)
    assert "least tension [N]" not in found.table


def test_a_hairpin_is_opened_by_pushes_of_its_own_size_and_nothing_else_is() -> None:
    """A push of the scene's mean segment left 20 m folded beside 1 m, whose arch it threw about."""
    beside = given(arch(0.999).ropes[0], name="arch")
    held = [
        rw.Anchor(rope=name, node=node)
        for name, node in (("hairpin", 0), ("arch", 0), ("arch", -1))
    ]
    scene = rw.Scene(gravity=(0, 0, 0), ropes=[hairpin(20.0 * LENGTH), beside], anchors=held)
    x = rw.equilibrium(scene).positions[0]
    assert np.linalg.norm(x[20] - x[0]) == pytest.approx(20.0 * LENGTH, rel=1e-6)
    rise = np.linalg.norm(x[21:, 1:] - x[21, 1:], axis=1).max()
    assert rise == pytest.approx(elastica(0.999)[1], rel=1e-3)
