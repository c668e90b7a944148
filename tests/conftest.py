"""Tests that cannot begin before TESTS_UNTIL [s since 1970] are skipped: CI sets it, for slow machines."""

import os
import time

import pytest

UNTIL = float(os.environ.get("TESTS_UNTIL") or "inf")


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup() -> None:
    if time.time() > UNTIL:
        pytest.skip("the time for tests is over (TESTS_UNTIL)")
