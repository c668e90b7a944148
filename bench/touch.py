"""Contact: what it costs, and whether what should stick sticks; the same in others, side by side.

The capstan is a rope half round a drum, one side longer than the other, the incline a rope that lies on a
plane. MuJoCo (extra `ropewalk[bench]`; without it its rows are left out) gets the same ropes as chains of
capsules with ball joints, once with its default contacts and once with those its documentation advises
against slipping. PyElastica (same extra) gets them as Cosserat rods: `bench.elastica`. Crossing and pile:
`bench.heaps`.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from importlib.util import find_spec
from unittest.mock import patch

import numpy as np

import ropewalk as rw
from bench import elastica
from bench.clock import take_turns
from bench.implicit import Swing
from bench.row import Row
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Cylinder, Plane, Straight

FRICTION, RADIUS, DRUM, GRAVITY = 0.3, 0.005, 0.05, 9.81  # [1], [m], [m], [m/s^2]
PIECES, LIGHT = 12, 0.1  # segments per half turn; rope on the light side [m]
STEP, UNTIL = 1.0 / 60.0, 5.0  # [s]
OFF = 0.5  # [m] what has gone so far has slid off
SLOPE = 16.5  # [degrees] the limit is atan 0.3 = 16.70
LANDED = 30  # steps after which a rope that starts on a floor has been at rest for long
#: MuJoCo's settings: as they come, and against slipping.
MUJOCO = {
    "MuJoCo, defaults": "",
    "MuJoCo, against slipping": 'cone="elliptic" impratio="100" noslip_iterations="10"',
}


def along_capstan(at: float, heavy: float) -> np.ndarray:
    """Return the place [m] after so much of a line from the heavy end over the drum and down, (3,)."""
    reach = DRUM + RADIUS
    if at < heavy:
        return np.array([reach, 0.0, at - heavy])
    angle = (at - heavy) / reach
    if angle < math.pi:
        return np.array([reach * math.cos(angle), 0.0, reach * math.sin(angle)])
    return np.array([-reach, 0.0, heavy + math.pi * reach - at])


def pieces_along(heavy: float, piece: float, count: int) -> list[float]:
    """Return where on the line over the drum the ends of straight pieces of one length lie [m]."""
    ats = [0.0]
    for _ in range(count):
        here, low, high = along_capstan(ats[-1], heavy), ats[-1], ats[-1] + 2.0 * piece
        for _ in range(60):
            middle = 0.5 * (low + high)
            short = np.linalg.norm(along_capstan(middle, heavy) - here) < piece
            low, high = (middle, high) if short else (low, middle)
        ats.append(low)
    return ats


def capstan(share: float) -> rw.Scene:
    """Return a rope over a drum whose one side hangs to a share of what the other and friction hold.

    That is e^(mu pi) h + R 2 mu / (1 + mu^2) (e^(mu pi) + 1), its weight on the drum counted in.
    """
    reach, grows = DRUM + RADIUS, math.exp(FRICTION * math.pi)
    wrapped = reach * 2.0 * FRICTION / (1.0 + FRICTION**2) * (grows + 1.0)
    piece, light = math.pi * reach / PIECES, LIGHT
    count = round((share * (grows * light + wrapped) + light) / piece) + PIECES
    for _ in range(6):  # sides of which both, and all pieces, are as long as they should be
        heavy = share * (grows * light + wrapped)
        ats = pieces_along(heavy, piece, count)
        light = (ats[-1] - math.pi * reach - share * wrapped) / (share * grows + 1.0)
    places = [tuple(map(float, along_capstan(at, heavy))) for at in ats]
    rope = rw.Rope(
        segments=len(places) - 1,
        length=piece * (len(places) - 1),
        diameter=2.0 * RADIUS,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=1.0),
        shape=rw.scene.Points(points=places),
    )
    drum = Cylinder(start=(0, -0.1, 0), end=(0, 0.1, 0), radius=DRUM, friction=FRICTION)
    run = rw.RunSettings(method="esdirk3", time_step=STEP, duration=UNTIL)
    return rw.Scene(ropes=rope, obstacles=[drum], run=run)


def incline(degrees: float, segments: int = 30) -> rw.Scene:
    """Return a rope that lies along the fall of a plane."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    length = segments * 0.02
    made_of = rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=1.0)
    up = (RADIUS * s, 0.0, RADIUS * c)
    shape = Straight(start=up, direction=(c, 0.0, -s))
    rope = rw.Rope(
        segments=segments, length=length, diameter=2.0 * RADIUS, made_of=made_of, shape=shape
    )
    run = rw.RunSettings(method="esdirk3", time_step=STEP, duration=UNTIL)
    return rw.Scene(ropes=rope, obstacles=[Plane(normal=(s, 0.0, c), friction=FRICTION)], run=run)


