"""Fixtures of tests that add a law to a copy of the package: the copy, and what runs of it found."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest


@pytest.fixture(scope="module")
def package(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package with the module's `SAMPLE`."""
    made: Path = request.module.SAMPLE.copied(tmp_path_factory.mktemp("added"))
    return made


@pytest.fixture(scope="module")
def found(request: pytest.FixtureRequest, package: Path) -> dict[str, Any]:
    """What runs with that copy found."""
    result: dict[str, Any] = request.module.SAMPLE.run(package, "all")
    return result
