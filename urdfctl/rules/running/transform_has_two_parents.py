"""UC861."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["tf"]["/tf"].append({"parent": "map", "child": "pan_link"})


@fault(
    "UC861",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="poses are wrong",
    authority="tf2: a frame has one parent; the last message counts, and the tree changes between both",
    bad=[example(_break)],
    good=[example()],
)
def transform_has_two_parents(frame: str, parents: str) -> str:
    """Frame has two parents.

    Two nodes publish a transform to it. The tree jumps between them.
    """
    return f"frame '{frame}' has the parents {parents} in tf; only one node may publish it"
