"""Contacts of a run as tables: who touches what, with what force, and whether it sticks."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record import contacts
from ropewalk.record.export import export
from ropewalk.record.quantities import TOGETHER, stored
from ropewalk.scene import Cylinder, HalfPipe, Plane, Points, Polyline, Scene, loads

g = 9.81


def sliding(degrees: float = 0.0, speed: float = 1.0) -> rw.Result:
    """A rope that slides along a plane of mu = 0.3 and stops after 0.34 s."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    points = ", ".join(f"[{0.05 * i * c}, 0, {-0.05 * i * s}]" for i in range(5))
    scene = loads(f"""
[run]
duration = 0.6
frame_rate = 60
method = "esdirk3"
time_step = 0.016666666666666666
[[rope]]
segments = 4
length = 0.2
made_of = {{ kind = "material", EA = 1e3, mass_per_length = 0.1 }}
shape = {{ kind = "points", points = [{points}], velocity = [{speed * c}, 0, {-speed * s}] }}
[[obstacle]]
name = "floor"
kind = "plane"
normal = [{s}, 0, {c}]
""")
    return rw.simulate(scene)


def test_a_sliding_rope_slips_and_then_sticks() -> None:
    """Friction carries mu R_n and the slip speed falls by mu g; then both are nothing."""
    result = sliding()
    modes = result.contact_modes
    assert modes.shape == (result.frames, 5)
    assert (modes[10] == 2).all()
    assert (modes[-1] == 1).all()
    assert (modes[0] == 0).all()
    table = result.to_pandas("contacts")
    late = table[table["time [s]"] > 0.5]
    assert set(late["mode"]) == {"sticks"}
    now = table[np.isclose(table["time [s]"], 10 / 60)]
    assert list(now["node"]) == [0, 1, 2, 3, 4]
    assert set(now["obstacle"]) == {"floor"}
    assert np.allclose(now["friction force [N]"], 0.3 * now["normal force [N]"], rtol=1e-6)
    assert now["normal force [N]"].sum() == pytest.approx(0.02 * g, rel=1e-3)
    assert np.allclose(now["slip speed [m/s]"], 1.0 - 0.3 * g * 10 / 60, atol=0.02)
    assert np.allclose(now["friction used [1]"], 1.0, rtol=1e-6)


def test_forces_of_contacts_are_those_that_were_recorded() -> None:
    """On a slope that holds: friction is the weight's part along it."""
    result = sliding(10.0, 0.0)
    table = result.to_pandas("contacts")
    last = table[table["time [s]"] == table["time [s]"].max()]
    whole = np.linalg.norm(result.contact_force[-1].sum(axis=0))
    sums = last["normal force [N]"].sum(), last["friction force [N]"].sum()
    assert math.hypot(*sums) == pytest.approx(whole)
    share = last["friction force [N]"].sum() / last["normal force [N]"].sum()
    assert share == pytest.approx(math.tan(math.radians(10.0)), rel=1e-3)
    assert (last["friction used [1]"] < 1.0).all()
    used = (last["friction used [1]"] * last["normal force [N]"]).sum()
    assert used * 0.3 == pytest.approx(last["friction force [N]"].sum(), rel=1e-6)
    force = last[["fx [N]", "fy [N]", "fz [N]"]].to_numpy()
    assert np.allclose(force, result.contact_force[-1], rtol=1e-9, atol=1e-12)
    assert np.array_equal(last[["x [m]", "y [m]", "z [m]"]], result.positions[-1])
    there = result.datasets["contacts"].where(result.datasets["contacts"].time == result.time[-1])
    assert float(there["fz"].sum()) == pytest.approx(result.contact_force[-1, :, 2].sum())


def over_a_drum() -> Scene:
    from ropewalk.scene import apply_overrides

    return apply_overrides(rw.preset("capstan"), ["run.duration=0.2"])


def test_a_wrap_has_its_angle_and_its_ratio() -> None:
    result = rw.simulate(over_a_drum())
    wrap = result.wrap("drum")
    assert wrap.angle[-1] == pytest.approx(3.0 * math.pi, rel=0.02)
    assert wrap.ratio[-1] == pytest.approx(wrap.after[-1] / wrap.before[-1])
    first, last = wrap.nodes[-1]
    assert 0 < first < last < result.nodes - 1
    with pytest.raises(KeyError, match="name one of the obstacles drum"):
        result.wrap("post")


