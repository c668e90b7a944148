"""A loaded rope between two points: how hard does it pull when the load drops into it?"""

from ropewalk import Anchor, Load, Material, Result, Rope, RunSettings, Scene, simulate
from ropewalk.scene import Slack


def run() -> Result:
    """Run it for two seconds."""
    line = Material(EA=9810.0, mass_per_length=0.063, axial_damping=20.0)  # N, kg/m, N s
    shape = Slack(end=(8.0, 0.0, 1.0))
    load = Load(node=24, mass=5.0)
    rope = Rope(segments=48, length=12.0, made_of=line, shape=shape, loads=[load])
    anchors = [Anchor(node=0), Anchor(node=-1)]
    return simulate(Scene(ropes=[rope], anchors=anchors, run=RunSettings(duration=2.0)))


def check(result: Result) -> None:
    """The load's weight is 49 N; dropping, it pulls harder than that, and nothing breaks."""
    assert result.status == "finished"
    assert 49.0 < result.tension.max() < 1000.0


if __name__ == "__main__":
    found = run()
    check(found)
    print(found)
    print(f"largest tension {found.tension.max():.1f} N, at first {found.tension[0].max():.1f} N")
