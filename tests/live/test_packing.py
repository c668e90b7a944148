"""Numbers of a shared page: packed and unpacked in Python, as in the page."""

from __future__ import annotations

import base64
import json
from pathlib import Path

import numpy as np
import pytest

from ropewalk.live.packing import LARGEST, Packed, pack, unpack

# What the page's own test unpacks, page/test/unpack.test.js.
FILE = Path(__file__).resolve().parents[2] / "page/test/packed.json"


@pytest.mark.parametrize("stream", json.loads(FILE.read_text())["streams"])
def test_the_pages_test_unpacks_what_is_packed_here(stream: dict) -> None:  # type: ignore[type-arg]
    header, values = stream["header"], np.array(stream["values"])
    made = pack(header["name"], values, np.array(header["step"]))
    told = made.header()
    assert {key: told[key] for key in ("order", "planes", "columns")} == {
        key: header[key] for key in ("order", "planes", "columns")
    }
    kept = Packed(
        header["name"],
        header["columns"],
        header["low"],
        header["step"],
        header["order"],
        header["planes"],
        base64.b64decode(stream["data"]),
        0.0,
    )
    for one in (made, kept):
        away = np.abs(unpack(one, len(values)) - values)
        assert (away <= 0.5001 * np.array(header["step"]) + 1e-9).all()


def test_a_wrong_order_of_differences_is_seen() -> None:
    values = np.cumsum(np.ones((9, 1)), axis=0) ** 2
    made = pack("x", values, 1e-3)
    other = Packed(**{**vars(made), "order": 3 - made.order})
    assert np.abs(unpack(other, 9) - values).max() > 1.0


def test_values_too_far_apart_are_refused() -> None:
    with pytest.raises(ValueError, match="too far apart"):
        pack("x", np.array([[0.0], [2.0 * LARGEST]]), 1.0)
