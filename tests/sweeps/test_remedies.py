"""What is refused around sweeps says whose fault it is, and what to do."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import ropewalk as rw
from ropewalk.record.errors import InputError, RunError
from ropewalk.record.lock import locked
from ropewalk.scene import SceneError, SceneFileError
from ropewalk.sweeps.engines import client_of
from ropewalk.sweeps.spread_text import parse_vary
from sweeps.scenes import EA, swing


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    """A cluster in this process, whose scheduler has a server but no dashboard."""
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address="127.0.0.1:0",
        scheduler_kwargs={"dashboard": False}, silence_logs=50,
    ) as made:  # fmt: skip
        yield made


def test_a_dashboard_that_is_not_there_has_no_address(cluster: Any) -> None:
    told: list[str] = []
    with client_of(cluster.scheduler_address, None, told.append) as client:
        assert "dashboard" in client.scheduler_info(n_workers=0)["services"]
    assert told == ["dashboard: none"]
    assert rw.sweep.dashboard is None


def test_a_worker_of_other_sources_is_named_with_what_to_do(
    cluster: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("ropewalk.sweeps.worker.sweep_hash", lambda: "other")
    (address,), many = cluster.scheduler.workers, {EA: [1e3 + 10.0 * i for i in range(6)]}
    with pytest.raises(RunError) as raised:
        rw.sweep(swing(0.02), many, batch=1, on=cluster.scheduler_address, progress=False)
    assert str(raised.value).startswith(f"worker {address}: cannot make batch ")
    assert "install there what is installed here, and start it anew" in str(raised.value)
    with (
        rw.sweep.function(swing(0.02), [EA], "tension.max", on=cluster.scheduler_address) as made,
        pytest.raises(RunError, match=f"worker {address}: cannot make runs"),
    ):
        made([[1e3]])


@pytest.mark.parametrize("use", [rw.simulate, lambda name: rw.sweep(name, {EA: [1e3]})])
def test_a_name_that_is_nearly_a_presets_is_told_the_preset(use: Any) -> None:
    rule = r'capstn: no such file, and no preset of that name; did you mean "capstan"'
    with pytest.raises(SceneFileError, match=rule):
        use("capstn")
    with pytest.raises(SceneFileError, match=r"capstn\.toml: no such file$"):
        use("capstn.toml")


def test_a_folder_in_use_says_what_to_do(tmp_path: Path) -> None:
    rw.sweep(swing(0.02), {EA: [1e3]}, store=tmp_path / "s", on="here", progress=False)
    with (
        locked(tmp_path / "s"),
        pytest.raises(RunError, match="by another process: wait until it is done, or end it first"),
    ):
        rw.sweep.resume(tmp_path / "s", on="here", progress=False)


def test_a_deviation_must_be_positive() -> None:
    with pytest.raises(InputError, match="; the standard deviation must be positive"):
        parse_vary(f"{EA}=norm(1e5, -1)")
    with pytest.raises(InputError, match="norm takes mean, standard deviation$"):
        parse_vary(f"{EA}=norm(1, 2, 3)")
    scipy_stats = pytest.importorskip("scipy.stats")
    with pytest.raises(SceneError, match="such as a standard deviation, must be positive"):
        rw.sweep(swing(0.02), {EA: scipy_stats.norm(1e5, -1.0)}, samples=4, progress=False)


def test_a_draw_outside_of_what_is_allowed_is_told_to_be_one() -> None:
    _, spread = parse_vary("rope.made_of.mass_per_length=norm(0.1, 1.0)")
    vary = {"rope.made_of.mass_per_length": spread}
    rule = r"it was drawn from norm\(0\.1, 1\.0\): take one that ends there, such as truncnorm"
    with pytest.raises(SceneError, match=rule):
        rw.sweep(swing(0.02), vary, samples=16, seed=0, on="here", progress=False)
    with pytest.raises(SceneError) as raised:  # what was given was not drawn
        rw.sweep(swing(0.02), {"rope.made_of.mass_per_length": [-1.0]}, on="here", progress=False)
    assert "drawn" not in str(raised.value)