def test_an_end_that_grazes_the_side_is_no_part_of_a_wrap() -> None:
    """1 kg below an edge that is blown against the wall: the tension after the edge was told as 0 N."""
    rope = rw.Rope(
        segments=70,
        length=0.7,
        diameter=0.01,
        made_of=rw.Material(EA=2e4, mass_per_length=0.01, axial_damping=20.0),
        shape=Polyline(points=[(-0.2, 0, 0.0055), (0.006, 0, 0.0055), (0.006, 0, -0.6)]),
        loads=[rw.Load(node=-1, mass=1.0)],
        forces=[rw.Force(node=-1, force=(-0.3, 0, 0))],
    )
    rock = rw.Box(name="rock", center=(-1, 0, -1), half_sizes=(1, 0.2, 1), edge_radius=0.05)
    result = rw.equilibrium(Scene(ropes=[rope], obstacles=[rock], anchors=[rw.Anchor(node=0)]))
    table = result.to_pandas("wraps")
    assert table["tension after [N]"].iloc[-1] == 0.0  # the load itself, against the wall
    wrap = result.wrap("rock")
    assert wrap.nodes[0, 1] < 40 < rope.segments
    assert 1.0 * g < wrap.after[0] == table["tension after [N]"].iloc[0]


def test_a_rope_that_comes_back_to_a_bar_has_no_ratio_there() -> None:
    """Of a tackle, whose friction on the other bar was in it: ln(ratio) over the angle was 0.145 for 0.1."""
    radius, mu, count = 0.055, 0.1, 16
    turns = [(math.pi, 0.0, 0.0), (0.0, -math.pi, -0.3), (math.pi, 0.0, 0.0)]
    points = [(-radius, 0.0, -0.02 * i) for i in range(20, 0, -1)]
    for first, last, height in turns:
        points += [
            (radius * math.cos(a), 0.0, height + radius * math.sin(a))
            for a in np.linspace(first, last, count + 1)
        ]
    points += [(radius, 0.0, -0.02 * i) for i in range(1, 21)]
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    heavy = math.exp(0.95 * mu * 3.0 * math.pi)
    rope = rw.Rope(
        segments=len(points) - 1,
        length=length,
        diameter=0.01,
        made_of=rw.Material(EA=1e5, mass_per_length=0.001, axial_damping=20.0),
        shape=Points(points=points),
        loads=[rw.Load(node=0, mass=1.0), rw.Load(node=-1, mass=heavy)],
    )
    bars = [
        Cylinder(name=name, start=(0, -1, z), end=(0, 1, z), radius=0.05, friction=mu)
        for name, z in (("A", 0.0), ("B", -0.3))
    ]
    result = rw.equilibrium(Scene(ropes=[rope], obstacles=bars))
    twice, once = result.wrap("A"), result.wrap("B")
    assert (twice.parts[0], once.parts[0]) == (2, 1)
    assert twice.angle[0] == pytest.approx(2.0 * math.pi, rel=1e-3)
    assert twice.after[0] / twice.before[0] == pytest.approx(heavy, rel=0.01)
    assert math.isnan(twice.ratio[0])
    assert 1.0 < once.ratio[0] <= math.exp(1.01 * mu * math.pi)


@pytest.mark.parametrize("every", [2, 3])
def test_a_wrap_is_whole_whichever_of_its_nodes_are_asked_for(every: int) -> None:
    """Of every second node a bollard's had half its angle, and of every third it was in pieces."""
    result = rw.simulate(rw.preset("bollard").replace(**{"run.duration": 0.1}))
    whole = result.to_pandas("wraps")
    some = result.to_pandas("wraps", nodes=range(0, result.nodes, every))
    assert whole["angle [rad]"].iloc[-1] == pytest.approx(4.0 * math.pi, rel=0.01)
    assert some.equals(whole)
    first = int(whole["first node"].min())
    assert first > 0
    assert result.to_pandas("wraps", nodes=range(first)).empty


