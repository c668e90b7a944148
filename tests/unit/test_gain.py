"""What of all that there is a step may make up: ropes that nothing ties are no more to each other."""

from __future__ import annotations

import pytest

from ropewalk.lowering import build
from ropewalk.methods.gain import turned_over
from ropewalk.scene import Contact, Joint, Load, Material, Rope, Scene, Straight, Tie

CORD = Material(EA=1e4, mass_per_length=0.2)


def of(lengths: list[float], *, touching: bool, tied: bool = False, drop: int = -1) -> float:
    """Weight times length of ropes in a row [J]."""
    ropes = [
        Rope(
            name=f"r{k}",
            segments=3 + k,
            length=length,
            diameter=0.01,
            made_of=CORD,
            loads=[Load(node=-1, mass=0.5)] if k == 1 else [],
            shape=Straight(start=(sum(lengths[:k]) + (0.0 if tied and k < 2 else k), 0, 0)),
        )
        for k, length in enumerate(lengths)
        if k != drop
    ]
    ties = [Tie(rope="r0", node=-1), Tie(rope="r1", node=0)]
    model = build(
        Scene(
            ropes=ropes,
            contact=Contact() if touching else None,
            joints=[Joint(name="knot", points=ties)] if tied else [],
            run={"duration": 0.1, "method": "sdirk2", "time_step": 1e-3},
        )
    )
    return float(turned_over(model.system, model.state))


def test_what_ropes_that_can_touch_may_turn_over_is_a_sum() -> None:
    """It was the weight times the length of all: a hundred times a rope's for ten of them."""
    one = of([2.0], touching=True)
    assert one == of([2.0], touching=False) == pytest.approx(9.81 * 0.4 * 2.0)
    assert of([2.0, 3.0, 1.0], touching=True) == pytest.approx(
        one + 9.81 * ((0.6 + 0.5) * 3.0 + 0.2)
    )


def test_tied_ropes_are_one() -> None:
    """With the twin: the same three ropes, of which none are."""
    both = 9.81 * (0.4 + 0.6 + 0.5) * 5.0
    assert of([2.0, 3.0], touching=False, tied=True) == pytest.approx(both)
    assert of([2.0, 3.0, 1.0], touching=True, tied=True) == pytest.approx(both + 9.81 * 0.2)
    assert of([2.0, 3.0, 1.0], touching=True) < 0.6 * both
