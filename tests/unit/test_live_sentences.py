"""What the page says of a refusal: a sentence, with the path behind it."""

from __future__ import annotations

import pytest

from ropewalk.live.messages import error_message, sentence
from ropewalk.live.parameters import PARAMETERS
from ropewalk.scene import Fault, SceneError
from ropewalk.scene.faults import NO_VALUE


@pytest.mark.parametrize(
    ("path", "value", "rule", "said"),
    [
        ("nodes", "12, 36", "cannot meet", 'The two points cannot meet (nodes: "12, 36")'),
        ("node", 3, "is held by no anchor", "This point is held by no anchor (node: 3)"),
        ("mass", -1, "must be more", "Mass must be more (mass: -1)"),
        ("rope[0].bend_radius", 0, "must be more",
         "The bend radius must be more (rope[0].bend_radius: 0)"),
        ("rope[0]", 0, "is not there", "The rope is not there (rope[0]: 0)"),
        ("", None, "there is nothing to undo", "There is nothing to undo"),
        ("slide[0].brake_from", 132.0, "must be on rope 'wire'",
         "The slide's \"brake_from\" must be on rope 'wire' (slide[0].brake_from: 132.0)"),
        ("rope[1].diameter", 0.5, "would have segment 0 inside segment 3",
         "The diameter would have segment 0 inside segment 3 (rope[1].diameter: 0.5)"),
        ("", NO_VALUE, "cannot be read", "This cannot be read"),
    ],
)  # fmt: skip
def test_a_refusal_is_a_sentence_and_its_path_follows(
    path: str, value: object, rule: str, said: str
) -> None:
    assert sentence(Fault(path, value, rule)) == said


def test_each_fault_of_a_message_has_a_line() -> None:
    faults = [Fault("node", 1, "is held"), Fault("mass", 2, "must be less")]
    text = error_message("load", 1, SceneError(faults))["text"]
    assert text == "This point is held (node: 1)\nMass must be less (mass: 2)"


def test_only_faults_of_parameters_have_their_bounds() -> None:
    """A load may weigh nothing; the least and greatest mass of a rope stood beside its refusal."""
    error = SceneError([Fault("mass", -1.0, "must be from 0 to 1e+09 kg")])
    for command, bounds in (("load", (None, None)), ("set", (PARAMETERS["mass"].minimum,) * 2)):
        (fault,) = error_message(command, 1, error)["faults"]
        assert fault["low"] == bounds[0]
        assert (fault["high"] is None) == (command == "load")
