"""Scene files, CSV files, the schema: what is read, and what bad files get."""

from __future__ import annotations

import json
import os
import re
import tomllib
from pathlib import Path

import jsonschema
import pytest
import tomli_w

from ropewalk.scene import (
    Points,
    Rope,
    Scene,
    SceneError,
    SceneFileError,
    Springs,
    Table,
    dumps,
    load,
    loads,
    save,
    schema,
)
from ropewalk.scene.guess import Guess
from ropewalk.scene.paths import keys, kind_of, sections

DOCS = Path(__file__).parents[2] / "docs"
MATERIAL = {"kind": "material", "mass_per_length": "63 g/m"}
ROPE = """
[[rope]]
segments = 2
made_of = { kind = "springs", spring_constant = 100, node_mass = 0.1, segment_length = 1.0 }
"""
POINTS = ROPE + 'shape = { kind = "points", file = "places.csv" }\n'
TABLE = ROPE + '[[anchor]]\nnode = 0\nmotion = { kind = "table", file = "moves.csv" }\n'


def message(path: Path) -> str:
    """What loading a file says, without the file's name."""
    with pytest.raises(SceneError) as caught:
        load(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ")
    return text.replace(f"{path}: ", "")


def test_files_that_are_no_scene(tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    assert message(file) == "no such file"
    assert message(tmp_path) == "is a folder, not a scene file"
    file.write_bytes(b"")
    assert message(file) == "is empty: a scene needs a [[rope]]"
    file.write_bytes(b"# only a comment\n")
    assert message(file) == "is empty: a scene needs a [[rope]]"
    file.write_bytes(bytes(range(256)))
    assert message(file) == "is not a text file (a scene is TOML in UTF-8)"
    file.write_bytes(b"name = 'a'\0\0")
    assert message(file) == "is not a text file (a scene is TOML)"
    with pytest.raises(SceneFileError):
        load(file)


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root may read anything")
def test_a_file_without_permission(tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    file.write_text(ROPE)
    file.chmod(0)
    assert message(file) == "no permission to read it"


def test_a_file_without_permission_says_so(tmp_path: Path, monkeypatch) -> None:
    """As root nothing is forbidden, so the system's answer is put in its mouth."""
    file = tmp_path / "scene.toml"
    file.write_text(ROPE)

    def forbidden(self: Path) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_bytes", forbidden)
    assert message(file) == "no permission to read it"


@pytest.mark.parametrize(
    ("text", "start"),
    [
        ("name = \n", "line 1, column 8: TOML: "),
        ('name = "a"\n[run\n', "line 2, column 5: TOML: "),
        ("[run]\nduration = 1\nduration = 2\n", "line 3, column 13: TOML: "),
        ('name = "a', "line 1, column 10: TOML: "),
        ("a = [1,\n2", "line 2, column 2: TOML: "),
    ],
)
def test_toml_errors_have_line_and_column(tmp_path: Path, text: str, start: str) -> None:
    file = tmp_path / "scene.toml"
    file.write_text(text)
    found = message(file)
    assert found.startswith(start)
    assert "\n" not in found
    assert "(at" not in found.replace("(at the end)", "")


def test_a_scene_with_windows_line_ends_and_a_byte_order_mark(tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    file.write_bytes(b"\xef\xbb\xbf" + ROPE.replace("\n", "\r\n").encode())
    assert load(file) == loads(ROPE)


def test_saving_where_it_cannot_be(tmp_path: Path) -> None:
    scene = loads(ROPE)
    with pytest.raises(SceneFileError, match="cannot be written"):
        save(scene, tmp_path / "nowhere" / "scene.toml")
    (tmp_path / "folder").mkdir()
    with pytest.raises(SceneFileError, match="cannot be written"):
        save(scene, tmp_path / "folder")


def test_vectors_are_written_on_one_line() -> None:
    text = dumps(loads("gravity = [0, 0, -1.5]\n" + ROPE))
    assert "gravity = [0.0, 0.0, -1.5]\n" in text


@pytest.mark.parametrize(
    "csv",
    [
        "x,y,z\n0,0,0\n1,0,0\n2,0,0.5\n",
        "# a comment\n0,0,0\n\n1, 0 , 0\n2,0,5e-1",
        "node;Z [m];X [m];Y (m)\n0;0;0;0\n1;0;1;0\n2;0.5;2;0\n",
        "x\ty\tz\r\n0\t0\t0\r\n1\t0\t0\r\n2\t0\t0.5\r\n",
        '\ufeff"x","y","z"\n"0","0","0"\n1,0,0\n2,0,0.5\n',
    ],
)
def test_points_from_a_file(tmp_path: Path, csv: str) -> None:
    (tmp_path / "places.csv").write_text(csv, encoding="utf-8")
    (tmp_path / "scene.toml").write_text(POINTS)
    scene = load(tmp_path / "scene.toml")
    shape = scene.ropes[0].shape
    assert shape == Points(points=[(0, 0, 0), (1, 0, 0), (2, 0, 0.5)])
    assert shape.file is None
    # the scene does not need the file any more
    (tmp_path / "places.csv").unlink()
    assert loads(dumps(scene)) == scene


def test_points_from_a_file_in_python(tmp_path: Path) -> None:
    file = tmp_path / "places.csv"
    file.write_text("0,0,0\n1,0,0\n2,0,0\n")
    springs = Springs(spring_constant=1.0, node_mass=1.0, segment_length=1.0)
    rope = Rope(segments=2, made_of=springs, shape=Points(file=str(file)))
    assert rope.shape.points[2] == (2.0, 0.0, 0.0)
    with pytest.raises(SceneError, match="no such file"):
        Points(file=str(tmp_path / "other.csv"))


@pytest.mark.parametrize(
    "head",
    ["# time [ms],x [mm],y [mm],z [mm]", "#a run\n# z [mm]; y [mm]; x [mm]; time [ms]\n\n# more"],
)
def test_a_header_may_be_a_comment(tmp_path: Path, head: str) -> None:
    """As numpy.savetxt writes it: its units and its order were passed over, 1000 ms were 1000 s."""
    rows = [(0, 0, 0, 0), (1000, 5, 6, 7)]
    rows = [row[::-1] for row in rows] if "; x" in head else rows
    lines = [head, *(",".join(map(str, row)) for row in rows)]
    (tmp_path / "moves.csv").write_text("\n".join(lines))
    (tmp_path / "scene.toml").write_text(TABLE)
    motion = load(tmp_path / "scene.toml").anchors[0].motion
    assert motion == Table(times=[0, 1], positions=[(0, 0, 0), (0.005, 0.006, 0.007)])


@pytest.mark.parametrize(
    "csv",
    [
        "# of the left end, in time\n0,0,0,0\n1,0.5,0,0\n",  # says nothing of columns
        "# time [ms],x [mm],y [mm],z [mm]\ntime,x,y,z\n0,0,0,0\n1,0.5,0,0\n",
        "0,0,0,0\n# time [ms],x [mm],y [mm],z [mm]\n1,0.5,0,0\n",
    ],
)
def test_other_comments_are_no_header(tmp_path: Path, csv: str) -> None:
    (tmp_path / "moves.csv").write_text(csv)
    (tmp_path / "scene.toml").write_text(TABLE)
    motion = load(tmp_path / "scene.toml").anchors[0].motion
    assert motion == Table(times=[0, 1], positions=[(0, 0, 0), (0.5, 0, 0)])


def test_units_in_a_comment_are_checked_as_in_a_header(tmp_path: Path) -> None:
    (tmp_path / "moves.csv").write_text("# time [mm],x,y,z\n0,0,0,0\n1,0.5,0,0\n")
    (tmp_path / "scene.toml").write_text(TABLE)
    assert 'line 1, column time: "mm" - is of another kind' in message(tmp_path / "scene.toml")


@pytest.mark.parametrize(
    ("head", "absent"),
    [
        ("# t [ms],x [mm],y [mm],z [mm]", "time"),  # was taken as seconds and metres
        ("# x, y, z, t", "time"),  # in another order
        ("# time,x,y,z: of the left end", "z"),
        ("# time: ms, x: mm, y: mm, z: mm", "time, x, y, z"),
        ("# t [s];a [m];b [m];c [m]", "time, x, y, z"),
        ("# made at noon\n# all in [mm]", "time, x, y, z"),
    ],
)
def test_a_comment_that_is_half_a_header_is_refused(tmp_path: Path, head: str, absent: str) -> None:
    (tmp_path / "moves.csv").write_text(f"{head}\n0,0,0,0\n1000,5,0,0\n")
    (tmp_path / "scene.toml").write_text(TABLE)
    line = 1 + head.count("\n")
    assert f"line {line}: no column {absent}; the columns" in message(tmp_path / "scene.toml")


@pytest.mark.parametrize("head", ["# a rope (12 m), at rest (left end)", "# in [m], all", "# x"])
def test_comments_in_words_are_passed_over(tmp_path: Path, head: str) -> None:
    (tmp_path / "moves.csv").write_text(f"{head}\n0,0,0,0\n1,0.5,0,0\n")
    (tmp_path / "scene.toml").write_text(TABLE)
    motion = load(tmp_path / "scene.toml").anchors[0].motion
    assert motion == Table(times=[0, 1], positions=[(0, 0, 0), (0.5, 0, 0)])


@pytest.mark.parametrize(
    ("csv", "lines"),
    [
        ("", ["has no rows"]),
        ("x,y,z\n", ["has a header but no rows"]),
        ("x,y\n0,0\n", ["line 1: no column z; the columns must be x, y, z"]),
        (
            "0 0 0\n1 0 0\n",
            [
                "line 1: no column x, y, z; the columns must be x, y, z, with commas, semicolons or "
                "tabs between them"
            ],
        ),
        (
            "0,0;0;0,0\n1,5;0;0\n",
            [
                f'line {line}, column {axis}: "{cell}" - must be a finite number, with a point for the '
                "decimals"
                for line, axis, cell in ((1, "x", "0,0"), (1, "z", "0,0"), (2, "x", "1,5"))
            ],
        ),
        ("x,y,z\n0,0,0\n1,,0\n2,0,0\n", ["line 3, column y: the cell is missing"]),
        ("0,0,0\n1,0\n2,0,0\n", ["line 2, column z: the cell is missing"]),
        (
            "0,0,0\na,nan,inf\n2,0,0\n",
            [
                'line 2, column x: "a" - must be a finite number',
                'line 2, column y: "nan" - must be a finite number',
                'line 2, column z: "inf" - must be a finite number',
            ],
        ),
        ("a\0b", ["is not a text file"]),
        # columns node, x, y, z without a head: node was taken for x
        (
            "0,0,0,0\n1,1,0,0\n",
            [
                "line 1: has 4 columns and no header; name them in a line above, with x, y, z among them"
            ],
        ),
    ],
)
def test_bad_points_files(tmp_path: Path, csv: str, lines: list[str]) -> None:
    (tmp_path / "places.csv").write_text(csv)
    (tmp_path / "scene.toml").write_text(POINTS)
    found = message(tmp_path / "scene.toml").splitlines()
    assert found == [f'rope[0].shape.file: "places.csv" - {line}' for line in lines]


def test_files_that_are_no_csv(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(POINTS)
    assert "no such file" in message(tmp_path / "scene.toml")
    (tmp_path / "places.csv").mkdir()
    assert "is a folder, not a CSV file" in message(tmp_path / "scene.toml")
    (tmp_path / "places.csv").rmdir()
    (tmp_path / "places.csv").write_bytes(b"\xff\xfe\x00\x80")
    assert "is not a text file" in message(tmp_path / "scene.toml")


def test_a_wrong_number_of_points(tmp_path: Path) -> None:
    (tmp_path / "places.csv").write_text("0,0,0\n1,0,0\n")
    (tmp_path / "scene.toml").write_text(POINTS)
    assert "must be 3 points, one per node" in message(tmp_path / "scene.toml")


def test_a_table_from_a_file(tmp_path: Path) -> None:
    (tmp_path / "moves.csv").write_text("time,x,y,z\n0,0,0,0\n1.5,1,0,0\n")
    (tmp_path / "scene.toml").write_text(TABLE)
    motion = load(tmp_path / "scene.toml").anchors[0].motion
    assert motion == Table(times=[0, 1.5], positions=[(0, 0, 0), (1, 0, 0)])


def test_a_table_with_falling_times(tmp_path: Path) -> None:
    (tmp_path / "moves.csv").write_text("time,x,y,z\n0,0,0,0\n2,1,0,0\n1,0,0,0\n1,0,0,0\n")
    (tmp_path / "scene.toml").write_text(TABLE)
    assert message(tmp_path / "scene.toml").splitlines() == [
        'anchor[0].motion.file: "moves.csv" - line 4, column time: 1 - must be later than 2, '
        "the row before",
        'anchor[0].motion.file: "moves.csv" - line 5, column time: 1 - must be later than 1, '
        "the row before",
    ]


def test_a_file_and_values_exclude_each_other() -> None:
    with pytest.raises(SceneError, match="give either file or points"):
        Points(file="a.csv", points=[(0, 0, 0)])
    with pytest.raises(SceneError, match="give either file or times and positions"):
        Table(file="a.csv", times=[0, 1])


def test_the_schema_accepts_the_scenes_of_the_docs() -> None:
    """All that can be read; an editor marked quantities with units as faulty."""
    validator = jsonschema.Draft202012Validator(schema())
    texts = (page.read_text(encoding="utf-8") for page in DOCS.rglob("*.md"))
    read = 0
    for block in re.findall(r"^```toml\n(.*?)^```", "\n".join(texts), re.MULTILINE | re.DOTALL):
        try:
            loads(block)
        except SceneError:
            continue  # a part of a scene, or one with files
        read += 1
        validator.validate(tomllib.loads(block))
    assert read > 20


def test_the_schema_is_one_and_accepts_scenes_only() -> None:
    made = schema()
    json.dumps(made, allow_nan=False)
    jsonschema.Draft202012Validator.check_schema(made)
    validator = jsonschema.Draft202012Validator(made)
    spring = {"kind": "springs", "spring_constant": 1, "node_mass": 1, "segment_length": 1}
    rope = {"segments": 2, "made_of": spring}
    validator.validate({"rope": [rope]})
    for good in (
        {
            "gravity": ["0 m/s^2", 0, "-32 ft/s²"],
            "run": {"time_step": "0.5 ms", "frame_rate": "30 1/s"},
        },
        {"rope": [rope | {"length": "30 ft", "made_of": MATERIAL | {"EA": "5.65e+00 MN"}}]},
        {
            "rope": [
                rope
                | {"length": 1, "made_of": MATERIAL | {"curve": [[0.1, 1e2], ["20 %", "1 kN"]]}}
            ]
        },
    ):
        validator.validate({"rope": [rope]} | good)
        assert loads(tomli_w.dumps({"rope": [rope]} | good))
    for bad in (
        {"rope": [rope | {"segments": 0}]},
        {"rope": [rope | {"segmets": 0}]},
        {"rope": [rope | {"made_of": spring | {"node_mass": "1"}}]},
        {"rope": [rope | {"made_of": spring | {"kind": "spring"}}]},
        {"rope": [rope], "gravity": [0, 0]},
        {"rope": [rope], "gravity": [0, 0, "-9.81"]},
        {"rope": [rope], "gravity": [0, 0, "down"]},
        {"rope": [rope], "gravity": [0, 0, -1e16]},
        {"rope": [rope | {"made_of": spring | {"node_mass": "1e3"}}]},
        {"rope": [rope | {"segments": "2 m"}]},
        {"rope": [rope], "run": {"time_step": "car"}},
        {"rope": [rope], "run": {"tolerance": 1e-10}},
        {"rope": [rope | {"made_of": MATERIAL | {"curve": [[0.1, 100.0, 1.0]]}}]},
        {"rope": [rope | {"made_of": MATERIAL | {"curve": [["0.1", 100.0]]}}]},
        {"rope": [rope], "run": {"method": "rk5"}},
    ):
        assert not validator.is_valid(bad), bad


def test_every_field_is_described_and_every_number_has_a_unit() -> None:
    for path, model in sections(Scene):
        for key, field in keys(model).items():
            if key == "kind" or (model is Guess and key != "of"):  # in the unit of what it marks
                continue
            assert field.description, f"{path}.{key}"
            annotation = str(field.annotation)
            numeric = re.search(r"\bfloat\b", annotation) and not kind_of(field).models
            if numeric:
                assert (field.json_schema_extra or {}).get("unit"), f"{path}.{key}"


@pytest.mark.parametrize("number", [".5", "5.", "-.5", "+.5", "[.5, 1.0, 2.0]", "5.e3"])
def test_numbers_without_a_digit_at_their_point_are_told(number: str) -> None:
    with pytest.raises(SceneFileError) as caught:
        loads(ROPE + f"length = {number}\n")
    said = "a number has a digit before its point and one after it, such as 0.5 or 5.0"
    assert said in str(caught.value)
    with pytest.raises(SceneFileError) as caught:
        loads(ROPE + "name = 1.2.3\n")
    assert said not in str(caught.value)


def test_what_cannot_be_saved_leaves_nothing_behind(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    with pytest.raises(SceneFileError, match="folder: cannot be written"):
        save(loads(ROPE), tmp_path / "folder")
    assert [path.name for path in tmp_path.iterdir()] == ["folder"]
