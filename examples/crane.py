"""An anchor that follows a table of times and places: how far does the load of a crane swing?"""

from pathlib import Path

import numpy as np

from ropewalk import Result, load, simulate

SCENE = Path(__file__).with_name("crane.toml")


def run() -> Result:
    """Run the scene, whose table is in crane.csv."""
    return simulate(load(SCENE))


def swing(result: Result) -> np.ndarray:
    """How far the load is from below the trolley [m], (frames,)."""
    wire = result.rope("wire")
    return np.linalg.norm((wire.positions[:, -1] - wire.positions[:, 0])[:, :2], axis=1)


def check(result: Result) -> None:
    """The trolley is where the table says, and the load swings on with a pendulum's energy."""
    trolley = result.rope("wire").positions[:, 0]
    assert np.allclose(trolley[result.frame_at(2.5)], (4.0, 0.0, 11.0), atol=1e-6)
    assert np.allclose(trolley[-1], (6.0, 1.0, 10.5), atol=1e-6)
    assert 0.1 < swing(result)[result.time > 4.0].max() < 6.0
    weight = 200.0 * 9.81
    assert result.tension.max() > weight


if __name__ == "__main__":
    found = run()
    check(found)
    print(found)
    print(f"the load swings out by {swing(found).max():.2f} m")
    print(f"the wire carries up to {found.tension.max():.0f} N, {200 * 9.81:.0f} N at rest")
