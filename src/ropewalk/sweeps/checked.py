"""A Zarr store that compares every chunk with its checksum, and names the one that is damaged."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zarr.storage import LocalStore

from ropewalk.record.errors import RunError
from ropewalk.record.zarr_format import opened
from ropewalk.sweeps.sweep_folder import DATA, SweepFolder

if TYPE_CHECKING:
    from zarr.abc.store import ByteRequest
    from zarr.core.buffer import Buffer, BufferPrototype


class CheckedStore(LocalStore):
    """The data of a sweep, to be read; Zarr itself would only say that some checksum does not fit."""

    def __init__(self, root: Any, *, read_only: bool = True, sweep: SweepFolder | None = None):
        super().__init__(root, read_only=read_only)
        self._sweep = sweep

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
        """Return a file's content. Raises RunError for a chunk that is damaged."""
        found: Buffer | None = await super().get(key, prototype, byte_range)
        if found is not None and byte_range is None and "/c." in key and self._sweep is not None:
            try:
                opened(found.to_bytes())
            except ValueError as error:
                path = self._sweep.folder / DATA / key
                raise RunError(path, self._sweep.damage(path, str(error))) from None
        return found
