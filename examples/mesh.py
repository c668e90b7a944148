"""A material stays the same rope with more segments; a rope of springs becomes another one."""

from ropewalk import Anchor, Material, Rope, RunSettings, Scene, Springs, simulate
from ropewalk.scene import Straight

Numbers = dict[str, dict[int, float]]


def sag(rope: Rope) -> float:
    """How far the middle of a rope between its ends, 10 m apart, hangs at its lowest [m]."""
    anchors = [Anchor(node=0), Anchor(node=-1)]
    run = RunSettings(
        duration=3.0, method="semi-implicit-euler"
    )  # one for all: only segments differ
    scene = Scene(ropes=[rope], anchors=anchors, run=run)
    return -float(simulate(scene).rope().positions[:, rope.nodes // 2, 2].min())


def run() -> Numbers:
    """Run both with 20, 40 and 80 segments."""
    shape = Straight(end=(10.0, 0.0, 0.0))
    found: Numbers = {"material": {}, "springs": {}}
    for segments in (20, 40, 80):
        line = Material(EA=5000.0, mass_per_length=0.1, axial_damping=50.0)
        rope = Rope(segments=segments, length=10.0, made_of=line, shape=shape)
        found["material"][segments] = sag(rope)
        springs = Springs(
            spring_constant=10000.0,
            node_mass=0.05,
            spring_friction=1.0,
            segment_length=10.0 / segments,
        )
        found["springs"][segments] = sag(Rope(segments=segments, made_of=springs, shape=shape))
    return found


def check(found: Numbers) -> None:
    """Four times the segments: the material's sag changes by 1 %, that of springs more than doubles."""
    material, springs = found["material"], found["springs"]
    assert abs(material[80] / material[20] - 1.0) < 0.01
    assert springs[80] > 2.0 * springs[20]


if __name__ == "__main__":
    numbers = run()
    print("segments   material    springs     (lowest point of the middle)")
    for count in numbers["material"]:
        print(f"{count:8}  {numbers['material'][count]:8.4f} m {numbers['springs'][count]:8.4f} m")
    check(numbers)
