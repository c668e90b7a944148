"""The writer's thread: one task at a time, in order, and nothing that it raises is lost."""

from __future__ import annotations

import threading

import pytest

from patience import PATIENCE
from ropewalk.record.run import Background


def test_tasks_run_one_after_another_beside_the_caller() -> None:
    done: list[int] = []
    gate = threading.Event()
    with Background() as beside:
        beside.start(lambda: (gate.wait(PATIENCE), done.append(0))[1])
        assert done == []  # the caller goes on while the task waits
        gate.set()
        for i in range(1, 20):
            beside.start(lambda i=i: done.append(i))  # type: ignore[misc]
            assert done[:i] == list(range(i))  # the one before is done
        beside.wait()
        assert done == list(range(20))


def test_the_end_waits_for_the_last_task() -> None:
    done: list[int] = []
    gate = threading.Event()
    with Background() as beside:
        beside.start(lambda: (gate.wait(PATIENCE), done.append(1))[1])
        threading.Timer(0.05, gate.set).start()
    assert done == [1]


class Full(Exception):  # noqa: N818 - as the system names it
    """Stands for a full disk."""


def fail() -> None:
    raise Full


def test_what_a_task_raises_comes_out_once() -> None:
    with Background() as beside:
        beside.start(fail)
        with pytest.raises(Full):
            beside.start(lambda: pytest.fail("ran after a failure"))
        beside.wait()
    with pytest.raises(Full), Background() as beside:  # at the end at the latest
        beside.start(fail)


def test_an_error_of_the_caller_goes_before_that_of_the_task() -> None:
    with pytest.raises(KeyError), Background() as beside:  # noqa: PT012 - both raise
        beside.start(fail)
        raise KeyError
