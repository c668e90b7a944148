"""Hands in wall time: what is held is drawn where the pointer is, however late the simulation follows."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from browser.window import Window
from live.drive import slack_rope
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Slack

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
ROPES, NODES = 10, 1000
# Where the rings of hands and the lines to what they hold were in the first picture after the pointer's move.
WATCH = """() => {
  const { viewport } = window.ropewalk;
  window.seen = null;
  let moved = null;
  addEventListener("pointermove", (event) => (moved = [event.clientX, event.clientY]), true);
  viewport.afterDraw.push(() => {
    if (!moved || viewport.marks.held.size === 0) return;
    const box = viewport.renderer.canvas.getBoundingClientRect();
    const at = (place) => {
      const [x, y] = viewport.camera.project(...place);
      return [x + box.left, y + box.top];
    };
    const { markers, arrows } = viewport.marks.collect();
    const rings = markers.filter(({ kind }) => kind === "ring").map(({ x, y, z }) => at([x, y, z]));
    const lines = arrows.filter(({ head }) => !head).map(({ from, to }) => [at(from), at(to)]);
    window.seen = { pointer: moved, rings, lines };
  });
}"""


@pytest.mark.parametrize("what", ["anchor", "node"])
def test_what_is_held_is_drawn_at_the_pointer_before_the_rope_follows(
    open_window: Open, serve: Serve, what: str
) -> None:
    """The server pauses, so that nothing of it follows; the hand and a line to the rope are there at once."""
    window = open_window(serve(Session(slack_rope())).address).ready()
    window.settled()
    window.page.evaluate(WATCH)
    start = window.screen(0 if what == "anchor" else 20)
    window.drag(start, (30.0, -70.0))
    window.until(f"window.seen && Math.abs(window.seen.pointer[1] - {start[1] - 70.0}) < 1")
    window.settled()
    seen = window.ask("window.seen")
    pointer = np.array(seen["pointer"])
    assert min(np.linalg.norm(np.array(ring) - pointer) for ring in seen["rings"]) < 1.0
    ends = [(np.array(a), np.array(b)) for a, b in seen["lines"]]
    ties = [(a, b) for a, b in ends if np.linalg.norm(b - pointer) < 1.0]
    assert len(ties) == 1
    assert np.linalg.norm(ties[0][0] - start) < 3.0  # to where it is: the simulation stands still
    window.page.mouse.up()
    window.until("r.viewport.marks.held.size === 0")


def test_ten_thousand_nodes_are_led_in_wall_time(open_window: Open, serve: Serve) -> None:
    """The page knows how slow it goes though a drag comes with every picture; it took that for real time."""
    server = serve(Session(_many()), playing=True, folder=None)
    window = open_window(server.address).ready()
    window.until("r.time > 0.05 && r.session.status.slow")
    x, y = window.take(0, (-20.0, -10.0))
    paces = []
    for k in range(30):
        window.page.mouse.move(x - 20.0 - k, y - 10.0)
        window.until(f"r.frame > {window.ask('r.frame')}")
        paces += [one.pace for one in server.broadcast.session.main.hands.targets.values()]
    assert len(paces) > 20
    assert max(paces[10:]) < 0.5
    window.page.mouse.up()


def test_an_anchor_that_cannot_keep_up_says_why(open_window: Open, serve: Serve) -> None:
    """At a hundredth of real time the pointer is faster than any anchor; once there, no more is said."""
    server = serve(Session(slack_rope()), playing=True, folder=None)
    window = open_window(server.address).ready()
    said = "[...document.querySelectorAll('.labels span.grab')].filter((e) => !e.hidden)"
    said += ".map((e) => e.innerText)"
    assert window.tell(type="speed", value=0.01)
    window.take(0, (240.0, -240.0))  # some ten seconds away
    window.until(f"{said}.includes('30 m/s (no faster)')")
    main = server.broadcast.session.main
    velocity = np.linalg.norm(main.simulation.anchors[next(iter(main.hands.targets))].velocity)
    assert velocity == pytest.approx(30.0)
    assert window.tell(type="speed", value=1.0)
    window.until(f"{said}.length === 0")  # it is there now
    window.page.mouse.up()


def _many() -> Scene:
    made_of = Material(EA=5e4, mass_per_length=0.065, axial_damping=2.0)
    names = [f"rope{i}" for i in range(ROPES)]
    return Scene(
        ropes=[
            Rope(
                name=name,
                segments=NODES - 1,
                length=10.0,
                made_of=made_of,
                shape=Slack(start=(0.0, float(i), 0.0), end=(8.0, float(i), 0.0)),
            )
            for i, name in enumerate(names)
        ],
        anchors=[
            Anchor(name=f"{name}-{end}", rope=name, node=node)
            for name in names
            for end, node in (("a", 0), ("b", -1))
        ],
        run=RunSettings(time_step=1e-3, method="implicit-euler"),
    )
