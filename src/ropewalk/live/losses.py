"""What of the works of all laws is lost, and what is put in."""

from __future__ import annotations

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.laws.wheel_rows import RECORDED
from ropewalk.methods.recording import CONSERVATIVE, work_names

LOSSES = ("friction", *(law.name for law in NODE_LAWS))
_MOTOR, _OF_ROPES = ENTRIES.index("motor"), RECORDED.index("work of ropes")


def driven_work(books: Floats, wheels: Floats) -> float:
    """Return what moving and turning obstacles have put into ropes [J]: a part of the works of `LOSSES`.

    Of their `books` (k, 5) and `wheels` (w, 7) as recorded. What turns freely drives nothing: what
    ropes have done on it is no part of it.
    """
    return float(books[:, _MOTOR].sum() + wheels[:, _OF_ROPES].sum())


def losses_and_gifts(
    work: Floats, bending: bool, more: tuple[str, ...], driven: float = 0.0
) -> tuple[float, float]:
    """Return the work [J] of what takes energy out, and of all else but springs and weight.

    `driven` is that of obstacles' drives, which the works of `LOSSES` have in them.
    """
    names = work_names(bending, more)
    losses = float(sum(work[i] for i, name in enumerate(names) if name in LOSSES)) - driven
    kept = float(sum(work[i] for i, name in enumerate(names) if name in CONSERVATIVE))
    return losses, float(work.sum()) - losses - kept