def tackle() -> Scene:
    """A rope over a bar, under a second one and over the first again, 1 kg and 1.3 kg at its ends."""
    half = np.linspace(0.0, math.pi, 61)
    c, s = 0.055 * np.cos(half), 0.055 * np.sin(half)
    over, under = np.stack([-c, s], axis=1), np.stack([c, -0.4 - s], axis=1)
    flat = np.vstack([[(-0.055, -0.6)], over, under, over, [(0.055, -0.6)]])
    way = np.cumsum(np.hypot(*np.diff(flat, axis=0, prepend=flat[:1]).T))  # aslant, not bent aside
    way = 0.06 * way / way[-1] - 0.03
    corners = [(float(x), float(y), float(z)) for (x, z), y in zip(flat, way, strict=True)]
    rope = rw.Rope(
        segments=160,
        length=float(np.linalg.norm(np.diff(corners, axis=0), axis=1).sum()),
        diameter=0.01,
        made_of=rw.Material(EA=2e4, mass_per_length=0.01, axial_damping=20.0),
        shape=Polyline(points=corners),
        loads=[rw.Load(node=0, mass=1.0), rw.Load(node=-1, mass=1.3)],
    )
    bars = [
        Cylinder(name=name, start=(0, -0.2, z), end=(0, 0.2, z), radius=0.05, friction=0.1)
        for name, z in (("upper", 0.0), ("lower", -0.4))
    ]
    return Scene(ropes=[rope], obstacles=bars)


def test_a_rope_twice_over_a_bar_has_two_wraps() -> None:
    """Each with its own tensions and half a turn; what it turns by under the other bar is none of them."""
    result = rw.equilibrium(tackle())
    table = result.to_pandas("wraps").sort_values("first node")
    table = table[table["angle [rad]"] > 0.1]  # the legs hang down beside the lower bar
    assert list(table["obstacle"]) == ["upper", "lower", "upper"]
    assert table["angle [rad]"].to_numpy() == pytest.approx(math.pi, rel=5e-3)
    slips, round_ = table["ratio at slip [1]"].to_numpy(), math.exp(0.1 * math.pi)
    assert slips[1] == pytest.approx(round_, rel=2e-3)
    assert slips[[0, 2]] == pytest.approx(
        0.988 * round_, rel=2e-3
    )  # bent aside into legs that hang
    assert (table["ratio [1]"] < 1.002 * table["ratio at slip [1]"]).all()  # it has a weight
    both = result.wrap("upper")
    assert both.angle[0] == pytest.approx(2.0 * math.pi, rel=5e-3)
    ends = both.before[0], both.after[0]
    assert ends == (table["tension before [N]"].iloc[0], table["tension after [N]"].iloc[-1])
    assert ends == pytest.approx((1.0 * g, 1.3 * g), rel=0.01)


@pytest.mark.parametrize("where", ["trough", "floor"])
def test_what_lies_in_a_trough_or_bent_on_a_floor_is_not_wrapped(where: str) -> None:
    """A quarter of a circle, which a rope without weight would leave, or draw straight: it holds nothing."""
    a = np.linspace(-0.25, 0.25, 21) * math.pi
    if where == "trough":
        body = HalfPipe(name=where, start=(0, -1, 0.5), end=(0, 1, 0.5), radius=0.5, friction=1.2)
        places = np.stack([0.495 * np.sin(a), 0.0 * a, 0.5 - 0.495 * np.cos(a)], axis=1)
    else:
        body = Plane(name=where, friction=1.2)
        places = np.stack([0.495 * np.sin(a), 0.495 * np.cos(a), 0.005 + 0.0 * a], axis=1)
    made_of = rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)
    rope = rw.Rope(
        segments=20,
        length=float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum()),
        diameter=0.01,
        made_of=made_of,
        shape=Points(points=places.tolist()),
    )
    result = rw.equilibrium(Scene(ropes=[rope], obstacles=[body]))
    (row,) = result.to_pandas("wraps").to_dict("records")
    assert row["last node"] - row["first node"] == 20
    assert row["angle [rad]"] == pytest.approx(0.0, abs=1e-3)
    assert row["ratio at slip [1]"] == pytest.approx(1.0, abs=1e-3)


def test_contacts_go_into_files(tmp_path: Path) -> None:
    result = sliding()
    paths = {path.name: path for path in export(result, "csv", tmp_path)}
    lines = paths["contacts.csv"].read_text().splitlines()
    assert lines[0].startswith("time [s],rope,node,obstacle,normal force [N]")
    assert len(lines) == 1 + len(result.to_pandas("contacts"))
    assert "sticks" in lines[-1].split(",")
    some = result.to_pandas("contacts", nodes=[0], every=5)
    assert set(some["node"]) == {0}


def test_without_obstacles_there_are_none() -> None:
    result = rw.simulate(rw.preset("r1"))
    assert not result.contact_modes.any()
    with pytest.raises(ValueError, match="this run has none"):
        result.to_pandas("contacts")


