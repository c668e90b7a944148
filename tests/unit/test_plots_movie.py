"""Movies: right number of pictures, right duration, right colours, nothing half written."""

from __future__ import annotations

import stat

import numpy as np
import pytest
from PIL import Image

from ropewalk import plots
from ropewalk.plots.gif import GifWriter, make_palette
from ropewalk.plots.movies import _Painter, decimals, stage, window_box
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import apply_overrides
from ropewalk.scene.presets import preset


@pytest.fixture(scope="module")
def rope():
    return simulate_in_memory(apply_overrides(preset("n40"), ["run.duration=1.0"]))


def durations(path):
    """Milliseconds that every picture stays."""
    with Image.open(path) as image:
        found = []
        for number in range(image.n_frames):
            image.seek(number)
            found.append(image.info["duration"])
        return found


def test_no_two_pictures_of_a_slow_film_have_one_time() -> None:
    """At a thousandth of real time all pictures within 10 ms said 0.12 s. At real time two decimals do."""
    for fps, speed, places in ((25.0, 1.0, 2), (25.0, 1e-3, 5), (60.0, 1.0, 2), (50.0, 1e-2, 4)):
        assert decimals(speed / fps) == places
        stamps = {f"{0.12 + speed / fps * k:.{places}f}" for k in range(40)}
        assert len(stamps) == 40


@pytest.mark.parametrize(
    ("fps", "speed", "count"), [(25.0, 1.0, 26), (30.0, 1.0, 31), (20.0, 0.5, 41)]
)
def test_gif_has_its_pictures_and_plays_for_its_time(rope, tmp_path, fps, speed, count):
    seen = []
    path = plots.movie(
        rope,
        tmp_path / "rope.gif",
        fps=fps,
        size=(320, 240),
        speed=speed,
        progress=lambda done, total: seen.append((done, total)),
    )
    times = durations(path)
    assert len(times) == count
    assert abs(sum(times) - 1000 * count / fps) <= 5  # GIF counts hundredths of a second
    assert seen == [(i + 1, count) for i in range(count)]
    assert [p.name for p in tmp_path.iterdir()] == ["rope.gif"]


def test_a_window_is_all_in_the_picture_and_widened_to_fill_it(rope):
    box = stage(rope, "xy", (640, 360), window_box((0.0, 1.0, -0.1, 0.1))).box
    assert (box.left, box.right) == (0.0, 1.0)
    assert box.low == pytest.approx(-box.high)
    assert box.high > 0.1
    whole = stage(rope, "xy", (640, 360)).box
    assert whole.right - whole.left > 1.5


@pytest.mark.parametrize("size", [(600, 260), (900, 260), (900, 200)])
def test_the_words_below_a_low_wide_picture_are_inside_it(rope, size):
    """Laid out once, "x [m]" stood up to 3 pixels below the picture: where that is 260 high, it was cut."""
    seen = stage(rope, None, size, window_box((-1.2, 1.1, -0.05, 0.75)))
    painter = _Painter(rope, seen, size, 1.0, 2)
    assert painter._axes.xaxis.label.get_window_extent().y0 > 4.0


def test_pictures_are_white_and_change(rope, tmp_path):
    path = plots.movie(rope, tmp_path / "rope.gif", fps=10, size=(320, 240))
    with Image.open(path) as image:
        first = np.asarray(image.convert("RGB"))
        image.seek(image.n_frames - 1)
        last = np.asarray(image.convert("RGB"))
    assert first.shape == (240, 320, 3)
    assert tuple(first[-1, -1]) == (255, 255, 255)
    assert (first == 255).all(axis=2).mean() > 0.5
    assert (first != last).any(axis=2).sum() > 100


def test_a_broken_run_makes_a_movie(tmp_path):
    scene = apply_overrides(preset("r6"), ["run.duration=2.0"])
    result = simulate_in_memory(scene, keep_going=True)
    path = plots.movie(result, tmp_path / "b.gif", fps=10, size=(320, 240), speed=0.05)
    assert len(durations(path)) > 10


def test_equal_pictures_keep_their_places(tmp_path):
    palette = make_palette([(255, 255, 255), (0, 0, 0)])
    writer = GifWriter(tmp_path / "a.gif", (20, 10), 30.0, palette)
    pictures = [Image.new("RGB", (20, 10), colour) for colour in ("white", "white", "black")]
    for picture in pictures:
        writer.add(picture)
    writer.close()
    assert durations(tmp_path / "a.gif") == [30, 40, 30]
    with Image.open(tmp_path / "a.gif") as image:
        for number, picture in enumerate(pictures):
            image.seek(number)
            assert image.convert("RGB").tobytes() == picture.tobytes()


def test_mp4_without_ffmpeg_says_so(rope, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(plots.MovieError, match="needs the program ffmpeg"):
        plots.movie(rope, tmp_path / "rope.mp4")
    assert not list(tmp_path.iterdir())


def fake_ffmpeg(folder, script, monkeypatch):
    """A stand-in for ffmpeg, which is not on every machine."""
    program = folder / "ffmpeg"
    program.write_text(f"#!/bin/sh\n{script}\n")
    program.chmod(program.stat().st_mode | stat.S_IEXEC)
    monkeypatch.setenv("PATH", str(folder), prepend=":")


def test_mp4_gets_every_picture_raw(rope, tmp_path, monkeypatch):
    (tmp_path / "bin").mkdir()
    fake_ffmpeg(tmp_path / "bin", 'for last; do :; done; cat > "$last"', monkeypatch)
    path = plots.movie(rope, tmp_path / "rope.mp4", fps=10, size=(320, 240))
    assert path.stat().st_size == 11 * 320 * 240 * 3


def test_words_of_a_failing_ffmpeg_are_passed_on(rope, tmp_path, monkeypatch):
    (tmp_path / "bin").mkdir()
    fake_ffmpeg(tmp_path / "bin", "echo 'Unknown encoder' >&2; exit 1", monkeypatch)
    with pytest.raises(plots.MovieError, match="ffmpeg failed: Unknown encoder"):
        plots.movie(rope, tmp_path / "rope.mp4", fps=10, size=(320, 240))
    assert [p.name for p in tmp_path.iterdir()] == ["bin"]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"fps": 0.0}, "fps: 0.0 - must be above 0 and at most 50"),
        ({"fps": 60.0}, "fps: 60.0 - must be above 0 and at most 50"),
        ({"speed": -1.0}, "speed: -1.0 - must be positive"),
        ({"speed": float("nan")}, "speed: nan - must be positive"),
        ({"size": (10, 10)}, "size: (10, 10) - must be two numbers of pixels"),
        ({"window": (1, 0, 0, 1)}, "window: (1, 0, 0, 1) - must be left, right, low and high [m]"),
        ({"window": (0, 1, 0)}, "window: (0, 1, 0) - must be left, right, low and high [m]"),
        ({"window": ("a", 1, 0, 1)}, "window: ('a', 1, 0, 1) - must be left, right, low and high"),
        ({"window": 2.0}, "window: 2.0 - must be left, right, low and high [m]"),
        ({"window": (0, float("inf"), 0, 1)}, "must be left, right, low and high [m]"),
    ],
)
def test_what_makes_no_movie_is_refused(rope, tmp_path, change, words):
    with pytest.raises(ValueError) as caught:  # noqa: PT011 - the words are checked below
        plots.movie(rope, tmp_path / "rope.gif", **change)
    assert words in str(caught.value)
    with pytest.raises(ValueError, match="must end in .gif or .mp4"):
        plots.movie(rope, tmp_path / "rope.avi")
