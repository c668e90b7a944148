"""Views from Python: the caller's own loop, a playing scene, a result; and in a notebook."""

from __future__ import annotations

import json
from pathlib import Path
from urllib.error import HTTPError
from urllib.request import urlopen

import numpy as np
import pytest

import ropewalk as rw
from live.drive import slack_rope
from live.pages import HEADER, Page
from patience import PATIENCE
from ropewalk.live.view import View
from ropewalk.record.errors import RunError


@pytest.fixture
def options() -> dict[str, object]:
    return {"port": 0, "open_browser": False}


def page_of(view: View) -> Page:
    return Page(view._server)


def fetched(view: View, path: str) -> bytes:
    with urlopen(f"{view.address}replay/{path}", timeout=PATIENCE) as answer:
        data: bytes = answer.read()
    return data


def test_the_loop_stays_with_the_program(options: dict[str, object]) -> None:
    simulation = rw.Simulation(slack_rope(20))
    trail: dict[float, np.ndarray] = {}

    def stepped() -> bool:
        simulation.step()
        trail[simulation.time] = simulation.positions.copy()
        view.update()
        return True

    with simulation.view(**options) as view, page_of(view) as page:
        page.until(lambda: stepped() and page.frames)
        assert page.message("hello")["mode"] == "program"
        page.send("grab", node=10, target=[4.0, 0.0, 2.0], id=1)
        page.until(lambda: stepped() and page.frames[-1][3] & 8)
        assert np.abs(simulation.arrays.forces.applied[:, 10]).max() > 0.0
        page.send("set", name="mass", value=1.0, id=2)
        page.until(lambda: stepped() and any(m.get("id") == 2 for m in page.messages))
        assert page.message("error", id=2)["text"].startswith("This command cannot be done here")
        where = page.message("layout")["variants"][0]["offsets"]["positions"]
        shown = np.frombuffer(page.data, "<f4", 3 * 21, where).reshape(21, 3)
        assert shown == pytest.approx(trail[page.frames[-1][4]], abs=1e-5)
    assert simulation.time > 0.0
    view.update()  # closed: nothing happens


def test_a_page_that_comes_after_the_loop_sees_its_end(options: dict[str, object]) -> None:
    simulation = rw.Simulation(slack_rope(20))
    with simulation.view(**options) as view:
        with page_of(view) as page:  # before the first step
            page.until(lambda: page.frames)
            assert page.frames[-1][4] == 0.0
        for _ in range(30):
            simulation.step()
            view.update()
        with page_of(view) as page:  # as in a notebook, whose kernel is at rest by now
            page.until(lambda: page.frames)
            assert page.frames[-1][4] == simulation.time
            where = page.message("layout")["variants"][0]["offsets"]["positions"]
            shown = np.frombuffer(page.data, "<f4", 3 * 21, where).reshape(21, 3)
            assert shown == pytest.approx(simulation.positions, abs=1e-5)


def test_a_view_does_not_change_what_it_shows(options: dict[str, object]) -> None:
    plain, shown = (rw.Simulation(slack_rope(20)) for _ in range(2))
    with shown.view(**options) as view:
        for _ in range(30):
            plain.step()
            shown.step()
            view.update()
    assert np.array_equal(plain.positions, shown.positions)


def test_a_scene_plays_by_itself(options: dict[str, object], tmp_path: Path) -> None:
    with slack_rope(20).view(folder=tmp_path / "run", **options) as view, page_of(view) as page:
        page.until(lambda: page.frames and page.frames[-1][4] > 0.1)
        assert view.folder == tmp_path / "run"
    assert rw.Result.open(tmp_path / "run").frames > 1


def test_a_result_is_replayed(options: dict[str, object]) -> None:
    scene = slack_rope(20)
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.5)))
    with result.view(playing=False, **options) as view, page_of(view) as page:
        assert page.message("hello")["mode"] == "replay"
        run = page.message("replay")
        assert run["duration"] == pytest.approx(0.5, abs=0.01)
        assert not run["playing"]
        (part,) = run["parts"]
        assert part["frames"] == result.frames
        times = np.frombuffer(fetched(view, "times.bin"), "<f8")
        np.testing.assert_array_equal(times, result.time)
        frame = result.frame_at(0.25)
        data = fetched(view, f"frames.bin?first={frame}&count=1")
        assert HEADER.unpack_from(data)[4] == pytest.approx(result.time[frame])
        layout = json.loads(fetched(view, "layout.json?part=0"))
        where = layout["variants"][0]["offsets"]["positions"]
        shown = np.frombuffer(data, "<f4", 3 * 21, where).reshape(21, 3)
        assert shown == pytest.approx(result.positions[frame], abs=1e-5)
        assert "in a replay" in page.ask(2, "play")["text"]  # the page plays, not the server
        assert "in a replay" in page.ask(3, "cut", segment=1)["text"]
        last = fetched(view, f"frames.bin?first=0&count={result.frames}")[-layout["bytes"] :]
        assert HEADER.unpack_from(last)[3] & 16
        view.update()  # nothing to show anew
    with slack_rope(20).view(**options) as live, pytest.raises(HTTPError, match="404"):
        fetched(live, "times.bin")


@pytest.mark.parametrize(
    ("path", "code", "words"),
    [
        ("frames.bin?first=-1", 404, "no such frames"),
        ("frames.bin?count=4097", 404, "no such frames"),
        ("frames.bin?every=0", 404, "no such frames"),
        ("frames.bin?first=half", 400, "must be whole numbers"),
        ("layout.json?part=1", 404, "no such part"),
        ("layout.json?part=-1", 404, "no such part"),
    ],
)
def test_a_replay_says_what_it_has_not(
    options: dict[str, object], path: str, code: int, words: str
) -> None:
    scene = slack_rope(20)
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.1)))
    with result.view(**options) as view, pytest.raises(HTTPError) as caught:
        fetched(view, path)
    assert caught.value.code == code
    assert words in caught.value.read().decode()


def test_in_a_notebook_a_view_is_a_frame(options: dict[str, object]) -> None:
    with slack_rope(20).view(**options) as view:
        html = view._repr_html_()
        assert html.startswith("<iframe")
        assert view.address in html
        assert view.address in repr(view)
    assert repr(view) == "<View, closed>"


def test_without_the_packages_one_line_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("ropewalk.live.launch.NEEDS", ("starlette", "no_such_package"))
    with pytest.raises(RunError, match="no_such_package: needed .* pip install no_such_package"):
        slack_rope(5).view()


def test_what_is_not_kept_is_not_offered_to_be_saved(options: dict[str, object]) -> None:
    """The page had it in its menu, and said "Saved in null"."""
    with slack_rope(5).view(playing=False, **options) as view, Page(view._server) as page:
        assert "save" not in page.message("hello")["can"]
        assert "cannot be done here" in page.ask(1, "save")["text"]
