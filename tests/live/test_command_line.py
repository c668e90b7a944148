"""`ropewalk view` in a process of its own: it says where, ends cleanly, keeps the run."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from urllib.request import urlopen

import pytest
from click.testing import CliRunner

from patience import PATIENCE
from ropewalk.live.relive import relive
from ropewalk.scene import Scene


@contextmanager
def viewing(folder: Path, *words: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run `ropewalk view`; give the process and its address, read once it serves."""
    command = [sys.executable, "-m", "ropewalk", "view", "--no-browser", *words]
    environment = os.environ | {"PYTHONUNBUFFERED": "1"}
    process = subprocess.Popen(
        command,
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        assert process.stdout is not None
        yield process, process.stdout.readline().strip()
    finally:
        if process.poll() is None:
            process.kill()
        process.communicate()


def fails(folder: Path, *words: str) -> str:
    """Run `ropewalk view` with bad input; return what it says."""
    done = subprocess.run(
        [sys.executable, "-m", "ropewalk", "view", *words],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
    return done.stderr


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_it_ends_cleanly_with_the_run_kept(tmp_path: Path, number: int) -> None:
    with viewing(tmp_path, "r1", "--port", "0") as (process, address):
        with urlopen(address, timeout=PATIENCE) as answer:
            assert answer.status == 200
        with urlopen(
            address + "export/scene.toml", timeout=PATIENCE
        ) as answer:  # once there is a run
            assert answer.status == 200
        process.send_signal(number)
        out, err = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0
    assert "Traceback" not in err
    assert out.strip() == "run folder: runs/r1-live-1"
    session = relive(tmp_path / "runs" / "r1-live-1")
    assert session.preset == "r1"


def test_a_busy_port_is_said(tmp_path: Path) -> None:
    with socket.socket() as busy:
        busy.bind(("127.0.0.1", 0))
        busy.listen()
        port = busy.getsockname()[1]
        with viewing(tmp_path, "r1", "--no-save", "--port", str(port)) as (process, address):
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=PATIENCE)  # while the simulation is being set up
    assert "Traceback" not in err
    assert f"port {port} is busy: taking" in err
    assert f":{port}/" not in address
    assert not (tmp_path / "runs").exists()


def test_listening_on_all_addresses_is_warned_of(tmp_path: Path) -> None:
    with viewing(tmp_path, "--no-save", "--port", "0", "--host", "0.0.0.0") as (process, _):
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=PATIENCE)
    assert "warning: listening on 0.0.0.0" in err


def test_bad_input(tmp_path: Path) -> None:
    assert "no such file, and no preset" in fails(tmp_path, "nothing")
    assert "--continue needs the folder of a live session" in fails(tmp_path, "r1", "--continue")
    assert "must be at least 1" in fails(tmp_path, "r1", "--set", "rope.segments=0")
    assert "200000" in fails(tmp_path, "r1", "--set", "rope.segments=300000")
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "notes.txt").write_text("mine")
    said = fails(tmp_path, "r1", "-o", "full")
    assert "is no run folder" in said
    assert "Ctrl-C" not in said  # before a browser is opened
    assert (tmp_path / "full" / "notes.txt").read_text() == "mine"


def test_a_copied_set_up_is_opened_again(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[tuple[Scene, str | None]] = []
    module = import_module("ropewalk.cli.commands.view")
    monkeypatch.setattr(
        module, "_live", lambda scene, start, early, _: shown.append((scene, start))
    )
    monkeypatch.setattr(module, "_serve", lambda make, *_: make(None) or 0)
    for link in (
        "scene=r1&mass=2&gravity=[0,-5,0]",
        "http://127.0.0.1:8712/#scene=r1&mass=2&gravity=[0,-5,0]",
    ):
        words = ["--at", link, "--no-save"]
        done = CliRunner().invoke(module.view, words, catch_exceptions=False)
        assert done.exit_code == 0
        scene, start = shown.pop()
        assert start is None
        assert scene.gravity == (0.0, -5.0, 0.0)
        assert scene.ropes[0].own_mass == pytest.approx(2.0)


def test_a_set_up_that_is_none_is_refused(tmp_path: Path) -> None:
    assert "leave out SCENE" in fails(tmp_path, "r1", "--at", "scene=r1")
    assert "no such preset" in fails(tmp_path, "--at", "scene=no-such")
    assert "keep that scene as TOML" in fails(tmp_path, "--at", "scene=start&mass=2")
    assert "must be" in fails(tmp_path, "--at", "scene=r1&mass=-2")
