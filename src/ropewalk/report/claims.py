"""The table of claims."""

from __future__ import annotations

from ropewalk.report import claims_friction, claims_model, claims_rates, claims_shape, claims_steps
from ropewalk.report.outcome import Claim

MODEL, FRICTION, STEPS, SHAPE = "The model", "Friction", "Time steps", "Loops and waves"
DRAWING = "Physics and drawing"

CLAIMS: tuple[Claim, ...] = (
    Claim("C1", "One mass on a spring", "The smallest model of a rope is one mass that hangs on "
          "one spring from a fixed point.", MODEL, claims_model.one_spring),
    Claim("C2", "Weight and two springs", "The net force on a mass of the rope is its weight and "
          "the pull of the two springs beside it.", MODEL, claims_model.two_springs),
    Claim("C3", "Only gravity at first", "A rope that starts straight, at rest length, feels only "
          "gravity in its first moment.", MODEL, claims_model.only_gravity),
    Claim("C4", "Without damping, no rest", "Without a damping force the rope swings for ever.",
          FRICTION, claims_friction.never_rests),
    Claim("C5", "Spring friction brings rest", "Friction inside the springs makes the motion die "
          "down to rest, as in a real rope.", FRICTION, claims_friction.comes_to_rest),
    Claim("C6", "Friction acts like air", "Spring friction has an effect like that of air "
          "resistance.", FRICTION, claims_friction.like_air),
    Claim("C7", "Smaller friction, less decay", "With a smaller friction coefficient the motion "
          "decays much less and is less smooth.", FRICTION, claims_friction.smaller_friction),
    Claim("C8", "Better than plain Euler", "Semi-implicit Euler stays closer to the exact solution "
          "than plain Euler, at no more cost.", STEPS, claims_steps.better_than_euler),
    Claim("C9", "Nine or ten steps a frame", "A step of 2 ms makes 9 to 10 steps of physics for "
          "each frame at 60 Hz.", STEPS, claims_steps.substeps),
    Claim("C10", "Stiff springs bounce less", "A high spring constant makes the rope less bouncy.",
          SHAPE, claims_shape.bounce),
    Claim("C11", "A taut section loops", "A section exactly as long as the distance of its anchors "
          "stretches into a shallow loop.", SHAPE, claims_shape.shallow_loop),
    Claim("C12", "Curvature and spring constant", "How much that loop curves depends on the spring "
          "constant.", SHAPE, claims_shape.curvature),
    Claim("C13", "Moving a point makes waves", "Moving the left point sends waves through the "
          "rope, which slowly die down.", SHAPE, claims_shape.waves),
    Claim("C14", "Stiff springs break at 60 Hz", "At one step a frame, the springs of 10 kN/m break "
          "quickly.", STEPS, claims_steps.breaks_at_once),
    Claim("C15", "200 N/m break after swings", "With 200 N/m at 60 steps a second the rope does not "
          "break right away, but after a few swings.", STEPS, claims_rates.breaks_after_swings),
    Claim("C16", "100 N/m stand, but bounce", "With 100 N/m at 60 steps a second the rope is "
          "stable, but bounces a lot more.", STEPS, claims_rates.stable_but_bouncy),
    Claim("C17", "Rate against stiffness", "Fewer steps a second must be paid for with softer "
          "springs.", STEPS, claims_rates.tradeoff),
    Claim("C18", "Physics apart from drawing", "The engine only computes positions and does not "
          "depend on how they are drawn.", DRAWING, claims_rates.same_bits),
)  # fmt: skip


def claim(name: str) -> Claim:
    """Return a claim by its id, such as "C8". Raises KeyError when there is none."""
    for one in CLAIMS:
        if one.id == name.upper():
            return one
    raise KeyError(f"no claim {name!r}; there are {CLAIMS[0].id} to {CLAIMS[-1].id}")
