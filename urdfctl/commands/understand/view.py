"""`urdfctl view`: the robot in 3-D."""

from __future__ import annotations

from urdfctl.commands.answering import AnswerOptions, answered
from urdfctl.commands.declaring import OUTPUT, Command, Reads, option
from urdfctl.commands.options import StartOptions
from urdfctl.commands.robot_targets import best_of, robots_of
from urdfctl.commands.words import configured, settings_to_check
from urdfctl.errors import UserError
from urdfctl.output.answer import CommandAnswer, FileState
from urdfctl.output.links import check_output
from urdfctl.output.writing import write_file
from urdfctl.report.common import shown
from urdfctl.view.html import html
from urdfctl.view.job import portraits
from urdfctl.view.meshes import installed


class ViewOptions(StartOptions, AnswerOptions):
    """Show the robot in 3-D, its joints coloured by how they are controlled: a page that needs no network.

    \b
    Example: urdfctl view urdf/robot.xacro -o robot.html
    """

    output: str | None = option(
        OUTPUT,
        "Write the page to this file. Default: robot.html.",
        "-o",
        "--output",
        metavar="PATH",
        reads=Reads.TARGET,
    )
    image: str | None = option(OUTPUT, "Write a picture (PNG) to this file, without a page.", metavar="FILE")


def run_view(options: ViewOptions) -> int:
    """Write the page of a robot, and return the exit status 0."""
    return answered("view", options, lambda answer: _view(options, answer))


def _view(options: ViewOptions, answer: CommandAnswer) -> int:
    if options.image is not None and not installed():
        raise UserError("the libraries that draw pictures are not installed: pip install 'urdfctl[view]'")
    if options.image is not None and not options.image.lower().endswith(".png"):
        raise UserError(f"'{options.image}' is not a PNG: only .png can be written")
    page = None if options.image is not None and options.output is None else options.output or "robot.html"
    check_output(options.image, page)
    words = options.paths
    config = configured(words, options)
    settings = settings_to_check(config, options, [word for word in words if ":=" not in word])
    pairs = robots_of(words, config, settings)
    found = best_of(pairs)
    if found is None:
        raise UserError(f"no robot in {', '.join(words) or 'this folder'}")
    target, result = found
    others = {other.path for _, other in pairs} - {result.path}
    if others:
        answer.message(f"showing {shown(result.path)}, one of {len(others) + 1} robots; name another to see that")
    [portrait] = portraits([target], settings, in_3d=True)
    if portrait.crashed:
        raise RuntimeError(portrait.failure)
    if portrait.scene is None:
        raise UserError(f"'{shown(result.path)}' cannot be shown: {portrait.failure or 'it has no links'}")
    for note in portrait.scene["notes"]:
        answer.message(note)
    if options.image is not None:
        from urdfctl.view.image import png

        write_file(options.image, png(portrait.scene), force=True)
        answer.file(options.image, FileState.WRITTEN)
    if page is not None:
        distro = portrait.graph.distro if portrait.graph and result.controllers else ""
        write_file(page, html(portrait.scene, result.path, distro), force=True)
        answer.file(page, FileState.WRITTEN)
    return 0


command = Command(ViewOptions, run_view)
