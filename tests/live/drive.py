"""Driving a session in tests: commands by keyword, and what was refused."""

from __future__ import annotations

from typing import Any

import pytest

from ropewalk.live.commands import parse
from ropewalk.live.session import Session
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, SceneError, Slack
from ropewalk.scene.presets import preset


def r4() -> Session:
    """Return a session of the report's main scene."""
    return Session(preset("r4"), "r4")


def slack_rope(segments: int = 40, **more: Any) -> Scene:
    """Return a scene of one rope of a material between two anchors, sagging."""
    made_of = Material(EA=2e4, mass_per_length=0.2, axial_damping=2.0)
    rope = Rope(
        segments=segments,
        length=10.0,
        made_of=made_of,
        shape=Slack(start=(0.0, 0.0, 0.0), end=(8.0, 0.0, 0.0)),
    )
    return Scene(
        ropes=[rope],
        anchors=[Anchor(name="left", node=0), Anchor(name="right", node=-1)],
        run=RunSettings(duration=5.0, time_step=2e-4, method="semi-implicit-euler"),
        **more,
    )


def do(session: Session, kind: str, client: int = 1, **keys: Any) -> str:
    """Apply one command."""
    return session.apply(parse({"type": kind, **keys}), client)


def refused(session: Session, kind: str, **keys: Any) -> str:
    """Apply a command that is refused; return what is said."""
    with pytest.raises(SceneError) as caught:
        do(session, kind, **keys)
    return str(caught.value)
