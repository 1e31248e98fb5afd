"""Small robots for the tests of rules, each linted in this process in a folder of its own."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.findings.merging import merge
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.rules.examples import completed

GAZEBO = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>'
MANAGER = "controller_manager:\n  ros__parameters:\n    update_rate: 100\n"


def findings(
    target: Target | Path | str, codes: tuple[str, ...] = (), settings: Settings | None = None, **options: Any
) -> list[Diagnostic]:
    """Return the findings in a target, as a report shows them; `options` are settings, `codes` prefixes of rules."""
    selection = Selection(codes)
    target = target if isinstance(target, Target) else Target(str(target))
    result = lint_target(Loader(settings or Settings(**options)), target, selection).result
    assert not result.outcome.crashed
    return merge([result.outcome], selection)


class Robot:
    """An arm with the joints shoulder and elbow; each call adds a part to it, or replaces it by a whole <robot>."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def lint(
        self, part: str, *, distro: str | None = None, simulator: str | None = None, name: str = "robot.urdf"
    ) -> list[Diagnostic]:
        path = self.folder / name
        path.write_text(whole(name, part), encoding="utf-8")
        return findings(path, distro=distro, simulator=simulator, workspace=str(self.folder))

    def says(self, part: str, **options: str) -> list[str]:
        return [f"{finding.severity.value} {finding.code}" for finding in self.lint(part, **options)]

    def only(self, code: str, part: str, **options: str) -> Diagnostic:
        [finding] = [finding for finding in self.lint(part, **options) if finding.code == code]
        return finding

    def fixed(self, finding: Diagnostic) -> str:
        """Return the line that a finding points to, with its fix applied."""
        assert finding.fix is not None
        data = bytearray((self.folder / "robot.urdf").read_bytes())
        for edit in sorted(finding.fix.edits, key=lambda edit: edit.start, reverse=True):
            data[edit.start : edit.end] = edit.text.encode()
        return data.decode().splitlines()[finding.at.line - 1].strip()


class Bench:
    """The same arm with controllers; only findings whose codes begin with one of `prefixes` are returned."""

    def __init__(self, folder: Path, *prefixes: str) -> None:
        self.folder, self.prefixes = folder, prefixes

    def lint(
        self,
        part: str,
        yaml: str,
        *,
        distro: str | None = "jazzy",
        started: tuple[str, ...] | None = None,
        simulator: str | None = None,
        name: str = "robot.urdf",
    ) -> list[Diagnostic]:
        robot, controllers = self.folder / name, self.folder / "controllers.yaml"
        robot.write_text(whole(name, part), encoding="utf-8")
        controllers.write_text(yaml, encoding="utf-8")
        target = Target(str(robot), controllers=(str(controllers),))
        found = findings(target, distro=distro, started=started, simulator=simulator, workspace=str(self.folder))
        return [finding for finding in found if finding.code.startswith(self.prefixes)]

    def says(self, part: str, yaml: str, **options: Any) -> list[str]:
        return [
            f"{finding.severity.value} {finding.code} {finding.message}" for finding in self.lint(part, yaml, **options)
        ]

    def codes(self, part: str, yaml: str, **options: Any) -> list[str]:
        return [f"{finding.severity.value} {finding.code}" for finding in self.lint(part, yaml, **options)]


def whole(name: str, part: str) -> str:
    """Return a robot: a part put into the small arm, or a whole <robot> unchanged."""
    return part if part.startswith("<robot") else completed(name, "PART\n").replace("PART", part)


def notes(finding: Diagnostic) -> str:
    return "\n".join(note.message for note in finding.notes)


def forward(name: str, joints: str, interface: str = "position") -> str:
    return f"{name}:\n  ros__parameters: {{joints: [{joints}], interface_name: {interface}}}\n"


def controllers(*names: str, kind: str = "forward_command_controller/ForwardCommandController") -> str:
    return MANAGER + "".join(f"    {name}: {{type: {kind}}}\n" for name in names)
