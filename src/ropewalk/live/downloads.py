"""Downloads: made one at a time in files of their own, which are gone when they are sent."""

from __future__ import annotations

import asyncio
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

from starlette.concurrency import run_in_threadpool
from starlette.responses import FileResponse, PlainTextResponse, Response
from starlette.types import Receive, Scope, Send

MOST = 8  # that are made, wait or are being sent

Make = Callable[[Path], tuple[Path, str]]  # takes a folder; returns a file in it, and its type


class Download(FileResponse):
    """A file that is deleted, with its folder, when it was sent or nobody wants it any more."""

    def __init__(self, path: Path, kind: str, name: str, over: Callable[[], None]) -> None:
        super().__init__(path, media_type=kind, filename=name)
        self._over = over

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._over()


class Downloads:
    """Makes files when they are asked for."""

    def __init__(self) -> None:
        self._turn = asyncio.Lock()
        self._count = 0

    async def make(self, make: Make, name: str) -> Response:
        """Return what `make` makes, when it is its turn; raises as that does."""
        if self._count >= MOST:
            text = f"{MOST} downloads are under way already; try again when one is done\n"
            return PlainTextResponse(text, 503, headers={"retry-after": "5"})
        self._count += 1
        folder = Path(tempfile.mkdtemp(prefix="ropewalk-"))

        def over() -> None:
            self._count -= 1
            shutil.rmtree(folder, ignore_errors=True)

        try:
            async with self._turn:
                path, kind = await run_in_threadpool(make, folder)
        except BaseException:
            over()
            raise
        return Download(path, kind, name, over)
