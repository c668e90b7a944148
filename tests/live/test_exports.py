"""Tables and pages that are downloaded hold all of a session."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import pytest

from live.drive import do, slack_rope
from ropewalk.live.exports import Exports
from ropewalk.live.keeper import Keeper, parts
from ropewalk.live.pictures import picture
from ropewalk.live.session import Session
from ropewalk.record.result import Result


def rows(folder: Path, name: str, into: Path) -> list[dict[str, str]]:
    into.mkdir(exist_ok=True)
    path, _ = Exports(None, lambda: folder).make(name, into)
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.parametrize("name", ["nodes.csv", "energies.csv", "tension.csv"])
def test_a_table_goes_on_after_a_cut_and_a_reset(tmp_path: Path, name: str) -> None:
    """It ended at the first of them, without a word."""
    session = Session(slack_rope(4))
    keeper = Keeper(session, tmp_path / "run")
    kinds: list[tuple[str, dict[str, Any]]] = [("cut", {"segment": 1}), ("reset", {}), ("", {})]
    for kind, keys in kinds:
        session.advance(3 * session.frame_steps)
        if kind:
            do(session, kind, **keys)
    found = rows(keeper.flush(), name, tmp_path / "made")
    results = [Result.open(one) for one in parts(tmp_path / "run")]
    each = {"nodes.csv": [5, 5, 5], "energies.csv": [1, 1, 1], "tension.csv": [4, 3, 4]}[name]
    counts = [sum(int(row["part"]) == number for row in found) for number in (1, 2, 3)]
    assert counts == [result.frames * count for result, count in zip(results, each, strict=True)]
    assert float(found[-1]["time [s]"]) == pytest.approx(results[-1].time[-1])
    assert all(row["time [s]"] for row in found)
    keeper.close()


def test_a_table_of_one_part_has_no_numbers_of_parts(tmp_path: Path) -> None:
    session = Session(slack_rope(4))
    keeper = Keeper(session, tmp_path / "run")
    session.advance(session.frame_steps)
    found = rows(keeper.flush(), "nodes.csv", tmp_path / "made")
    assert list(found[0]) == ["time [s]", "rope", "node", "x [m]", "y [m]", "z [m]"]
    keeper.close()


def test_energies_count_on_from_part_to_part(tmp_path: Path) -> None:
    """Gravity's jumped to zero, and the error began anew, at every part."""
    session = Session(slack_rope(4))
    keeper = Keeper(session, tmp_path / "run")
    shown, kinds = [], [("cut", {"segment": 1}), ("pin", {"node": 2}), ("reset", {}), ("", {})]
    for kind, keys in kinds:
        session.advance(5 * session.frame_steps)
        shown.append(picture(session.main).scalars)
        if kind:
            do(session, kind, **keys)
    keeper.close()
    found = rows(tmp_path / "run", "energies.csv", tmp_path / "made")
    columns = ["gravity energy [J]", "energy error [J]"]
    values = [[float(row[name]) for name in columns] for row in found]
    last = [[int(row["part"]) for row in found].index(number) - 1 for number in (2, 3, 4)] + [-1]
    told = [[one["gravity"], one["energy_error"]] for one in shown]
    assert [values[row] for row in last] == [pytest.approx(one, rel=1e-6) for one in told]
    for row in last[:2]:  # neither cut nor pin changes it
        assert values[row + 1] == pytest.approx(values[row], abs=1e-6)
    assert values[last[2] + 1] == [0.0, 0.0]
    assert abs(told[1][1]) > 1e-3  # J: there is an error to count on
    for row in found:
        parts_of = [float(row[f"{name} energy [J]"]) for name in ("kinetic", "gravity", "elastic")]
        assert float(row["total energy [J]"]) == pytest.approx(sum(parts_of), abs=1e-9)


@pytest.mark.parametrize("pinned", [False, True])
def test_a_kick_is_no_error_of_a_table(tmp_path: Path, pinned: bool) -> None:
    """It was one until the next part began: 2.3 J. Of one part and of two."""
    session = Session(slack_rope(4))
    keeper, shown = Keeper(session, tmp_path / "run"), [picture(session.main).scalars]
    for kind, keys in (("kick", {"node": 3, "velocity": (0.0, 3.0, 0.0)}), ("pin", {"node": 1})):
        session.advance(session.frame_steps)
        shown.append(picture(session.main).scalars)
        if kind == "kick" or pinned:
            do(session, kind, **keys)
    session.advance(session.frame_steps)
    shown.append(picture(session.main).scalars)
    found = rows(keeper.flush(), "energies.csv", tmp_path / "made")
    keeper.close()
    assert ("part" in found[0]) == pinned
    told = {float(row["time [s]"]): float(row["energy error [J]"]) for row in found}
    assert shown[2]["put_in"] > 2.0
    assert [told[one["time"]] for one in shown] == pytest.approx(
        [one["energy_error"] for one in shown], abs=1e-9
    )
