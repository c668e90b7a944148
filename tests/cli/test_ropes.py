"""`ropewalk ropes`: list, search, show, compare, JSON."""

from __future__ import annotations

import json
from typing import Any

from ropewalk.library import names, rope


def test_the_list(ropewalk: Any) -> None:
    done = ropewalk("ropes")
    assert done.exit_code == 0
    for name in names():
        assert f" {name} " in done.stdout
    assert f"{len(names())} ropes" in done.stdout
    listed = json.loads(ropewalk("ropes", "--json").stdout)["ropes"]
    assert [one["name"] for one in listed] == names()
    assert listed[0]["numbers"]["EA"]["unit"] == "N"


def test_search_and_family(ropewalk: Any) -> None:
    found = json.loads(ropewalk("ropes", "--search", "7x19 10 mm", "--json").stdout)["ropes"]
    assert [one["name"] for one in found] == ["wire-7x19-10"]
    assert "wire-6x36-iwrc-16" in ropewalk("ropes", "--family", "steel wire").stdout
    none = ropewalk("ropes", "--search", "no such")
    assert none.exit_code == 2
    assert "the families are" in none.stderr


def test_one_rope_with_units_and_without(ropewalk: Any) -> None:
    shown = ropewalk("ropes", "wire-7x19-10").stdout
    assert "4.92 MN" in shown
    assert "guess: not sourced" in shown
    assert "F2: Strand Core" in shown
    plain = ropewalk("ropes", "wire-7x19-10", "--plain").stdout
    assert "EA [N]" in plain
    assert "4.92e+06" in plain


def test_a_climbing_rope_is_shown_with_what_no_source_gives(ropewalk: Any) -> None:
    assert "no source says by how much" in ropewalk("ropes", "dynamic-single-9.8").stdout
    assert "no source says" not in ropewalk("ropes", "wire-7x19-10").stdout


def test_ropes_side_by_side(ropewalk: Any) -> None:
    done = ropewalk("ropes", "wire-7x19-6", "dynamic-single-9.8")
    assert "~" in done.stdout
    assert "27.35 kN" in done.stdout
    assert ropewalk("ropes", *names()[:9]).exit_code == 2


def test_a_name_that_is_not_there(ropewalk: Any) -> None:
    done = ropewalk("ropes", "wire-7x19-11")
    assert done.exit_code == 2
    assert 'did you mean "wire-7x19-1' in done.stderr
    assert ropewalk("ropes", "wire-7x19-10", "--search", "wire").exit_code == 2


def test_check_says_what_the_rope_is(ropewalk: Any) -> None:
    done = ropewalk("check", "hanging-rope", "--set", "rope.made_of=semistatic-10.5")
    assert "semistatic-10.5 of the library; guessed: EA (19.1 kN to 61 kN)" in done.stdout
    assert str(rope("semistatic-10.5").EA) not in done.stderr
