"""What a faulty run folder or a failed export gets: one clear sentence."""

from __future__ import annotations

from pathlib import Path


class RunError(Exception):
    """A run folder or a table that cannot be used or written.

    Attributes:
        path: the file or folder at fault.
        rule: what is wrong or what is allowed, in words.
    """

    def __init__(self, path: str | Path, rule: str) -> None:
        self.path, self.rule = str(path), rule
        super().__init__(f"{path}: {rule}")

    def __reduce__(self) -> tuple[type, tuple[str, str]]:
        return type(self), (self.path, self.rule)


class InputError(ValueError):
    """A request that cannot be met: an unknown quantity, node or format.

    Attributes:
        path: what was asked, such as `quantities`.
        value: what stands there.
        rule: what is allowed.
    """

    def __init__(self, path: str, value: object, rule: str) -> None:
        self.path, self.value, self.rule = path, value, rule
        super().__init__(f"{path}: {value!r} - {rule}")
