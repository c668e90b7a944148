"""What the user describes: scenes as frozen, validated models, read from and written to TOML."""

from ropewalk.scene.anchor import Anchor, Clamp
from ropewalk.scene.at_nodes import Force, Kick, Load
from ropewalk.scene.environment import Air, Ground, Limiter
from ropewalk.scene.faults import Fault, SceneError, SceneFileError
from ropewalk.scene.guess import Guess
from ropewalk.scene.joint import Joint, Tie
from ropewalk.scene.knot_shape import Knot
from ropewalk.scene.mesh import Mesh, Sdf
from ropewalk.scene.motions import Fixed, Hand, Motion, Orbit, Shake, Table, Velocity
from ropewalk.scene.obstacles import (
    Box,
    Capsule,
    Cylinder,
    HalfPipe,
    Obstacle,
    Plane,
    Sphere,
    Torus,
)
from ropewalk.scene.overrides import apply_overrides
from ropewalk.scene.ring import Ring
from ropewalk.scene.rope import Material, Rope, Springs
from ropewalk.scene.rope_contact import Contact
from ropewalk.scene.rubbing import Pair, RopePair
from ropewalk.scene.run_settings import RunSettings
from ropewalk.scene.scene import Scene
from ropewalk.scene.shapes import Hanging, Points, Polyline, Shape, Slack, Straight
from ropewalk.scene.slide import Slide
from ropewalk.scene.spin import Spin
from ropewalk.scene.tension_curves import (
    Curve,
    ExponentialCurve,
    NeoHookeanCurve,
    PolynomialCurve,
    TableCurve,
)
from ropewalk.scene.toml_text import dumps, load, loads, save, schema
from ropewalk.scene.winch import Winch

__all__ = [
    "Air",
    "Anchor",
    "Box",
    "Capsule",
    "Clamp",
    "Contact",
    "Curve",
    "Cylinder",
    "ExponentialCurve",
    "Fault",
    "Fixed",
    "Force",
    "Ground",
    "Guess",
    "HalfPipe",
    "Hand",
    "Hanging",
    "Joint",
    "Kick",
    "Knot",
    "Limiter",
    "Load",
    "Material",
    "Mesh",
    "Motion",
    "NeoHookeanCurve",
    "Obstacle",
    "Orbit",
    "Pair",
    "Plane",
    "Points",
    "Polyline",
    "PolynomialCurve",
    "Ring",
    "Rope",
    "RopePair",
    "RunSettings",
    "Scene",
    "SceneError",
    "SceneFileError",
    "Sdf",
    "Shake",
    "Shape",
    "Slack",
    "Slide",
    "Sphere",
    "Spin",
    "Springs",
    "Straight",
    "Table",
    "TableCurve",
    "Tie",
    "Torus",
    "Velocity",
    "Winch",
    "apply_overrides",
    "dumps",
    "load",
    "loads",
    "save",
    "schema",
]
