"""Reading columns of numbers from CSV files that a scene names."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ropewalk.scene.base import refuse
from ropewalk.scene.faults import Fault
from ropewalk.scene.limits import HUGE
from ropewalk.scene.units import WrongUnit, in_unit

if TYPE_CHECKING:
    from pydantic import ValidationInfo

_MOST_FAULTS = 10
_IN_BRACKETS = re.compile(r"[\[(]([^\])]*)[\])]")
_DECIMAL = re.compile(r"(?<=\d),(?=\d)")
_MEASURE = re.compile(r"(?:^|\s)[-+.,\d]+\s*$")  # before the brackets: "50 (kN)" names no column
_PLAIN = ("", "-", "1")  # what people write in a header for no unit


def read_columns(
    folder: Path, file: str, units: Mapping[str, str], *, rising: bool = False
) -> list[list[float]]:
    """Read named columns of a CSV file: comma, semicolon or tab; ``#`` begins a comment line.

    With a header line the columns may come in any order and others are passed over; a header
    may carry units, as in ``x [mm]`` or ``tension (kN)``, from which the column is then converted. It may
    be a comment, as numpy.savetxt writes it. Without one, the columns are taken in the order of `units`,
    and their numbers are in these; more columns than that are refused.

    Args:
        folder: what a relative file name is relative to.
        file: the file's name.
        units: the columns wanted, and the unit of the numbers to return.
        rising: whether the first column must rise from row to row.

    Raises:
        PydanticCustomError: inside a validator, with every fault (path ``file``).
    """
    comments, lines = _lines(_text(folder, file))
    if not lines:
        refuse([Fault("file", file, "has no rows")])
    delimiter = _delimiter(lines[0][1])
    rows = [(number, _cells(line, delimiter)) for number, line in lines]
    names = list(units)
    if not _has_all(names, rows[0][1]):
        heads = [(number, _cells(line, _delimiter(line))) for number, line in reversed(comments)]
        found = [head for head in heads if _has_all(names, head[1])][:1]
        if not found and _is_numbers(rows[0][1]):
            for number, cells in heads:
                if _names_columns(cells, units, len(rows[0][1])):
                    _refuse_absent(file, number, cells, names)
        rows = found + rows
    order = _header(file, rows[0], names)
    width = len(rows[0][1])
    factors = [1.0] * len(names)
    if order is None:
        _refuse_more(file, rows[0], names)
        order = list(range(len(names)))
    else:
        factors = _factors(file, rows.pop(0), order, units)
    if not rows:
        refuse([Fault("file", file, "has a header but no rows")])
    for number, cells in rows:
        if len(cells) > width:
            rule = f"line {number}: has {len(cells)} cells, the first line has {width}"
            refuse([Fault("file", file, rule)])
    columns = _numbers(file, rows, names, order, rising)
    return [[k * value for value in column] for k, column in zip(factors, columns, strict=True)]


def _lines(text: str) -> tuple[list[tuple[int, str]], list[tuple[int, str]]]:
    """The comments above the first row, without their signs, and the rows, each with its line's number."""
    comments: list[tuple[int, str]] = []
    rows: list[tuple[int, str]] = []
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.lstrip().startswith("#"):
            rows += [(number, line)] if line.strip() else []
        elif not rows:
            comments.append((number, line.lstrip("# \t")))
    return comments, rows


def _delimiter(line: str) -> str:
    """The sign between a line's cells; of commas between digits alone semicolons or tabs may be it."""
    other = max(";\t", key=line.count)
    commas, others = line.count(","), line.count(other)
    decimals = commas == len(_DECIMAL.findall(line)) <= others + 1
    return other if others > commas or (others and decimals) else ","


def _cells(line: str, delimiter: str) -> list[str]:
    return [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter), ())]


def _titles(cells: Sequence[str]) -> list[str]:
    """The names of columns in the cells of a header, without their units."""
    return [cell.split("[")[0].split("(")[0].strip().lower() for cell in cells]


def _has_all(names: Sequence[str], cells: Sequence[str]) -> bool:
    """Whether a row's cells name all the columns that are wanted."""
    return set(names) <= set(_titles(cells))


def _text(folder: Path, file: str) -> str:
    """The text of a file, or one clear fault."""
    path = folder / file
    reason = "cannot be read"
    try:
        text = path.read_bytes().decode("utf-8-sig")
        if "\0" not in text:
            return text
        reason = "is not a text file"
    except FileNotFoundError:
        reason = f"no such file ({path})"
    except IsADirectoryError:
        reason = "is a folder, not a CSV file"
    except PermissionError:
        reason = "no permission to read it"
    except UnicodeDecodeError:
        reason = "is not a text file (UTF-8)"
    except (OSError, ValueError) as error:
        reason = f"cannot be read: {error}"
    refuse([Fault("file", file, reason)])
    raise AssertionError("unreachable")