def crept(x: np.ndarray, t: np.ndarray) -> float:
    """Return the farthest that a node which lies on something goes from 1 s to the end [m], at most OFF.

    Those that hang swing; x is (frames, nodes, 3).
    """
    first = int(np.argmin(np.abs(t - 1.0)))
    lies = x[0, :, 2] >= (DRUM * 0.2 if x[0, :, 2].max() > 0.5 * DRUM else -np.inf)
    way = np.linalg.norm(x[-1, lies] - x[first, lies], axis=1)
    return min(float(way.max()), OFF)


def in_ropewalk(scene: rw.Scene) -> tuple[float, float]:
    """Return how far it crept [m], and the processor time [s]."""
    begun = time.process_time()
    result = simulate_in_memory(scene)
    assert result.status == "finished", result.diagnosis
    return crept(result.positions, result.time), time.process_time() - begun


def in_mujoco(scene: rw.Scene, options: str, step: float = 1e-3) -> tuple[float, float]:
    """Return the same of a chain of capsules in MuJoCo."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(as_mujoco(scene, options, step))
    data = mujoco.MjData(model)
    links = [i for i in range(model.nbody) if model.body(i).name.startswith("link")]
    begun, places, times = time.process_time(), [], []
    while data.time < UNTIL - 0.5 * step:
        mujoco.mj_step(model, data)
        if len(places) * STEP <= data.time:
            places.append(data.xpos[links].copy())
            times.append(data.time)
    return crept(np.array(places), np.array(times)), time.process_time() - begun


def in_elastica(scene: rw.Scene) -> tuple[float, float]:
    """Return the same of a Cosserat rod in PyElastica."""
    found = elastica.run(scene)
    return crept(found.places, found.times), found.seconds


def as_mujoco(scene: rw.Scene, options: str, step: float) -> str:
    """Return the scene's rope and its one obstacle as a model."""
    rope, (body,) = scene.ropes[0], scene.obstacles
    x = np.array(rw.Simulation(scene).positions)
    mass = rope.own_mass / rope.segments
    chain = ""
    for i in range(rope.segments):
        place = x[i] if i == 0 else x[i] - x[i - 1]
        # As much damping as a thread has: none that could hold.
        joint = "<freejoint/>" if i == 0 else '<joint type="ball" damping="1e-5" armature="1e-7"/>'
        chain += (
            f'<body name="link{i}" pos="{_text(place)}">{joint}<geom type="capsule" size="{RADIUS}" '
            f'fromto="0 0 0 {_text(x[i + 1] - x[i])}" mass="{mass}" friction="{FRICTION} 0 0" condim="3" '
            f'contype="1" conaffinity="2"/>'
        )
    chain += "</body>" * rope.segments
    touch = f'friction="{FRICTION} 0 0" condim="3" contype="2" conaffinity="1"'
    if body.kind == "plane":
        solid = f'<geom type="plane" size="10 10 1" zaxis="{_text(body.normal)}" {touch}/>'
    else:
        solid = (
            f'<geom type="cylinder" size="{body.radius}" '
            f'fromto="{_text(body.start)} {_text(body.end)}" {touch}/>'
        )
    return (
        f'<mujoco><option timestep="{step}" gravity="0 0 {-GRAVITY}" '
        f'integrator="implicitfast" {options}/>'
        f"<worldbody>{solid}{chain}</worldbody></mujoco>"
    )


def _text(values: object) -> str:
    return " ".join(f"{float(value):.12g}" for value in values)  # type: ignore[attr-defined]


