"""Statics: where the ropes of a scene hang, with what tension, without running it."""

from __future__ import annotations

from ropewalk.statics.rest import NoRest, Statics, checked_shape, static_shape
from ropewalk.statics.spans import RestSpan, rest_spans

__all__ = ["NoRest", "RestSpan", "Statics", "checked_shape", "rest_spans", "static_shape"]