def crossed(contact: str) -> rw.Result:
    """A rope on a floor, and one that lies across it and is pulled aside and down at its ends."""
    stuff = 'made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 2.0 }'
    rope = f"segments = 9\nlength = 0.4\ndiameter = 0.02\n{stuff}"
    scene = loads(f"""
{contact}
[run]
method = "implicit-euler"
time_step = 0.0041666667
duration = 0.2
[[obstacle]]
kind = "plane"
[[rope]]
name = "line"
{rope}
shape = {{ kind = "straight", start = [-0.2, 0, 0.0101], end = [0.2, 0, 0.0101] }}
[[rope]]
name = "over"
{rope}
shape = {{ kind = "straight", start = [0.0, -0.2, 0.0303], end = [0.0, 0.2, 0.0303] }}
force = [{{ node = 0, force = [2.0, 0, -3.0] }}, {{ node = -1, force = [2.0, 0, -3.0] }}]
[[anchor]]
rope = "line"
node = 0
""")
    return rw.simulate(scene)


def test_without_contact_of_ropes_there_is_no_table_of_it() -> None:
    result = crossed("")
    assert "rope_contacts" not in result.source.names
    with pytest.raises(ValueError, match="this run has none"):
        result.to_pandas("rope_contacts")


@pytest.fixture(scope="module")
def both() -> rw.Result:
    """A rope between a floor and another rope."""
    return crossed("[contact]")


def test_friction_of_obstacles_is_told_apart_from_that_of_ropes(both: rw.Result) -> None:
    """Where a node touches both, too: what the other rope gave was once friction, and then unknown."""
    table = both.to_pandas("contacts")
    below = table[(table["rope"] == "line") & table["node"].isin([4, 5])]
    assert len(below) > both.frames  # it lies on the floor, and under the other
    assert table["friction used [1]"].notna().all()
    assert set(table["mode"]) == {"sticks", "slips"}
    assert table["friction used [1]"].max() <= 1.0 + 1e-9


def test_obstacles_and_ropes_add_up_to_all_contacts(both: rw.Result) -> None:
    """Without the obstacles' force ropes give nothing in all; the table's rows are that of obstacles."""
    ropes = both.contact_force - both.obstacle_force
    assert np.abs(ropes).max() > 0.5
    assert np.abs(ropes.sum(axis=1)).max() < 1e-12 * np.abs(ropes).max()
    told = np.zeros_like(both.obstacle_force)
    for _, row in both.to_pandas("contacts").iterrows():
        frame, node = both.frame_at(row["time [s]"]), both.layout.node(row["node"], row["rope"])
        told[frame, node] += row[["fx [N]", "fy [N]", "fz [N]"]].to_numpy(float)
    assert told == pytest.approx(both.obstacle_force, abs=1e-12)


def test_the_force_of_obstacles_is_stored_and_shown_in_tables(
    both: rw.Result, tmp_path: Path
) -> None:
    opened = both.save(tmp_path / "run")
    assert np.array_equal(opened.obstacle_force, both.obstacle_force)
    assert opened.dataset["obstacle_force"].dims == ("time", "node", "axis")
    nodes = both.to_pandas("nodes")
    assert nodes["obstacle fz [N]"].sum() == pytest.approx(both.obstacle_force[..., 2].sum())
    alone = crossed("")
    assert "obstacle_force" not in alone.source.names
    assert np.array_equal(alone.obstacle_force, alone.contact_force)


def test_a_shape_of_rest_has_all_tables(both: rw.Result) -> None:
    """They once raised errors of types. Floor and anchor bear all weight, a rope what hangs over it."""
    rest = rw.equilibrium(
        both.scene.replace(ropes=[r.replace(forces=()) for r in both.scene.ropes])
    )
    floor, held = rest.to_pandas("contacts")["fz [N]"], rest.reactions[0, :, 2].sum()
    weight = 0.1 * 0.4 * g
    assert floor.sum() + held == pytest.approx(2.0 * weight, rel=1e-6)
    assert rest.obstacle_force[0, :, 2].sum() == pytest.approx(floor.sum())
    of_over = rest.to_pandas("contacts", rope="over")["fz [N]"].sum()
    below = rest.to_pandas("rope_contacts")["fz [N]"].sum()
    assert below == pytest.approx(of_over - weight, rel=1e-6)
    assert "obstacle fz [N]" in rest.to_pandas("nodes")