def sticking() -> list[Row]:
    """How far what should hold creeps from 1 s to 5 s: capstan and incline, here and in others."""
    programs: dict[str, Callable[[rw.Scene], tuple[float, float]]] = {"Ropewalk": in_ropewalk}
    if find_spec("mujoco") is not None:
        for name, options in MUJOCO.items():
            programs[name] = lambda scene, options=options: in_mujoco(scene, options)  # type: ignore[misc]
    if find_spec("elastica") is not None:
        programs["PyElastica"] = in_elastica
    cases = {
        f"capstan at {share:g} of the limit": capstan(share) for share in (0.8, 0.95, 0.99, 1.05)
    }
    cases |= {
        f"incline of {degrees:g} degrees": incline(degrees) for degrees in (10.0, SLOPE, 18.0)
    }
    in_ropewalk(cases["capstan at 0.8 of the limit"])  # compiles
    rows = []
    for case, scene in cases.items():
        target = "slips" if "1.05" in case or "18" in case else "holds"
        for name, run in programs.items():
            way, seconds = run(scene)
            rows.append(Row(f"{case}, {name}, way from 1 s to 5 s", 1e3 * way, "mm", target))
            rows.append(Row(f"{case}, {name}, processor time", seconds, "s", ""))
    return rows


def on_obstacles() -> list[Row]:
    """What contact costs: none in reach, 10^4 nodes on a floor, 300 segments on an incline at 60 Hz."""
    far = Plane(point=(0, 0, -1e3))
    rows = []
    one = incline(0.0, 1000)
    times, _ = _turns(
        {"none": one.replace(obstacles=[]), "far": one.replace(obstacles=[far])}, 6, rounds=100
    )
    rows.append(Row("a floor out of reach / none", times["far"] / times["none"], "1", ""))
    lying = incline(0.0, 10_000)
    for how, begin in (("landing on", 0), ("that lies on", LANDED)):
        times, solves = _turns({"none": lying.replace(obstacles=[]), "floor": lying}, 2, begin)
        ratio, more = times["floor"] / times["none"], solves["floor"] / solves["none"]
        said = f"10^4 nodes, {how} a floor / falling"
        rows.append(Row(f"a step of {said}", ratio, "1", "<= 3"))
        rows.append(Row(f"solves of a step of {said}", more, "1", ""))
    for degrees, how in ((10.0, "sticking"), (25.0, "slipping")):
        swing = Swing(incline(degrees, 300), 60)
        timed = take_turns({how: swing.run}, rounds=5, before={how: swing.restore})
        rows.append(
            Row(
                f"300 segments {how} on an incline, 60 Hz",
                1.0 / timed.best(how),
                "x real time",
                ">= 20",
            )
        )
    return rows


def without_contacts() -> list[Row]:
    """What a scene without contacts pays for those of others: nothing in kernels of its own.

    So it is timed beside itself by the kernels that scenes with any rarer law take, in which all laws are and
    none acts here: no scene without contacts pays more. Twice by its own tells what the clock can tell.
    """
    rows = []
    for method, step, steps in (("esdirk3", STEP, 6), ("semi-implicit-euler", 1e-5, 200)):
        run = rw.RunSettings(method=method, time_step=step, duration=UNTIL)
        falling = incline(0.0, 1000).replace(obstacles=[], run=run)
        swings = {"its own": Swing(falling, steps), "its own again": Swing(falling, steps)}
        with patch("ropewalk.lowering.system.rare_of", lambda _: 1):
            swings["those of all laws"] = Swing(falling, steps)
        runs, before = (
            {name: getattr(one, do) for name, one in swings.items()} for do in ("run", "restore")
        )
        timing = take_turns(runs, rounds=100, before=before)
        for name, target in (("those of all laws", "<= 1.02"), ("its own again", "")):
            said = f"a step without contacts, {method}: by {name} / its own kernels"
            rows.append(Row(said, timing.ratio(name, "its own"), "1", target))
    return rows


def _turns(
    scenes: dict[str, rw.Scene], steps: int, begin: int = 0, rounds: int = 8
) -> tuple[dict[str, float], dict[str, int]]:
    """Return the least time of so many steps [s], after `begin` untimed ones, and how often they solve."""
    swings = {name: Swing(scene, steps) for name, scene in scenes.items()}
    for swing in swings.values():
        swing.go_on(begin)
    solves = {name: swing.iterations for name, swing in swings.items()}
    runs = {name: swing.run for name, swing in swings.items()}
    before = {name: swing.restore for name, swing in swings.items()}
    timing = take_turns(runs, rounds=rounds, before=before)
    return {name: timing.best(name) for name in scenes}, solves
