"""A Zarr store of what is marked, that compares every chunk with its checksum and names the damaged one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zarr.storage import LocalStore

from ropewalk.record.errors import RunError
from ropewalk.record.zarr_format import opened
from ropewalk.sweeps.store_layout import NOTES, OF_BROKEN, STATUS
from ropewalk.sweeps.sweep_folder import DATA, SweepFolder

if TYPE_CHECKING:
    from zarr.abc.store import ByteRequest
    from zarr.core.buffer import Buffer, BufferPrototype


class CheckedStore(LocalStore):
    """The data of a sweep, to be read; Zarr itself would only say that some checksum does not fit.

    Results of batches without a mark are not there: their writer died between the data and the mark.
    """

    def __init__(self, root: Any, *, read_only: bool = True, sweep: SweepFolder | None = None):
        super().__init__(root, read_only=read_only)
        self._sweep = sweep
        self.unmarked = sweep.unmarked_runs() if sweep is not None else []
        self._hidden: set[str] = set()
        if sweep is not None:
            results = [
                sweep.specs[name] for name in (*OF_BROKEN, NOTES, STATUS) if name in sweep.specs
            ]
            results += [sweep.specs[variable.name] for variable in sweep.plan.variables]
            numbers = [rows.start // sweep.plan.batch for rows in self.unmarked]
            self._facts = sweep.facts_state()
            self._hidden = {spec.key(number) for spec in results for number in numbers}

    def with_read_only(self, read_only: bool = False) -> CheckedStore:
        """Return the same store, for reading only or not."""
        return type(self)(self.root, read_only=read_only, sweep=self._sweep)

    @classmethod
    def of(cls, sweep: SweepFolder) -> CheckedStore:
        """Return the store of a sweep."""
        return cls(sweep.folder / DATA, sweep=sweep)

    async def get(
        self,
        key: str,
        prototype: BufferPrototype | None = None,
        byte_range: ByteRequest | None = None,
    ) -> Buffer | None:
        """Return a file's content. Raises RunError for a chunk that is damaged, or of another sweep."""
        if key in self._hidden:
            return None
        found: Buffer | None = await super().get(key, prototype, byte_range)
        if self._sweep is not None and (state := self._sweep.facts_state()) != self._facts:
            self._sweep.refuse_another()
            self._facts = state
        if found is not None and byte_range is None and "/c." in key and self._sweep is not None:
            try:
                opened(found.to_bytes())
            except ValueError as error:
                path = self._sweep.folder / DATA / key
                raise RunError(path, self._sweep.damage(path, str(error))) from None
        return found
