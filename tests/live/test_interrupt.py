"""Ctrl-C while the main thread waits for the server: it is still waited for when it is told to end."""

from __future__ import annotations

import signal
import sys
import threading
import time
from types import FrameType
from typing import Any

import pytest

from patience import PATIENCE
from ropewalk.live.serve import ViewServer

BUSY = 0.5  # [s] that the server has no time to look whether it should end


def waits(frame: FrameType | None) -> bool:
    """Whether what runs in a frame was called by `ViewServer.wait`."""
    while frame is not None and frame.f_code is not ViewServer.wait.__code__:
        frame = frame.f_back
    return frame is not None


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="a signal to one thread")
def test_a_server_whose_wait_was_interrupted_ends_before_its_socket_is_closed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    failures: list[Any] = []
    monkeypatch.setattr(threading, "excepthook", failures.append)
    server = ViewServer(port=0)
    server.start()
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # it may be ignored
    here = threading.main_thread().ident
    assert here is not None

    def interrupt() -> None:
        while not waits(sys._current_frames()[here]):
            time.sleep(0.01)
        signal.pthread_kill(here, signal.SIGINT)

    threading.Thread(target=interrupt, daemon=True).start()
    try:
        with pytest.raises(KeyboardInterrupt):
            server.wait(PATIENCE)
    finally:
        signal.signal(signal.SIGINT, before)
    assert server.wait(0.0)
    server.hub._call(time.sleep, BUSY)
    server.stop()
    assert not server.wait(0.0)
    time.sleep(0.2)  # for what a server that goes on would say
    assert failures == []
