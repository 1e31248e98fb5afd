"""Fixes that insert what is missing: an element in another one, or the text that our generators write."""

from __future__ import annotations

import posixpath

from urdfctl.model.controllers import Controllers
from urdfctl.model.robot import Robot
from urdfctl.rule import Edit, Project
from urdfctl.source.span import Place, SourceSpan


def inserted(at: Place, element: str) -> tuple[Edit, ...]:
    """Return the edit that inserts an element as the first child of the element at a place."""
    tag = at.source.start_tag(at.start)
    if tag is None:
        return ()
    if tag.self_closed:
        return (Edit(SourceSpan(at.source, tag.end - len("/>"), tag.end), f">{element}</{tag.name}>"),)
    inside = at.source.data[tag.end : at.closing]
    blanks = inside[: len(inside) - len(inside.lstrip())].decode() if inside.strip() else ""
    return (Edit(SourceSpan(at.source, tag.end, tag.end), blanks + element),)


def appended_to_robot(robot: Robot, lines: str) -> tuple[Edit, ...]:
    """Return the edit that adds lines before the end tag of a robot that xacro expands."""
    at = robot.at
    if at.closing is None or not at.source.path.endswith(".xacro"):
        return ()
    before = at.source.data[: at.closing]
    start = "" if before.endswith(b"\n") else "\n"
    return (Edit(SourceSpan(at.source, at.closing, at.closing), f"{start}{lines}"),)


def host_element(filename: str, name: str, parameters: str) -> str:
    """Return the plugin that runs the controller manager in the simulator, as gen-gazebo writes it."""
    return (
        "  <!-- Runs the controller manager inside the simulator. -->\n"
        "  <gazebo>\n"
        f'    <plugin filename="{filename}" name="{name}">\n'
        f"      <parameters>{parameters}</parameters>\n"
        "    </plugin>\n"
        "  </gazebo>\n"
    )


def controllers_path(project: Project) -> str | None:
    """Return the only controller file of a manager, as a robot of the same package names it; None if that is unknown."""
    package = project.launch.package if project.launch else None
    files = _files_of_managers(project.controllers) if project.controllers else []
    if package is None or len(files) != 1 or not files[0].startswith(f"{package.folder}/"):
        return None
    return f"$(find {package.name})/{posixpath.relpath(files[0], package.folder)}"


def _files_of_managers(controllers: Controllers) -> list[str]:
    return list(dict.fromkeys(manager.at.source.path for manager in controllers.managers))
