"""UC412."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC412",
    severity=Severity.ERROR,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Sequences can only be values and not keys in params'",
    options=["--distro=jazzy"],
    bad={"controllers.yaml": """«- controller_manager»"""},
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
        """
    },
)
def controllers_file_not_a_map(project: Project) -> Iterator[Finding]:
    """A controllers' file holds a list or a text, and no map of names.

    Parameters have names, and so a file of them is a map: `name: value`.
    """
    for fault in faults(project, FaultKind.ROOT):
        yield Finding(fault.at, "a file of parameters is a map of names ('name: value'), and this is none")
