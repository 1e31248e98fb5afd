"""Launch files replace texts in YAML files before they load them."""

from __future__ import annotations

from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import SourceText
from urdfctl.source.yaml.replacing import with_replacements
from urdfctl.source.yaml.tree import Mapping, Scalar, Sequence, read_yaml

TEXT = b"<ns>/arm:\n  joints: [<ns>/a, b]\n  gains: <gains>\n"


def test_keys_and_scalars_have_texts_replaced_and_keep_their_places() -> None:
    file = read_yaml(SourceText("c.yaml", TEXT))
    made = with_replacements(file, [("<ns>/", "left/"), ("<gains>", "[1, 2]"), ("<absent>", "x")])
    (root,) = made.documents
    assert isinstance(root, Mapping)
    arm = root.get("left/arm")
    assert isinstance(arm, Mapping)
    joints, gains = arm.get("joints"), arm.get("gains")
    assert isinstance(joints, Sequence)
    assert isinstance(gains, Scalar)
    assert [item.text for item in joints.items if isinstance(item, Scalar)] == ["left/a", "b"]
    assert (gains.text, gains.at.span.text) == (UNKNOWN, "<gains>")


def test_a_file_without_these_texts_stays_the_same() -> None:
    file = read_yaml(SourceText("c.yaml", TEXT))
    assert with_replacements(file, [("<other>", "x")]) is file
