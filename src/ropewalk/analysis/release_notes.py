"""What `check` says of anchors that let go at the surface of an obstacle, half the rope inside."""

from __future__ import annotations

from ropewalk.lowering import Model
from ropewalk.lowering.release_checks import releases_inside


def release_warnings(model: Model) -> list[str]:
    """Return a sentence for every anchor whose node a contact will throw out as it lets go."""
    scene, until = model.scene, model.scene.run.duration
    return [
        f"{one.path}: {scene.anchors[one.anchor].release_time:g} s - it lets go {1e3 * one.depth:.3g} mm "
        f"inside {scene.obstacles[one.obstacle].name!r}, half the rope's diameter counted in: the "
        f"contact, which nothing presses before, throws its node out with up to {one.speed:.2g} m/s; hold it "
        f"{1e3 * one.depth:.3g} mm farther out"
        for one in releases_inside(scene, model.system, model.state, until)
    ]
