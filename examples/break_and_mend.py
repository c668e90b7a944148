"""A run that breaks: predicted before, explained after, mended by the number that it names."""

from ropewalk import Result, Scene, preset, simulate
from ropewalk import check as check_scene
from ropewalk.analysis.check import Check
from ropewalk.scene import apply_overrides


def run() -> tuple[Check, Result, Result]:
    """Run the report's rope with springs that are too stiff for its step, then with a better step."""
    scene: Scene = preset("r7")
    said = check_scene(scene)
    broken = simulate(scene, on_failure="return")
    step = 0.99 * said.stability.bound
    mended = simulate(apply_overrides(scene, [f"time_step={step}", "duration=3"]))
    return said, broken, mended


def check(found: tuple[Check, Result, Result]) -> None:
    """The prediction comes true, the break is kept up to the last good frame, the mended run ends."""
    said, broken, mended = found
    assert not said.ok
    assert broken.status == "broke"
    assert broken.time[-1] < said.duration
    assert mended.status == "finished"


if __name__ == "__main__":
    before, result, better = run()
    check((before, result, better))
    print("before: ", before.warnings[0])
    print("after:  ", result.diagnosis)
    print("mended: ", better)
