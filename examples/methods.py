"""The order of every method, measured: half the step, and the error is 2, 4 or 16 times smaller."""

import math

import numpy as np

from ropewalk import Anchor, Rope, RunSettings, Scene, Springs, simulate
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Straight

STEPS = (0.002, 0.001)  # s


def end(method: str, step: float) -> np.ndarray:
    """Where all nodes of a swinging rope are after half a second [m]."""
    springs = Springs(
        spring_constant=100.0, node_mass=0.1, spring_friction=0.02, segment_length=0.25
    )
    rope = Rope(segments=8, made_of=springs, shape=Straight(end=(2.0, 0.0, 0.0)))
    settings = RunSettings(
        duration=0.5, frame_rate=50.0, time_step=step, steps="exact", method=method
    )
    scene = Scene(ropes=[rope], anchors=[Anchor(node=0)], run=settings)
    return np.array(simulate(scene).positions[-1])


def run() -> dict[str, tuple[float, float]]:
    """Measure the error of every method with a step and with half of it [m]."""
    exact = end("rk4", STEPS[-1] / 20)
    return {
        name: tuple(float(np.abs(end(name, step) - exact).max()) for step in STEPS)
        for name in METHODS
    }


def order(errors: tuple[float, float]) -> float:
    """The order that two errors show."""
    return math.log2(errors[0] / errors[1])


def check(found: dict[str, tuple[float, float]]) -> None:
    """Every method has the order that it says it has."""
    for name, errors in found.items():
        assert abs(order(errors) - METHODS[name].order) < 0.25, (name, errors)


if __name__ == "__main__":
    results = run()
    print(f"{'method':20} {'error at':>10} {'error at':>11}")
    print(f"{'':20} {STEPS[0]:8} s {STEPS[1]:9} s   order")
    for name, errors in results.items():
        print(f"{name:20} {errors[0]:8.1e} m {errors[1]:9.1e} m   {order(errors):.2f}")
    check(results)
