"""A bench on which the rules on claims look at the small arm with its controllers."""

from __future__ import annotations

from pathlib import Path

from urdfctl.diagnostic import Diagnostic
from urdfctl.lint import Selection, joined
from urdfctl.load import Loader, Target
from urdfctl.rules.examples import completed
from urdfctl.settings import Settings

GAZEBO = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>'
MANAGER = "controller_manager:\n  ros__parameters:\n    update_rate: 100\n"


class Bench:
    """The small arm with its controllers, in a folder of its own; `told` are the beginnings of the codes looked at."""

    def __init__(self, folder: Path, *told: str) -> None:
        self.folder, self.told = folder, told

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
        robot.write_text(part if part.startswith("<robot") else completed(name, part), encoding="utf-8")
        controllers.write_text(yaml, encoding="utf-8")
        settings = Settings(distro=distro, started=started, simulator=simulator, workspace=str(self.folder))
        target = Target(str(robot), controllers=(str(controllers),))
        found = joined([Loader(settings, Selection()).lint(target).outcome], Selection())
        return [one for one in found if one.code.startswith(self.told)]

    def says(self, part: str, yaml: str, **options: object) -> list[str]:
        return [f"{one.severity.value} {one.code} {one.message}" for one in self.lint(part, yaml, **options)]  # type: ignore[arg-type]

    def codes(self, part: str, yaml: str, **options: object) -> list[str]:
        return [" ".join(said.split()[:2]) for said in self.says(part, yaml, **options)]


def forward(name: str, joints: str, interface: str = "position") -> str:
    return f"{name}:\n  ros__parameters: {{joints: [{joints}], interface_name: {interface}}}\n"


def controllers(*names: str, kind: str = "forward_command_controller/ForwardCommandController") -> str:
    return MANAGER + "".join(f"    {name}: {{type: {kind}}}\n" for name in names)
