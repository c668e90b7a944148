"""A session's variants at time zero: what a reset builds, and how it is refused where no rest is found.

To look for rest may take ten seconds. So what is asked for is frozen, built by any thread, and put in place
only while it still is what the session would begin with.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ropewalk.live.changes import Key, label_of
from ropewalk.live.parameters import initial, named, refusal
from ropewalk.live.track import Track
from ropewalk.scene import Scene, SceneError

if TYPE_CHECKING:
    from ropewalk.live.session import Session

AT_REST = "at-rest"
SET_BACK = "Give back what was changed (by the arrow beside its name), then reset"
LEAVE_OUT = "Leave that out of the link"


@dataclass(frozen=True)
class Variant:
    """What a variant has of its own."""

    label: str
    changes: Mapping[str, Any]
    given: bool  # label given by hand


@dataclass(frozen=True)
class Anew:
    """What a session begins with once it is reset."""

    loaded: Scene
    changes: Mapping[Key, Any]
    variants: tuple[Variant, ...]
    remedy: str = SET_BACK

    @classmethod
    def of(cls, session: Session, *, original: bool, remedy: str = SET_BACK) -> Anew:
        """Return what a session would begin with now, `original`: with the constants of its scene."""
        variants = [
            Variant(one.label, dict(one.changes), one.given)
            for one in session.tracks
        ]  # fmt: skip
        changes = {} if original else dict(session.changes)
        return cls(session.loaded, changes, tuple(variants), remedy)

    @property
    def settles(self) -> bool:
        """Whether rest is looked for."""
        return self.loaded.run.start == AT_REST

    def tracks(self) -> list[Track]:
        """Build the variants. Raises SceneError where they do not fit their shape, or have no rest."""
        scene = initial(self.loaded, self.changes)
        first, *others = self.variants
        made = [self._track(scene, Variant(first.label, {}, first.given))]
        for one in others:
            changed = scene
            for name, value in one.changes.items():
                changed = named(name).apply(changed, value)
            made.append(self._track(changed, one))
        return made

    def _track(self, scene: Scene, one: Variant) -> Track:
        try:
            made = Track(scene, one.label, one.changes)
        except SceneError as error:
            told = _told(self.changes, one.changes)
            if not (self.settles and told):
                raise
            found = "; ".join(fault.rule for fault in error.faults)
            rule = f"no rest is found with {told} in place of the scene's own. {self.remedy}. ({found})"
            raise refusal("", None, rule) from None
        made.given = one.given
        return made


def begun_with(kind: type[Session], scene: Scene, preset: str | None) -> Session:
    """Return a session of a scene whose constants are changed next, and which begins anew with them.

    Rest is not looked for: it is that of the changed scene that is wanted. Raises SceneError.
    """
    if scene.run.start != AT_REST:
        return kind(scene, preset)
    drawn = scene.replace(run=scene.run.replace(start="shape", ring=None))
    try:
        session = kind(drawn, preset)
    except SceneError:  # drawn so that nothing but its rest can run
        return kind(scene, preset)
    run = session.loaded.run.replace(start=scene.run.start, ring=scene.run.ring)
    session.start, session.loaded = (scene, preset), session.loaded.replace(run=run)
    return session


def _told(changes: Mapping[Key, Any], own: Mapping[str, Any]) -> str:
    """Return changed constants in words."""
    whole = {name: value for (name, rope), value in changes.items() if rope is None}
    ropes = {(name, rope): value for (name, rope), value in changes.items() if rope is not None}
    return label_of({**whole, **own}, ropes)