def _header(file: str, row: tuple[int, list[str]], names: Sequence[str]) -> list[int] | None:
    """The place of each wanted column, or None when the first row is numbers already."""
    number, cells = row
    if _is_numbers(cells):
        return None
    _refuse_absent(file, number, cells, names)
    titles = _titles(cells)
    return [titles.index(name) for name in names]


def _is_numbers(cells: Sequence[str]) -> bool:
    """Whether a row has a number in it, be it with a comma for the decimals: a header has none."""
    return any(_number(cell.replace(",", ".")) is not None for cell in cells)


def _refuse_absent(file: str, number: int, cells: Sequence[str], names: Sequence[str]) -> None:
    """Refuse a header, of line `number`, that lacks columns."""
    titles = _titles(cells)
    absent = [name for name in names if name not in titles]
    if absent:
        rule = (
            f"line {number}: no column {', '.join(absent)}; the columns must be {', '.join(names)}"
        )
        between = ", with commas, semicolons or tabs between them" if len(cells) == 1 else ""
        refuse([Fault("file", file, rule + between)])


def _names_columns(cells: Sequence[str], units: Mapping[str, str], width: int) -> bool:
    """Whether a comment is meant as a header of `width` columns, by names of columns or units in brackets."""
    if len(set(units) & set(_titles([cell.split(":")[0] for cell in cells]))) > 1:
        return True  # also of "time: ms, x: mm", whose units nobody reads
    factors = [_factor(cell, unit) for cell in cells for unit in {*units.values()}]
    known = [factor for factor in factors if factor is not None]
    return bool(known) and (len(cells) == width or any(factor != 1.0 for factor in known))


def _factor(cell: str, unit: str) -> float | None:
    """By how much the unit in a cell's brackets is greater than `unit`; None of none, or another kind."""
    given = _IN_BRACKETS.search(cell)
    if given and _MEASURE.search(cell[: given.start()]):
        return None
    text = given[1].strip() if given else ""
    factor = None if text in _PLAIN else in_unit(f"1 {text}", unit)
    return factor if isinstance(factor, float) else None


def _refuse_more(file: str, row: tuple[int, list[str]], names: Sequence[str]) -> None:
    """Refuse a file without a header of which nobody can tell which columns are wanted."""
    number, cells = row
    count = max((place for place, cell in enumerate(cells, start=1) if cell), default=0)
    if count > len(names):
        rule = (
            f"line {number}: has {count} columns and no header; name them in a line above, with "
            f"{', '.join(names)} among them"
        )
        refuse([Fault("file", file, rule)])


def _factors(
    file: str, row: tuple[int, list[str]], order: Sequence[int], units: Mapping[str, str]
) -> list[float]:
    """By how much each wanted column is multiplied, from the units in the header; refuses other kinds."""
    number, cells = row
    factors: list[float] = []
    faults: list[Fault] = []
    for (name, unit), place in zip(units.items(), order, strict=True):
        given = _IN_BRACKETS.search(cells[place])
        text = given[1].strip() if given else ""
        factor = 1.0 if text in _PLAIN else in_unit(f"1 {text}", unit)
        if isinstance(factor, WrongUnit):
            where = f'line {number}, column {name}: "{text}"'
            faults.append(Fault("file", file, f"{where} - {factor.rule.partition(';')[0]}"))
            factor = math.nan
        factors.append(factor)
    refuse(faults)
    return factors


def _numbers(
    file: str,
    rows: Sequence[tuple[int, list[str]]],
    names: Sequence[str],
    order: Sequence[int],
    rising: bool,
) -> list[list[float]]:
    """The columns as numbers; refuses missing cells, text, NaN and falling first columns."""
    columns: list[list[float]] = [[] for _ in names]
    faults: list[Fault] = []
    for number, cells in rows:
        for name, place, column in zip(names, order, columns, strict=True):
            cell = cells[place] if place < len(cells) else ""
            value = _number(cell)
            if value is None or not abs(value) <= HUGE:
                what = f'"{cell}" - must be a finite number' if cell else "the cell is missing"
                what += ", with a point for the decimals" if "," in cell else ""
                faults.append(Fault("file", file, f"line {number}, column {name}: {what}"))
                value = math.nan
            column.append(value)
        first = columns[0]
        if rising and len(first) > 1 and first[-1] <= first[-2]:
            rule = f"line {number}, column {names[0]}: {first[-1]:g} - must be later than "
            faults.append(Fault("file", file, f"{rule}{first[-2]:g}, the row before"))
        if len(faults) >= _MOST_FAULTS:
            break
    refuse(faults)
    return columns


def _number(cell: str) -> float | None:
    try:
        return float(cell)
    except ValueError:
        return None


def folder_of(info: ValidationInfo) -> Path:
    """The folder that file names in a scene are relative to: the scene file's, else here."""
    return Path((info.context or {}).get("folder", "."))
