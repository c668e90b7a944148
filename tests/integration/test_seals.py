"""Text in a run folder is checked as its numbers are: provenance, status, log, metadata of the store."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner

import ropewalk as rw
import runs
from ropewalk.cli.app import main
from ropewalk.record import store
from ropewalk.record.errors import RunError
from ropewalk.record.folder import verify
from ropewalk.record.result import Result
from ropewalk.record.run import record_run
from ropewalk.record.seal import write_sealed


@pytest.fixture
def stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A run that the disk refused to take any more of."""
    seen, real = 0, store.write

    def filling(path: Path, *data: object, **more: object) -> None:
        nonlocal seen
        seen += 1
        if seen > 49:
            raise OSError(28, "No space left on device", str(path))
        real(path, *data, **more)  # type: ignore[arg-type]

    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 16)
    with monkeypatch.context() as patch:
        patch.setattr(store, "write", filling)
        with pytest.raises(RunError, match="no space left"):
            record_run(runs.hanging(), tmp_path / "run", commit_seconds=0.0)
    return tmp_path / "run"


def flip(path: Path, place: int) -> None:
    """Change one bit of a file."""
    data = bytearray(path.read_bytes())
    data[place] ^= 1 << (place % 8)
    path.write_bytes(data)


def faults(folder: Path) -> tuple[RunError, ...]:
    """Return what is found wrong, in a folder that cannot even be opened too."""
    try:
        return verify(folder).faults
    except RunError as error:
        return (error,)


def rewrite(path: Path, change: dict[str, object], *, sealed: bool) -> None:
    """Change some values of a JSON file that has a checksum."""
    found = json.loads(path.read_text())
    found.pop("checksum")
    if sealed:
        write_sealed(path, found | change)
    else:
        path.write_text(json.dumps(found | change))


def rewrite_root(folder: Path, **change: object) -> None:
    """Change attributes of a run's store, not its checksum."""
    path = folder / "data.zarr" / "zarr.json"
    root = json.loads(path.read_text())
    root["attributes"] |= change
    path.write_text(json.dumps(root))


TEXTS = ["provenance.json", "status.json", "events.jsonl", "data.zarr/*.json", "data.zarr/*/*.json"]


@pytest.mark.parametrize("pattern", TEXTS)
def test_one_bit_in_any_text_is_found(stopped: Path, pattern: str) -> None:
    """Names, steps, times of events and headers too; before, half of these were not looked at."""
    whole = rw.resume(stopped)
    for number, path in enumerate(sorted(stopped.glob(pattern))):
        for place in range(7 + number, path.stat().st_size, 101):
            flip(path, place)
            told = faults(stopped)
            assert told, (path, place)
            assert all(str(stopped) in str(fault) for fault in told)
            flip(path, place)
    assert verify(stopped).faults == ()
    assert Result.open(stopped).events == whole.events


def test_lost_lines_of_the_log_are_found_and_torn_ones_are_none(stopped: Path) -> None:
    """A run that was killed within a line goes on, and the log stays sound; a line taken out is missed."""
    log = stopped / "events.jsonl"
    with open(log, "ab") as file:
        file.write(b'{"at": "2026-')
    assert verify(stopped).faults == ()
    rw.resume(stopped)
    assert verify(stopped).faults == ()
    lines = log.read_bytes().splitlines(keepends=True)
    assert len(lines) > 3
    for number in range(len(lines) - 1):
        log.write_bytes(b"".join(lines[:number] + lines[number + 1 :]))
        found = verify(stopped).faults
        torn = not lines[number].endswith(b'"}\n')
        assert len(found) == (0 if torn else 1)


def test_a_resumed_run_takes_nothing_from_a_damaged_root(stopped: Path) -> None:
    rewrite_root(stopped, title="another")
    with pytest.raises(RunError, match=r"zarr\.json: is damaged"):
        rw.resume(stopped)


def test_folders_of_the_format_before_are_read_and_verified_as_far_as_can_be(stopped: Path) -> None:
    rewrite(stopped / "provenance.json", {"format": 4}, sealed=False)
    rewrite(stopped / "status.json", {}, sealed=False)
    rewrite_root(stopped, ropewalk_format=4)
    assert verify(stopped)[1:] == ((), False)
    assert Result.open(stopped).status == "interrupted"
    with pytest.raises(RunError, match="older format"):
        rw.resume(stopped)
    assert "go on with" not in CliRunner().invoke(main, ["info", str(stopped)]).output


def test_a_saved_copy_keeps_its_times_and_is_not_offered_to_go_on(
    stopped: Path, tmp_path: Path
) -> None:
    """It said `ropewalk resume COPY`, which is refused, and that the run ended when it was copied."""
    copy = tmp_path / "copy"
    Result.open(stopped).save(copy)
    told = [CliRunner().invoke(main, ["info", str(path)]).output for path in (stopped, copy)]
    assert ["go on with: ropewalk resume" in text for text in told] == [True, False]
    assert "ended" not in Result.open(copy).facts.provenance
    ended = rw.resume(stopped).facts.provenance["ended"]
    rewrite(stopped / "provenance.json", {"ended": "2020-01-01T00:00:00+00:00"}, sealed=True)
    again = Result.open(stopped).save(tmp_path / "again").facts.provenance["ended"]
    assert (again, again < ended) == ("2020-01-01T00:00:00+00:00", True)


def test_a_changed_status_is_refused_and_a_sealed_one_is_not(stopped: Path) -> None:
    """The twin of the refusal: the same change with the checksum that belongs to it."""
    path = stopped / "status.json"
    sound = path.read_bytes()
    rewrite(path, {"seconds": 1.0}, sealed=True)
    assert Result.open(stopped).facts.seconds == 1.0
    path.write_bytes(sound)
    rewrite(path, {"seconds": 1.0}, sealed=False)
    with pytest.raises(RunError, match=r"status\.json: is damaged"):
        Result.open(stopped)


def test_a_log_that_is_not_as_it_was_written_tells_of_no_partings(tmp_path: Path) -> None:
    """Only it knows when ropes parted: it was believed, whatever was in it. The twin: as it was written."""
    springs = rw.Springs(
        spring_constant=100.0, node_mass=0.5, segment_length=0.5, parts=True, breaking_load=6.0
    )
    rope = rw.Rope(segments=2, made_of=springs)
    run = {"duration": 0.5, "frame_rate": 20.0}
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run)
    whole = rw.simulate(scene).save(tmp_path / "whole")
    (parting,) = whole.partings
    log = (tmp_path / "whole" / "events.jsonl").read_text().splitlines(keepends=True)
    (line,) = (number for number, text in enumerate(log) if "rope parted" in text)
    first = str(parting.tension)[0]
    wrong = {
        "value": log[line].replace(f'"tension": {first}', f'"tension": {int(first) % 9 + 1}'),
        "key": log[line].replace('"event"', '"eVent"'),
        "brace": "z" + log[line][1:],
    }
    damaged = {name: [*log[:line], text, *log[line + 1 :]] for name, text in wrong.items()}
    damaged["without"] = log[:line]  # to the end: no checksum tells
    for name, lines in damaged.items():
        shutil.copytree(tmp_path / "whole", tmp_path / name)
        (tmp_path / name / "events.jsonl").write_text("".join(lines))
        assert "".join(lines) != "".join(log)
        with pytest.raises(RunError, match=r"events\.jsonl: is damaged"):
            _ = rw.open(tmp_path / name).partings
    assert rw.open(tmp_path / "whole").partings == (parting,)
