"""Faults of what ropes touch, are tied to and wound on have four parts: path, value, rule and remedy."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from ropewalk.lowering import build
from ropewalk.scene import SceneError, loads
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.paths import all_sections, keys, tag

RUN = '[run]\nduration = 0.1\nmethod = "esdirk3"\ntime_step = 0.004\n'
ROPE = """
[[rope]]
name = "{0}"
segments = 20
length = 1.0
diameter = 0.01
made_of = {{ kind = "material", EA = 1e4, mass_per_length = 0.05, axial_damping = 10.0 }}
shape = {{ kind = "straight", start = [-0.5, {1}, 0.3], end = [0.5, {1}, 0.3] }}
"""
A, B = ROPE.format("a", 0), ROPE.format("b", 1)
BALL = '[[obstacle]]\nname = "ball"\nkind = "sphere"\ncenter = [0, 0, 0]\nradius = 0.05\n'
BAR = '[[obstacle]]\nkind = "cylinder"\nfrom = [0, -0.1, 0]\nto = [0, 0.1, 0]\nradius = 0.05\n'
PIPE = '[[obstacle]]\nkind = "half-pipe"\nfrom = [0, 0, -1]\nto = [0, 0, 1]\nradius = 0.05\n'
BOX = '[[obstacle]]\nkind = "box"\ncenter = [0, 0, 0]\nhalf_sizes = [0.1, 0.1, 0.1]\nedge_radius = 0.01\n'
HELD = '[[anchor]]\nrope = "a"\nnode = 0\n'
WINCH = '[[winch]]\nrope = "a"\nend = "start"\nspeed = 1\n'
SLIDE = '[[slide]]\nrope = "b"\non = "a"\nat = 0.5\n'
TIED = '[[joint]]\npoints = [{ rope = "a", node = 0 }, { rope = "b", node = 0 }]\n'
KNOTTED = """
[contact]
[[rope]]
segments = 400
length = 4.0
diameter = 0.01
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.05 }
[rope.shape]
kind = "knot"
"""


def knotted(lines: str) -> str:
    """A rope that is tied in a knot."""
    return KNOTTED + lines


def spun(spin: str) -> str:
    """A bar that turns."""
    return f"{A}{BAR}spin = {{ {spin} }}\n"


def moved(motion: str) -> str:
    """A ball that moves."""
    return f"{A}{BALL}motion = {{ {motion} }}\n"


#: A scene, and what must be said of it first: path, value as it is shown, a word of the rule, of the remedy.
CASES = [
    (A + B + SLIDE.replace('on = "a"', 'on = "foo"'), "slide[0].on", '"foo"', "is no rope", "known: a, b"),
    (A + B + SLIDE.replace('"b"', '"foo"'), "slide[0].rope", '"foo"', "is no rope", "known: a, b"),
    (A + B + SLIDE.replace('on = "a"', 'on = ""'), "slide[0].on", '""', "must not be", "empty"),
    (A + B + SLIDE.replace('on = "a"', "on = 3"), "slide[0].on", "3", "must be text", 'such as "rope"'),
    (A + B + SLIDE.replace("b", "a"),
     "slide[0].on", '"a"', "rope of the node itself", "give the name of another"),
    (A + B + SLIDE.replace("0.5", "7"), "slide[0].at", "7.0", "must be on rope 'a'", "1 m long"),
    (A + B + SLIDE + SLIDE, "slide[1].node", "0", "slides already", "leave out one"),
    (A + B + SLIDE + "brake_from = 0.2", "slide[0].brake", "missing", "is needed", "or leave out"),
    (A + B + HELD.replace('"a"', '"b"') + SLIDE,
     "slide[0].node", '"node 0 of b"', "off its place", "draw it there"),
    (A + HELD + 'on = "foo"', "anchor[0].on", "", 'belongs to "slide.on"', "this one has name, rope, node"),
    (A + BALL + 'on = "foo"', "obstacle[0].on", "", 'belongs to "slide.on"', "this one has name, friction"),
    (A + BALL + BALL, "obstacle[1].name", '"ball"', "of obstacle[0] already", "give it another"),
    (A + BALL.replace("sphere", "ball"), "obstacle[0].kind", '"ball"', "must be one of", '"sphere"'),
    (A + BALL.replace("radius", "radiuss"),
     "obstacle[0].radiuss", "", "unknown key", 'did you mean "radius"?'),
    (A + BALL + 'pair = [{ rope = "c", friction = 0.1 }]',
     "obstacle[0].pair[0].rope", '"c"', "no rope", "known: a"),
    (A + BALL + 'pair = [{ rope = "a", friction = 0.1 }, { rope = "a", friction = 0.2 }]',
     "obstacle[0].pair[1].rope", '"a"', "told by obstacle[0].pair[0] already", "leave out one"),
    (A + BAR.replace("-0.1", "0.1"),
     "obstacle[0].to", "[0.0, 0.1, 0.0]", "must not be the point", "give its other end"),
    (A + PIPE,
     "obstacle[0].open_to", "[0, 0, 1]", "must not lie along its axis", "give a direction across"),
    (A + BOX.replace("[0.1, 0.1", "[0.1, 0"),
     "obstacle[0].half_sizes", "[0.1, 0.0, 0.1]", "must all three", "greater than 0"),
    (A + BOX.replace("0.01", "0.2"), "obstacle[0].edge_radius", "0.2", "must be at most", "(0.1 m)"),
    (A.replace("0.3", "0.02") + BALL,
     "rope[0].shape", '"node 10"', "inside obstacle 'ball'", "move the rope"),
    (A + BAR + 'restitution = 0.5',
     "obstacle[0].restitution", "0.5", 'asks for run.method = "adaptive"', "or leave this out"),
    (moved('kind = "hand"'), "obstacle[0].motion.kind", '"hand"', "must be one of", '"velocity"'),
    (moved('kind = "velocity", velocity = [0, 0, 1], start = 2, stop = 1'),
     "obstacle[0].motion.stop", "1.0", "must be later", "than start (2.0)"),
    (moved('kind = "orbit", center = [0, 0, 0], axis = [0, 0, 1], frequency = 0'),
     "obstacle[0].motion.frequency", "0.0", "must not be zero", "leave out the motion of what rests"),
    (moved('kind = "table", times = [0, 1], positions = [[0, 0, 0]]'),
     "obstacle[0].motion.positions", '"1 place"', "must have 2 places", "one for each time"),
    (moved('kind = "table"'), "obstacle[0].motion.times", "missing", "give times and positions", "or file"),
    (moved('kind = "velocity", velocity = [0, 0, 500]'),
     "obstacle[0].motion", '"up to 500 m/s"', "would jump over nodes", "take a run.time_step of at most"),
    (spun(""), "obstacle[0].spin.rate", "missing", "give rate, or", "free = true"),
    (spun("rate = 1, times = [0, 1], angles = [0, 1]"),
     "obstacle[0].spin.angles", "[0.0, 1.0]", "either rate or", "not both"),
    (spun("times = [0, 1], angles = [0, 1], start = 0.1"),
     "obstacle[0].spin.start", "0.1", "times of its own", "leave it out"),
    (spun("rate = 1, inertia = 1"), "obstacle[0].spin.inertia", "1.0", "turns freely", "give free = true"),
    (spun("free = true"),
     "obstacle[0].spin.inertia", "missing", "needs its moment of inertia", "give a tenth"),
    (spun("free = true, inertia = 1, start = 1"),
     "obstacle[0].spin.start", "1.0", "is turned", "leave it out, or free"),
    (spun("free = true, inertia = 1, center_of_mass = [0, 0, 0]"),
     "obstacle[0].spin.mass", "missing", "give the mass", "center_of_mass"),
    (A + '[[obstacle]]\nkind = "plane"\nspin = { rate = 1, pivot = [0, 0, 0] }',
     "obstacle[0].spin.pivot", "[0.0, 0.0, 0.0]", "for bodies that have an end", "leave it out"),
    (A + B + '[contact]\npair = [{ rope = "a", other = "c", friction = 0.1 }]',
     "contact.pair[0].other", '"c"', "is no rope", "known: a, b"),
    (A + B.replace("1, 0.3", "0.002, 0.3") + "[contact]",
     "rope[1].shape", '"segment 1"', "inside segment", "draw the ropes apart"),
    (A.replace("diameter = 0.01", "") + "[contact]",
     "rope[0].diameter", "missing", "is needed where", "or leave out contact"),
    (knotted('knot = "overhand"\naxis = [0, 0, 0]'),
     "rope[0].shape.axis", "", "unknown key of 'knot'", 'mean "normal"?'),
    (knotted('knot = "prusik"\nradius = 0.02'),
     "rope[0].shape.radius", "", "unknown key of 'knot'", 'mean "post_radius"?'),
    (knotted('knot = "overhand"\nposition = [0, 0, 0]'),
     "rope[0].shape.position", "", "unknown key", 'mean "center"?'),
    (knotted('knot = "overhand"\nnormal = [-2, 0, 0]'),
     "rope[0].shape.normal", "[-2.0, 0.0, 0.0]", "must not point along", "give a direction across"),
    (knotted('knot = "cloven"'),
     "rope[0].shape.knot", '"cloven"', "must be one of", 'did you mean "clove-hitch"?'),
    (knotted('knot = "prusik"'),
     "rope[0].shape.post_radius", "missing", "is tied about a post", "give its radius (m)"),
    (knotted('knot = "overhand"\npost_radius = 0.1'),
     "rope[0].shape.post_radius", "0.1", "has no post", "leave it out"),
    (A + B + TIED.replace('rope = "b"', 'rope = "c"'),
     "joint[0].points[1].rope", '"c"', "no such rope", "known: a, b"),
    (A + TIED.replace('"b"', '"a"'),
     "joint[0].points[1].node", "0", "is points[0] already", "leave out one"),
    (A + TIED.replace('"b", node = 0', '"a", node = 1'),
     "joint[0].points[1].node", "1", "neighbour of points[0]", "tie a node farther"),
    (A + B + TIED + TIED, "joint[1].points[0].node", "0", "tied by joint[0] already", "list all nodes"),
    (A + B + TIED, "joint[0].points[1]", '"node 0 of b"', "lies at", "draw the ropes so"),
    (A + WINCH, "winch[0].end", '"start"', "needs an anchor at node 0", "give [[anchor]] one"),
    (A + HELD + WINCH + WINCH, "winch[1].end", '"start"', "has winch[0] already", "leave out one"),
    (A + HELD + HELD, "anchor[1].node", "0", "is held by anchor[0] already", "leave out one"),
    (A + HELD + WINCH + "min_length = 2", "winch[0].min_length", "2.0", "must be at most", "(1 m)"),
    (A.replace("1e4", "inf") + HELD + WINCH,
     "winch[0].rope", '"a"', "has rigid links", "give it a finite stiffness"),
    (A + B + HELD + WINCH + TIED,
     "joint[0].points[0].node", "0", "where a winch's drum is", "or leave out the winch"),
]  # fmt: skip


def first_fault(text: str) -> Fault:
    """The first thing that is found wrong with a scene."""
    with pytest.raises(SceneError) as refused:
        build(loads(text))
    return refused.value.faults[0]


@pytest.mark.parametrize("case", CASES, ids=[f"{row}-{case[1]}" for row, case in enumerate(CASES)])
def test_a_fault_has_path_value_rule_and_remedy(case: tuple[str, ...]) -> None:
    text, path, value, rule, remedy = case
    fault = first_fault(RUN + text)
    assert fault.path == path
    assert str(fault).startswith(f"{path}: {value} - " if value else f"{path}: ")
    assert (fault.value is NO_VALUE) == (value == "")
    assert (fault.value is MISSING) == (value == "missing")
    at = fault.rule.index(rule)
    assert remedy in fault.rule
    assert (
        remedy in fault.rule[at:] or rule.split()[0] in fault.rule
    )  # the rule is said, then what to do


def directions() -> Iterator[tuple[str, str]]:
    """Every key of a scene that says it is a direction: where it stands, and the key."""
    for path, model in all_sections():
        for key, field in keys(model).items():
            if re.search(r"\(any length but zero\)", field.description or ""):
                yield f"{path}:{tag(model) or ''}", key


#: What has a surface of triangles.
SOLID = """vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
rounding = 0.01
"""
#: How the tables that have directions are written, with `%s` where one more key goes.
TABLES = {
    "rope.shape:knot": knotted('knot = "overhand"\n%s'),
    "anchor.motion:shake": A + HELD + 'motion = { kind = "shake", amplitude = 1, frequency = 1, %s }',
    "anchor.motion:orbit": A + HELD + 'motion = { kind = "orbit", center = [0, 0, 0], frequency = 1, %s }',
    "anchor.clamp:": A.replace("1e4,", "1e4, EI = 1,") + HELD + "[anchor.clamp]\n%s\n",
    "obstacle:plane": A + '[[obstacle]]\nkind = "plane"\n%s',
    "obstacle:sphere": A + BALL + "%s",
    "obstacle:torus": A + BALL.replace("sphere", "torus") + "bar_radius = 0.01\n%s",
    "obstacle:box": A + BOX + "%s",
    "obstacle:half-pipe": A + PIPE + "%s",
    "obstacle:mesh": A + '[[obstacle]]\nkind = "mesh"\n%s\n' + SOLID,
    "obstacle:sdf": A + '[[obstacle]]\nkind = "sdf"\n%s\n' + SOLID,
    "obstacle.motion:shake": moved('kind = "shake", amplitude = 1, frequency = 1, %s'),
    "obstacle.motion:orbit": moved('kind = "orbit", center = [0, 0, 0], frequency = 1, %s'),
    "obstacle.spin:": spun("rate = 1, %s"),
}  # fmt: skip


@pytest.mark.parametrize(("table", "key"), sorted(set(directions())))
def test_a_direction_of_no_length_is_refused_with_one_that_has(table: str, key: str) -> None:
    """Of every direction that scenes have, found by what they say of themselves."""
    given = f"{key} = [0, 0, 0]"
    if table == "anchor.clamp:" and key != "direction":
        given = f"direction = [1, 0, 0]\n{given}"
    fault = first_fault(RUN + TABLES[table] % given)
    assert fault.path.endswith(f".{key}")
    assert re.sub(r"\[\d+\]", "", fault.path) == f"{table.partition(':')[0]}.{key}"
    assert "[0.0, 0.0, 0.0] - must not be zero: give a vector of any length" in str(fault)
    assert "such as [0, 0, 1]" in fault.rule


def test_a_key_that_one_kind_has_is_told_of_one() -> None:
    with pytest.raises(SceneError, match="unknown key of 'cylinder'; only 'box' has it"):
        loads(A + BAR + "edge_radius = 0.01\n")
