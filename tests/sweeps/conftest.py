"""What all tests of sweeps share."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace

import pytest

from sweeps.scenes import make, store_bytes


@pytest.fixture(scope="module", autouse=True)
def one_id() -> Iterator[None]:
    """All sweeps get the same id here: the marks hold it, and stores are compared byte by byte."""
    with pytest.MonkeyPatch.context() as patch:
        made = SimpleNamespace(uuid4=lambda: SimpleNamespace(hex="0" * 32))
        patch.setattr("ropewalk.sweeps.sweep_plan.uuid", made)
        yield


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The store of a sweep that nothing stopped."""
    folder = tmp_path_factory.mktemp("whole") / "s"
    make(folder)
    return store_bytes(folder)
