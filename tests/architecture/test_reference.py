"""Every public name is in the reference, and its docstring says units, shapes, errors and sources."""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from architecture.reference import HANDED_OUT, NAMES, described, gaps
from ropewalk import theory
from ropewalk.core.arrays import Floats
from ropewalk.scene import Scene
from ropewalk.scene.paths import sections

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/reference/python.md").read_text(encoding="utf-8")
DOCUMENTED = re.findall(r"^\.\. auto\w+:: ([\w.]+)", PAGE, re.MULTILINE)
MODELS = sorted({model for _, model in sections(Scene)}, key=lambda model: model.__name__)


def test_every_public_name_is_in_the_reference() -> None:
    assert [name for name in NAMES if f"ropewalk.{name}" not in DOCUMENTED] == []
    classes = [path.rpartition(".")[2] for path in DOCUMENTED]
    assert [kind.__name__ for kind in HANDED_OUT if kind.__name__ not in classes] == []
    models = [model.__name__ for model in MODELS]
    assert [name for name in models if name not in classes] == []


@pytest.mark.parametrize("path", DOCUMENTED)
def test_the_reference_names_what_is_there(path: str) -> None:
    module, _, name = path.rpartition(".")
    home = rw if module == "ropewalk" else __import__(module, fromlist=[name])
    assert getattr(home, name) is not None


@pytest.mark.parametrize(
    ("name", "thing"), [pytest.param(*found, id=found[0]) for found in described()]
)
def test_docstrings_say_units_shapes_and_errors(name: str, thing: Any) -> None:
    assert gaps(thing) == []


@pytest.mark.parametrize(
    "name", [name for name in theory.__all__ if not inspect.isclass(getattr(theory, name))]
)
def test_formulas_have_a_source(name: str) -> None:
    found = re.search(r"Source: .{10}", inspect.getdoc(getattr(theory, name)) or "")
    assert found is not None


def test_gaps_are_seen() -> None:
    def bare(size: float) -> Floats:
        """Return something."""
        if size < 0.0:
            raise ValueError(size)
        return np.zeros(3)

    assert len(gaps(bare)) == 5


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.__name__)
def test_models_show_their_fields(model: Any) -> None:
    fields = {name: field for name, field in model.model_fields.items() if name != "kind"}
    signature = inspect.signature(model)
    assert list(signature.parameters) == list(fields)
    shown = str(signature)
    assert "Annotated" not in shown
    assert "pydantic" not in shown
    assert len(shown) < 600
    text = inspect.getdoc(model) or ""
    for name, field in fields.items():
        parameter = signature.parameters[name]
        assert (parameter.default is inspect.Parameter.empty) == field.is_required()
        extra = field.json_schema_extra
        unit = f" ({extra['unit']})" if isinstance(extra, dict) else ""
        end = "needed." if field.is_required() else f"default {parameter.default!r}."
        line = next(line for line in text.splitlines() if line.startswith(f"    {name}"))
        assert line.startswith(f"    {name}{unit}: ")
        assert line.endswith(f"; {end}")


def test_a_materials_signature() -> None:
    assert str(inspect.signature(rw.Material)).startswith(
        "(*, EA: float, mass_per_length: float, axial_damping: float = 0.0, EI: float = 0.0"
    )
    assert "    EA (N): Axial stiffness" in (rw.Material.__doc__ or "")
    assert rw.Material.about.count("\n") == 0


def test_help_shows_types_without_quotes() -> None:
    """Annotations are kept as texts, which `help` would show as such."""
    seen = 0
    for name, thing in described():
        if inspect.isfunction(thing):
            for key, annotation in thing.__annotations__.items():
                seen += 1
                assert not repr(annotation).startswith(("'", '"')), f"{name}: {key}: {annotation!r}"
    assert seen > 300


def test_the_types_of_other_functions_have_quotes() -> None:
    """The twin: nothing is lost on the way that these would show."""

    def other(length: float) -> None: ...

    assert repr(other.__annotations__["length"]) == "'float'"
