"""What the options of `urdfctl smoke` mean together."""

from __future__ import annotations

from urdfctl.cli.smoke_command import Asked, engines_of, run_smoke
from urdfctl.cli.words import configured, output_of, settings_from
from urdfctl.errors import UserError
from urdfctl.shards import shard as parsed_shard
from urdfctl.smoke.engines import installed
from urdfctl.smoke.job import Wanted
from urdfctl.smoke.reports import SMOKE_FORMATS

MOST_DURATION = 60.0


def smoke_words(  # noqa: PLR0913, PLR0917 (one for each option)
    paths: list[str] | None,
    controllers: list[str] | None,
    only: list[str] | None,
    engine: str,
    duration: float,
    gui: bool,  # noqa: FBT001
    distro: str | None,
    simulator: str | None,
    start: str | None,
    workspace: str | None,
    package_path: list[str] | None,
    env: list[str] | None,
    trust: bool,  # noqa: FBT001
    timeout: float,
    memory: int,
    formats: list[str] | None,
    jobs: int,
    shard: str | None,
    config: str | None,
    report: str | None,
) -> int:
    """Smoke-test with the options of the command line, report it, and give the exit status."""
    if jobs < 0:
        raise UserError(f"--jobs is a number of robots, or 0 for as many as there are processors; not {jobs}")
    if not 0 < duration <= MOST_DURATION:
        raise UserError(f"--duration is a number of seconds up to {MOST_DURATION:g}, not {duration:g}")
    if report == "":
        raise UserError("--report names no file")
    if "" in (controllers or ()):
        raise UserError("--controllers names no file")
    chosen = configured(paths, config, workspace)
    settings = settings_from(chosen, distro, simulator, start, workspace, package_path, env, trust, timeout, memory)
    names = tuple(name.strip() for text in only or () for name in text.split(",") if name.strip())
    outputs = tuple(output_of(text, SMOKE_FORMATS) for text in formats or ("text",))
    of_several = None if shard is None else parsed_shard(shard)
    instead = installed()[1:] if engine == "auto" else ()
    asked = Asked(
        tuple(paths or ()),
        Wanted(names, engines_of(engine), instead, duration, gui, report is not None),
        tuple(controllers or ()),
        outputs,
        jobs,
        of_several,
        report,
        chosen,
    )
    return run_smoke(asked, settings)
