"""Draw the pictures of contact in the docs: python docs/images/touching.py"""

from __future__ import annotations

import re
from pathlib import Path

import ropewalk as rw
from ropewalk import plots
from ropewalk.scene import loads

HERE = Path(__file__).parent
PILE = HERE.parent / "how-to" / "pile.md"


def main() -> None:
    """Run the scenes and draw them."""
    slides = rw.simulate("edge")
    plots.save(plots.film(slides, 6), HERE / "edge.png", dpi=75)
    plots.save(plots.film(rw.simulate("stairs"), 6), HERE / "stairs.png", dpi=75)
    holds = rw.simulate("capstan")
    plots.save(plots.sticking(holds), HERE / "sticking.png", dpi=75)
    found = re.search(r"```toml\n(.*?)```", PILE.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    heaps = rw.simulate(loads(found[1]))
    print(heaps, len(heaps.to_pandas("rope_contacts")))
    plots.save(plots.film(heaps, 6, plane="xz"), HERE / "pile.png", dpi=75)
    plots.save(plots.shape(heaps, [3.6], plane="xy"), HERE / "pile-above.png", dpi=75)


if __name__ == "__main__":
    main()
