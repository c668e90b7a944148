"""Steps in slices: as many as a tick has time for, the others in the next one."""

from __future__ import annotations

import time
from collections import deque
from dataclasses import dataclass

from ropewalk.core.status import OK
from ropewalk.live.inbox import Item
from ropewalk.live.parameters import refusal
from ropewalk.live.session import Session

MOST = 10_000  # that wait to be taken


def advance_within(session: Session, steps: int, seconds: float) -> int:
    """Advance by so many steps, or by fewer when the time is up; return how many.

    A slice begins with one step, of unknown cost, and takes half of the time left from then on. A single
    step is never divided. Fewer are returned, too, when the session breaks.
    """
    begun = time.perf_counter()
    done, now = 0, 1
    while done < steps:
        now = min(now, steps - done)
        if session.advance(now) != OK:
            return done
        done += now
        spent = time.perf_counter() - begun
        if spent >= 0.9 * seconds:
            return done
        now = max(1, int(0.5 * (seconds - spent) * done / max(spent, 1e-9)))
    return done


@dataclass
class _Asked:
    item: Item
    left: int


class Steps:
    """Steps that pages have asked for while the session pauses."""

    def __init__(self) -> None:
        self._asked: deque[_Asked] = deque()

    def __bool__(self) -> bool:
        return bool(self._asked)

    def ask(self, item: Item) -> None:
        """Take an order for steps. Raises SceneError when too many wait already."""
        count = item.what.count
        waiting = sum(one.left for one in self._asked)
        if waiting + count > MOST:
            rule = f"must be at most {MOST}, with the {waiting} that are still being taken"
            raise refusal("count", count, rule)
        self._asked.append(_Asked(item, count))

    def take(self, session: Session, seconds: float) -> list[Item]:
        """Take steps for so long; return the orders that are done."""
        first = self._asked[0]
        first.left -= advance_within(session, first.left, seconds)
        if session.broken is not None:
            return self.end()
        return [self._asked.popleft().item] if first.left <= 0 else []

    def end(self) -> list[Item]:
        """Forget all orders; return them."""
        items = [one.item for one in self._asked]
        self._asked.clear()
        return items