def test_a_run_that_does_not_know_them_apart_says_so(
    both: rw.Result, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As those recorded until format 7: friction is not known where a rope is touched as well."""
    layout, scene = both.layout, both.scene
    before = {quantity.name for quantity in stored(layout, scene, TOGETHER)}
    now = {quantity.name for quantity in stored(layout, scene, TOGETHER + 1)}
    assert now - before == {"obstacle_force"}
    monkeypatch.setattr(both.source, "_names", tuple(before))
    table = both.to_pandas("contacts")
    used = table["friction used [1]"]
    assert used.isna().any()
    assert used.notna().any()
    assert set(table["mode"][used.isna()]) == {"unknown"}
    modes = both.contact_modes
    for _, row in table[used.isna()].iterrows():
        frame = both.frame_at(row["time [s]"])
        assert modes[frame, both.layout.node(row["node"], row["rope"])] == 3
    assert np.isnan(both.obstacle_force).all()


def test_of_several_obstacles_at_a_node_slipping_shows_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """One that slips and one that is unknown: the node slips; unknown and sticking: unknown."""
    result = crossed("")
    slips, sticks, unknown = (np.array(rub) for rub in ([0.3, 0, 0], [0.1, 0, 0], [np.nan, 0, 0]))
    count = 4
    made = contacts.Contacts(
        obstacle=np.array([0, 1, 0, 1]),
        node=np.array([2, 2, 5, 5]),
        normal=np.tile([0.0, 0.0, 1.0], (count, 1)),
        push=np.ones(count),
        turn=np.zeros(count),
        aside=np.zeros(count),
        rub=np.stack([slips, unknown, unknown, sticks]),
        friction=np.full(count, 0.3),
        slip=np.array([[1.0, 0, 0], *[[0.0, 0, 0]] * 3]),
        cone=np.full(count, 0.3),
        off=np.zeros(count),
        given=np.full(count, 0.3),
    )
    monkeypatch.setattr(contacts, "each_frame", lambda result, frames: [(0, made)])
    modes = contacts.contact_modes(result, [0])[0]
    assert (modes[2], modes[5], modes[3]) == (contacts.SLIPS, contacts.UNKNOWN, 0)
    assert (contacts.node_modes(result, [0])[0] == modes).all()


def test_on_a_pulley_a_rope_slips_over_the_wheel_as_it_turns() -> None:
    """At every frame by its rate then; by that of the first one it slipped at the wheel's own 0.66 m/s."""
    result = rw.simulate("pulley")
    table = result.to_pandas("contacts")
    rim = np.abs(result.pulley("wheel").speed[-1]) * 0.05
    assert rim > 0.5
    assert table["slip speed [m/s]"].max() < 0.05 * rim
    assert (table["mode"] == "sticks").mean() > 0.8
    power = table.groupby("time [s]")["friction power [W]"].sum()
    assert abs(power.sum()) * (result.time[1] - result.time[0]) < 2e-3  # the rope gives it 0.26 J
    last = table[table["time [s]"] == result.time[-1]]
    alone = result.to_pandas("contacts", times=[float(result.time[-1])])
    assert np.array_equal(alone["slip speed [m/s]"], last["slip speed [m/s]"])


def test_what_sticks_gives_back_by_its_spring_what_friction_never_does() -> None:
    """Power of friction at a frame is that of the spring, too; over a time it comes to what is lost."""
    rope = rw.Rope(
        segments=4,
        length=0.2,
        diameter=0.01,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=0.1),
        shape={"kind": "straight", "start": (0, 0, 0.00495), "end": (0.2, 0, 0.00495)}
        | {"velocity": (0.003, 0, 0)},
    )
    run = {"method": "esdirk3", "time_step": 1e-4, "duration": 0.05, "frame_rate": 10000}
    result = rw.simulate(
        Scene(ropes=[rope], obstacles=[Plane(name="floor", friction=0.5)], run=run)
    )
    table = result.to_pandas("contacts")
    assert set(table["mode"]) == {"sticks"}
    power = table.groupby("time [s]")["friction power [W]"].sum()
    assert power.max() > 5e-3 * -power.min() > 0.0
    lost = result.contact_work["floor"]["friction"]
    assert np.diff(lost).max() <= 1e-15
    pairs = 0.5 * (power.to_numpy()[1:] + power.to_numpy()[:-1])
    assert (pairs * np.diff(power.index)).sum() == pytest.approx(lost[-1], rel=0.03)
