"""MP4 files, by way of ffmpeg where it is installed."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from contextlib import suppress
from pathlib import Path

from PIL import Image


class MovieError(RuntimeError):
    """A movie that cannot be made; the message says what to do."""


class Mp4Writer:
    """Pipes pictures into ffmpeg one by one."""

    def __init__(self, path: Path, size: tuple[int, int], fps: float) -> None:
        program = shutil.which("ffmpeg")
        if program is None:
            raise MovieError(
                "an MP4 needs the program ffmpeg, which was not found on the PATH; install it, or "
                "give the movie a name that ends in .gif"
            )
        source = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{size[0]}x{size[1]}"]
        source += ["-framerate", f"{fps:g}", "-i", "-"]
        # Players want even sizes and yuv420p; the index first lets a browser start at once.
        target = ["-an", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264"]
        target += ["-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4", str(path)]
        self._said = tempfile.TemporaryFile()  # noqa: SIM115 - closed with the writer
        self._process = subprocess.Popen(
            [program, "-y", "-loglevel", "error", *source, *target],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._said,
        )

    def add(self, picture: Image.Image) -> None:
        """Append a picture (RGB)."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(picture.tobytes())
        except BrokenPipeError:
            self.close()

    def close(self) -> None:
        """Wait for ffmpeg to finish. Raises MovieError with its words when it fails."""
        assert self._process.stdin is not None
        with suppress(BrokenPipeError):
            self._process.stdin.close()
        code = self._process.wait()
        self._said.seek(0)
        words = self._said.read().decode(errors="replace").strip().splitlines()
        self._said.close()
        if code != 0:
            raise MovieError(f"ffmpeg failed: {words[-1] if words else f'exit status {code}'}")

    def abort(self) -> None:
        """Stop ffmpeg."""
        self._process.kill()
        self._process.wait()
        self._said.close()
