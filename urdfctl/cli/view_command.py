"""`urdfctl view`: the robot in 3-D."""

from __future__ import annotations

from urdfctl.cli.robot_targets import best_of, robots_of
from urdfctl.cli.words import configured, settings_to_check
from urdfctl.cli.writing import print_message, write_file
from urdfctl.errors import UserError
from urdfctl.report.common import shown
from urdfctl.startup.hints import TYPE_CHECKING
from urdfctl.view.html import html
from urdfctl.view.job import portraits
from urdfctl.view.meshes import installed

if TYPE_CHECKING:
    from urdfctl.cli.see_options import ViewOptions


def run_view(options: ViewOptions) -> int:
    """Write the page of a robot, and return the exit status 0."""
    if not installed():
        raise UserError("the libraries that read meshes are not installed: pip install 'urdfctl[view]'")
    if options.image is not None and not options.image.lower().endswith(".png"):
        raise UserError(f"'{options.image}' is not a PNG: only .png can be written")
    words = options.paths or []
    config = configured(words, options)
    settings = settings_to_check(config, options, [word for word in words if ":=" not in word])
    pairs = robots_of(words, config, settings)
    found = best_of(pairs)
    if found is None:
        raise UserError(f"no robot in {', '.join(words) or 'this folder'}")
    target, result = found
    others = {other.path for _, other in pairs} - {result.path}
    if others:
        print_message(f"showing {shown(result.path)}, one of {len(others) + 1} robots; name another to see that")
    [portrait] = portraits([target], settings, in_3d=True)
    if portrait.crashed:
        raise RuntimeError(portrait.failure)
    if portrait.scene is None:
        raise UserError(f"'{shown(result.path)}' cannot be shown: {portrait.failure or 'it has no links'}")
    for note in portrait.scene["notes"]:
        print_message(note)
    if options.image is not None:
        from urdfctl.view.image import png

        write_file(options.image, png(portrait.scene), force=True)
        if options.output is None:
            return 0
    distro = portrait.graph.distro if portrait.graph and result.controllers else ""
    write_file(options.output or "robot.html", html(portrait.scene, result.path, distro), force=True)
    return 0
