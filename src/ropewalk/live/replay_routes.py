"""What a page fetches of a run that it replays: times, layouts, frames in pieces."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterator
from itertools import chain
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response, StreamingResponse
from starlette.routing import Route

from ropewalk.live.hub import as_text
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.record.errors import RunError

MOST_FRAMES = 4096
_BYTES = "application/octet-stream"
_NONE = b""


def replay_routes(broadcast: Any) -> list[Route]:
    """Return the routes of a broadcast that is a replay, none for another one."""
    if not isinstance(broadcast, ReplayBroadcast):
        return []

    async def times() -> Response:
        return Response(broadcast.times.astype("<f8").tobytes(), media_type=_BYTES)

    async def layout(part: int) -> Response:
        if not 0 <= part < len(broadcast.parts):
            return PlainTextResponse("no such part\n", 404)
        try:
            made = await run_in_threadpool(broadcast.layout, part)
        except RunError as error:
            return PlainTextResponse(f"{error}\n", 500)
        return Response(as_text(made), media_type="application/json")

    async def frames(first: int, count: int, every: int) -> Response:
        if first < 0 or not 0 < count <= MOST_FRAMES or every < 1:
            return PlainTextResponse("no such frames\n", 404)
        try:
            made = await run_in_threadpool(_begun, broadcast.frames_between(first, count, every))
        except RunError as error:
            return PlainTextResponse(f"{error}\n", 500)
        return StreamingResponse(made, media_type=_BYTES)

    return [
        Route("/replay/times.bin", _asked(times)),
        Route("/replay/layout.json", _asked(layout, part=0)),
        Route("/replay/frames.bin", _asked(frames, first=0, count=100, every=1)),
    ]


def _begun(frames: Iterator[bytes]) -> Iterator[bytes]:
    """Return frames of which the first is made, so that what is wrong with a run is known.

    They end before one that cannot be read: of that the next piece, which begins with it, tells.
    """
    return chain([next(frames, _NONE)], _whole(frames))


def _whole(frames: Iterator[bytes]) -> Iterator[bytes]:
    try:
        yield from frames
    except RunError:
        return


def _asked(what: Callable[..., Awaitable[Response]], **usual: int) -> Any:
    """Return what answers a request whose query has whole numbers, the usual ones where it has none."""

    async def answer(request: Request) -> Response:
        try:
            asked = {
                name: int(request.query_params.get(name, value)) for name, value in usual.items()
            }
        except ValueError:
            return PlainTextResponse(f"{', '.join(usual)} must be whole numbers\n", 400)
        return await what(**asked)

    return answer
