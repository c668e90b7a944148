"""Makes scene and model of every run: once whole, then only what its values change.

The model of a run is that of the one before but for the pieces that other values change (`lowering.pieces`),
and so is the scene; runs of one layout, method and set of laws share all else. Both are equal, bit for bit,
to those made anew.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ropewalk.lowering import Model, Pieces, build
from ropewalk.scene import Scene
from ropewalk.scene.overrides import Places
from ropewalk.sweeps.parameters import TEXT


class Workshop:
    """Makes the scene and the model of every run of a sweep; not for two threads at once.

    With `stepped` off of every equilibrium, as `build` does.
    """

    def __init__(
        self, scene: Scene, paths: Sequence[str], kinds: Sequence[str], *, stepped: bool = True
    ) -> None:
        self._places = Places(scene, paths)
        self._kinds = tuple(kinds)
        self._stepped = stepped
        self.pieces = Pieces()

    def scene(self, values: Sequence[Any]) -> Scene:
        """Return the scene with these values. Raises SceneError with every fault."""
        from ropewalk.scene.toml_text import as_value

        pairs = zip(values, self._kinds, strict=True)
        return self._places.scene([as_value(v) if kind == TEXT else v for v, kind in pairs])

    def model(self, values: Sequence[Any]) -> Model:
        """Return the model of a run. Raises SceneError when it cannot be planned."""
        return build(self.scene(values), self.pieces, stepped=self._stepped)
