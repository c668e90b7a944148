"""Modules: none needs itself by way of others, and a name says which one is meant."""

from __future__ import annotations

import ast
from collections import defaultdict
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from architecture.sources import PACKAGE, SOURCES, name_of


class WithoutTypes(ast.NodeTransformer):
    """Leaves out what is imported for type checkers only."""

    def visit_If(self, node: ast.If) -> ast.AST | list[ast.stmt]:
        if isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            return node.orelse
        return self.generic_visit(node)


def imported(source: str) -> set[str]:
    """Return the modules that a source imports when it runs, also inside of its functions."""
    found = set()
    for node in ast.walk(WithoutTypes().visit(ast.parse(source))):
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [f"{node.module}.{alias.name}" for alias in node.names]
            found |= {name if module(name) else node.module for name in names}
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
    return {name for name in found if module(name)}


def module(name: str) -> Path | None:
    """Return the file of a module of the package, None for what is none; a folder's is its `__init__`."""
    first, *rest = name.split(".")
    path = PACKAGE.joinpath(*rest)
    here = [p for p in (path.with_suffix(".py"), path / "__init__.py") if p.is_file()]
    return here[0] if first == "ropewalk" and rest and here else None


def own(path: Path) -> str:
    """Return the module of a file."""
    parts = Path(name_of(path)).with_suffix("").parts
    return ".".join(("ropewalk", *parts)).removesuffix(".__init__")


def circle(graph: dict[str, set[str]]) -> list[str]:
    """Return the modules of a circle, [] where there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


#: Modules that look others up by name, in texts that no linter reads, and why.
BY_NAME = {
    "core.deferred": "a kernel that another one calls is found by its name",
    "library.entry": "an entry makes materials and ropes, models of the room above",
    "methods.names": "a method has a file of its own name",
    "record.drawing": "a result draws itself: figures stand above results",
    "record.outlets": "a result plays, films and shares itself: what does that stands above results",
    "rigging.rolling": "a result draws itself",
    "scene.scene": "a scene shows itself: the page stands above scenes",
    "simulation.simulation": "a simulation shows itself: the page stands above it",
    "sweeps.calibration": "a result draws itself",
    "sweeps.uncertainty": "a result draws itself",
    "vibration.drawing": "a result draws itself",
}


def test_no_module_needs_itself() -> None:
    """Not by way of others either, nor by imports inside of functions."""
    graph = {
        own(path): imported(path.read_text(encoding="utf-8"))
        for path in SOURCES
        if path != PACKAGE / "__init__.py"
    }
    assert len(graph) > 350
    assert circle(graph) == []


def by_name(source: str) -> bool:
    """Tell whether a source imports what a text names: `import_module` of anything but others' packages."""
    calls = [n for n in ast.walk(ast.parse(source)) if isinstance(n, ast.Call)]
    return any(
        name_called(call) in ("import_module", "__import__") and not of_others(call.args[0])
        for call in calls
    )


def name_called(call: ast.Call) -> str:
    """Return the last name of what is called."""
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def of_others(text: ast.expr) -> bool:
    """Tell whether a text, or its beginning, names a package that is not ours."""
    first = text.values[0] if isinstance(text, ast.JoinedStr) else text
    return isinstance(first, ast.Constant) and not str(first.value).startswith("ropewalk")


def test_modules_that_are_named_in_texts() -> None:
    """Imports that the graph above cannot see: all of them are known, and none more."""
    found = {
        own(path).removeprefix("ropewalk.")
        for path in SOURCES
        if path != PACKAGE / "__init__.py" and by_name(path.read_text(encoding="utf-8"))
    }
    assert found == set(BY_NAME)
    assert by_name('importlib.import_module(f"ropewalk.{name}")')
    assert by_name("__import__(name)")
    assert not by_name('import_module("trimesh")')
    assert not by_name('import_module(f"scipy.{a}")')


def test_a_circle_is_found() -> None:
    """The twin, with imports as they are written: in a function, and for type checkers only."""
    inner = "def f():\n    from ropewalk.core import arrays\n"
    typed = "if TYPE_CHECKING:\n    from ropewalk.core import arrays\n"
    assert imported(inner) == {"ropewalk.core.arrays"}
    assert imported(typed) == set()
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"a"}})
    assert not circle({"a": {"b", "c"}, "b": {"c"}})


#: Names that several modules have, and what they mean in all of them. Commands are called as users type them.
SHARED = {
    "apart": "anchors that pull a rope apart: what they do, and what is said of it",
    "app": "an application: of the command line, of the page",
    "drawing": "the way from a thing to its figures",
    "errors": "of energy, in the kernels; and the exceptions whose path the reference gives",
    "facts": "what is known of a run, of a sweep, besides their numbers",
    "html": "a page in HTML: of the report, of a sheet",
    "identity": "what decides the bits of a run, and with it of a sweep",
    "parameters": "what of a scene is varied: by a sweep, while it runs",
    "peaks": "the greatest and least of every step: the table, and the kernels that keep it",
    "registry": "the one list: of laws, of methods, of motions",
    "rest": "the shape at rest, and a result of it",
    "rolling": "a load that rolls along a line, and its figure",
    "summary": "in a dozen numbers: a result, a sweep",
    "table": "of a law: all laws behind one call, the numbers of contacts",
    "winch": "in the scene, and as a law",
    "words": "numbers of that room as people read them",
}


def test_a_name_says_which_module_is_meant() -> None:
    """But for the names above, all of which are still shared."""
    homes = defaultdict(set)
    for path in SOURCES:
        if not path.stem.startswith("__") and path.parent.name != "commands":
            homes[path.stem].add(path.parent)
    shared = {name for name, folders in homes.items() if len(folders) > 1}
    assert shared == set(SHARED), "take another name, or say above what it means in all of them"


def test_nothing_but_the_way_in_lies_at_the_root() -> None:
    assert {path.name for path in SOURCES if path.parent == PACKAGE} == {
        "__init__.py", "__main__.py", "api.py",
    }  # fmt: skip
