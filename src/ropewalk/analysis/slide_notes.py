"""What `check` says of slides: how far off their ropes loads hang.

By default a slide is no stiffer than a segment of its rope, about, so that a force F hangs some F h / EA off
the curve, where that is more than `laws.slides.sliding.SINK` of a segment h.
"""

from __future__ import annotations

import math

from ropewalk.laws.slides.sliding import SINK, known_pulls
from ropewalk.lowering import Model
from ropewalk.lowering.system import tied_masses
from ropewalk.statics.pressing import rounded
from ropewalk.statics.touches import OFF

_CENT = 100.0


def slide_warnings(model: Model) -> list[str]:
    """Return a sentence for every slide whose known load hangs off its rope; none where it was told to."""
    scene, table = model.scene, model.system.node.slide
    if not scene.slides:
        return []
    whole, gravity = tied_masses(scene), math.hypot(*scene.gravity)
    pulls = known_pulls(scene.slides, model.layout, scene.ropes, whole, gravity)
    found = []
    for row, (slide, pull) in enumerate(zip(scene.slides, pulls, strict=True)):
        off, segment = pull / float(table.stiffness[row]), float(table.length[row])
        if slide.compliance is None and off > OFF * segment:
            found.append(
                f"slide {slide.name!r}: what hangs on it ({pull:.4g} N) is {1e3 * off:.3g} mm off rope "
                f"{slide.on!r}, {_CENT * off / segment:.3g} % of a segment, as the slide is no stiffer than "
                "steps for these ropes allow for; give it a compliance of at most "
                f"{rounded(SINK * segment / pull)} m/N where that matters (explicit methods then need "
                "shorter steps), or more segments"
            )
    return found
