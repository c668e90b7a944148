"""What casts doubt on the numbers of a sheet stands beside them, in the summary."""

from __future__ import annotations

import ropewalk as rw
from ropewalk.scene import Anchor, Material, Rope, RunSettings
from ropewalk.scene.shapes import Straight
from unit.test_sheets import hung, words


def test_the_summary_says_what_casts_doubt_on_its_numbers() -> None:
    """Tension, utilisation and safety factor stood there alone, and pages later "Do not trust works, nor
    forces". A cord falls by implicit Euler; the twin in steps that are short enough.
    """
    cord = Rope(
        segments=4,
        length=2.0,
        made_of=Material(EA=300.0, mass_per_length=0.1, tension_only=True),
        shape=Straight(start=(0, 0, 0), end=(2, 0, 0)),
    )
    for step, warned in ((0.02, True), (2e-4, False)):
        run = RunSettings(duration=1.0, method="implicit-euler", time_step=step)
        job = rw.sheet(hung(ropes=[cord], anchors=[Anchor(node=0)], run=run), convergence=False)
        said, later = words(job.section("Summary")), words(job.section("The run"))
        assert "Convergence: Not looked at" in said
        assert ("The largest tension in the run: implicit-euler lost" in said) is warned
        assert ("The largest tension: implicit-euler lost" in later) is warned
        assert ("see what is said of its energy under Method" in said) is warned
