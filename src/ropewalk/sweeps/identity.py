"""What decides the bits that a sweep keeps: those of its runs, and what is made of them."""

from __future__ import annotations

import hashlib
from functools import cache

import numba
import numpy as np

from ropewalk.core.cache import PACKAGE
from ropewalk.record.identity import meaning, source_hash

#: Beside the sources of a run: what reads, reduces and keeps its numbers, and what is noted of them.
KEPT_BY = (
    "record/balances.py",
    "record/body_energies.py",
    "record/body_loads.py",
    "record/books.py",
    "record/borne.py",
    "record/contact_modes.py",
    "record/contacts.py",
    "record/deep_note.py",
    "record/drums.py",
    "record/end_weight.py",
    "record/ends.py",
    "record/event_log.py",
    "record/extremes.py",
    "record/facts.py",
    "record/good.py",
    "record/happenings.py",
    "record/hard_stops.py",
    "record/joined_ropes.py",
    "record/landings.py",
    "record/limiter_at_rest.py",
    "record/limiter_note.py",
    "record/margins.py",
    "record/moment_notes.py",
    "record/note_kinds.py",
    "record/parted.py",
    "record/peak_energy.py",
    "record/pressed_rows.py",
    "record/quantities.py",
    "record/rest.py",
    "record/result.py",
    "record/ringing_note.py",
    "record/rope_contact_table.py",
    "record/seen_along.py",
    "record/source.py",
    "record/speed_note.py",
    "record/stood.py",
    "record/sudden_anchors.py",
    "record/tension_notes.py",
    "record/too_low.py",
    "record/turnover.py",
    "sweeps/batch.py",
    "sweeps/derived.py",
    "sweeps/keep.py",
    "sweeps/workshop.py",
)


@cache
def sweep_hash() -> str:
    """Return a hash of all sources, and of numpy and numba, that decide what a sweep keeps."""
    digest = hashlib.sha256(f"{source_hash()} {np.__version__} {numba.__version__}".encode())
    for name in KEPT_BY:
        digest.update(f"{name} {meaning((PACKAGE / name).read_bytes())}\n".encode())
    return digest.hexdigest()[:16]
