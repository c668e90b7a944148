"""GIF files written picture by picture, so that memory does not grow with their number."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import BinaryIO

from PIL import GifImagePlugin, Image, ImageChops

_CENTI = 100  # GIF counts the time of a picture in hundredths of a second


class GifWriter:
    """Writes a looping GIF with one palette for all pictures.

    Each picture holds only what differs from the one before. The times shown are rounded so that they
    add up: picture n ends at round(100 n / fps) hundredths of a second.
    """

    def __init__(self, path: Path, size: tuple[int, int], fps: float, palette: Image.Image) -> None:
        self._palette, self._fps = palette, fps
        self._count = 0
        self._waiting: Image.Image | None = None  # written when it is known how long it stays
        self._box = (0, 0, *size)
        self._centis = 0  # that the waiting picture has gained from equal ones after it
        self._file: BinaryIO = path.open("wb")
        colours = palette.getpalette() or []
        table = bytes((*colours, *[0] * (768 - len(colours))))
        self._file.write(b"GIF89a" + struct.pack("<HHBBB", *size, 0xF7, 0, 0) + table)
        self._file.write(b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00")

    def add(self, picture: Image.Image) -> None:
        """Append a picture (RGB) of the GIF's size."""
        image = picture.quantize(palette=self._palette, dither=Image.Dither.NONE)
        if self._waiting is None:
            self._waiting = image
        else:
            before = self._waiting
            difference = ImageChops.difference(_indices(before), _indices(image))
            self._write()
            self._waiting, self._box = image, difference.getbbox() or (0, 0, 1, 1)
        self._count += 1

    def _write(self) -> None:
        """Write the waiting picture."""
        assert self._waiting is not None
        until = round(_CENTI * self._count / self._fps)
        part = self._waiting.crop(self._box)
        duration = (until - self._centis) * 10
        for block in GifImagePlugin.getdata(part, self._box[:2], duration=duration, disposal=1):
            self._file.write(block)
        self._centis = until

    def close(self) -> None:
        """Write the last picture and the end."""
        try:
            if self._waiting is not None:
                self._write()
            self._file.write(b";")
        finally:
            self._file.close()

    def abort(self) -> None:
        """Close the file as it is."""
        self._file.close()


def _indices(image: Image.Image) -> Image.Image:
    """The palette indices as grey values, which can be compared."""
    return Image.frombytes("L", image.size, image.tobytes())


def make_palette(colours: list[tuple[int, int, int]]) -> Image.Image:
    """Return a palette image of these colours (at most 256 of them)."""
    palette = Image.new("P", (1, 1))
    flat = [part for colour in colours[:256] for part in colour]
    palette.putpalette(flat + flat[:3] * (256 - len(flat) // 3))
    return palette
