"""A Zarr store of a run folder that is read later on, which refuses another run in its place."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zarr.storage import LocalStore

from ropewalk.record.source import Source

if TYPE_CHECKING:
    from zarr.abc.store import ByteRequest
    from zarr.core.buffer import Buffer, BufferPrototype


class RunStore(LocalStore):
    """The data of a run, to be read; Zarr itself would read those of a run that has replaced it."""

    def __init__(self, root: Any, *, read_only: bool = True, source: Source | None = None):
        super().__init__(root, read_only=read_only)
        self._source = source

    def with_read_only(self, read_only: bool = False) -> RunStore:
        """Return the same store, for reading only or not."""
        return type(self)(self.root, read_only=read_only, source=self._source)

    async def get(
        self,
        key: str,
        prototype: BufferPrototype | None = None,
        byte_range: ByteRequest | None = None,
    ) -> Buffer | None:
        """Return a file's content. Raises RunError where it is of another run by now."""
        found: Buffer | None = await super().get(key, prototype, byte_range)
        if self._source is not None:
            self._source.refuse_another()
        return found
