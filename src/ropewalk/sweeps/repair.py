"""What of a sweep's folder is damaged, and what can be put right without a run."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from ropewalk.record.errors import RunError
from ropewalk.record.files import writing
from ropewalk.record.zarr_format import opened
from ropewalk.sweeps import facts
from ropewalk.sweeps.sweep_folder import COPIES, DATA, SCENE, SweepFolder, runs_in_words
from ropewalk.words.shell import typed


def _fault(path: Path) -> str:
    """Return what is wrong with a chunk's file, "" when it fits its checksum."""
    try:
        opened(path.read_bytes())
    except FileNotFoundError:
        return "it is missing"
    except OSError as error:
        return f"it cannot be read ({error.strerror})"
    except ValueError as error:
        return str(error)
    return ""


def faults(sweep: SweepFolder) -> list[str]:
    """Return a sentence for every file of a sweep that is damaged, each with its path and runs."""
    found = [f"{path}: {sweep.damage(path, why)}" for path, why, _ in _changed(sweep)]
    for _, path, copy in sweep.value_files():
        if why := _fault(path):
            found.append(f"{path}: {sweep.damage(path, why)}")
        elif sweep.plan.format > 1 and (why := _fault(copy)):
            found.append(
                f"{copy}: a copy of values is damaged: {why}; `ropewalk resume` makes it anew"
            )
    for number in sweep.standing()[1]:
        found += _of_batch(sweep, number)
    return found


def _of_batch(sweep: SweepFolder, number: int) -> list[str]:
    """Return what is damaged of a batch that is marked."""
    mark = sweep.marked(number)
    rows = sweep.plan.rows(number)
    files = sweep.batch_files(number, mark) if mark is not None else []
    found = [f"{path}: {sweep.damage(path, why)}" for path in files if (why := _fault(path))]
    if found:
        return found
    what = "its mark cannot be read" if mark is None else "its files do not fit its mark"
    runs = runs_in_words(rows)
    remedy = f"`ropewalk resume {typed(sweep.folder)}` makes these runs again"
    return [f"{sweep.folder}: batch {number} ({runs}) is damaged: {what}; {remedy}"]


def _changed(sweep: SweepFolder) -> list[tuple[Path, str, bytes]]:
    """Return files of the plan that are not as it says, what is wrong, and what they should be."""
    found: list[tuple[Path, str, bytes]] = []
    if sweep.plan.format == 1:  # other words stood there
        return found
    known = [(sweep.folder / DATA / name, data) for name, data in sweep.known_files()]
    known.append((sweep.folder / SCENE, sweep.plan.recipe.scene.encode()))
    for path, data in known:
        with suppress(OSError):
            if path.read_bytes() == data:
                continue
        found.append((path, "it is not as it was written", data))
    if sweep.plan.format > 2:
        wrong = ((path, facts.fault(path)) for path in sweep.facts_files())
        found += [(path, why, sweep.facts()) for path, why in wrong if why]
    return found


def mend(sweep: SweepFolder) -> list[str]:
    """Put right what needs no run: values from their copies, what the plan decides from the plan.

    Returns the names of the files that were written. Raises RunError when values and their copy are both
    damaged, or the disk refuses.
    """
    mended = []
    with writing(sweep.folder):
        (sweep.folder / COPIES).mkdir(exist_ok=True)
        for path, _, data in _changed(sweep):
            path.parent.mkdir(parents=True, exist_ok=True)
            name = path.relative_to(sweep.folder).as_posix()
            sweep.put(f"../{name}", data)
            mended.append(name)
        for name, path, copy in sweep.value_files():
            wrong, copy_wrong = _fault(path), _fault(copy)
            if wrong and copy_wrong:
                spec = sweep.specs[name.partition("/")[0]]
                first = int(path.name.rpartition(".")[2]) * spec.chunk[0]
                runs = range(first, min(first + spec.chunk[0], sweep.plan.runs))
                rule = (
                    f"is damaged ({wrong}), and its copy {copy} too ({copy_wrong}): what was asked of "
                    f"{runs_in_words(runs)} is lost; make the sweep anew"
                )
                raise RunError(path, rule)
            if wrong:
                sweep.put(name, copy.read_bytes())
                mended.append(f"{DATA}/{name}")
            elif copy_wrong:
                sweep.put(f"../{COPIES}/{copy.name}", path.read_bytes())
                if sweep.plan.format > 1:
                    mended.append(f"{COPIES}/{copy.name}")
    return mended
