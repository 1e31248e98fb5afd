"""Help of the commands: options in groups, and what each option accepts; the same for the completion of a shell."""

from collections.abc import Sequence

from typer.core import TyperCommand

from urdfctl.catalog.distros import ALL, SIMULATORS
from urdfctl.report import FORMATS
from urdfctl.startup.hints import Any

GROUPS: dict[str, tuple[str, ...]] = {
    "What it is checked for": ("distro", "simulator", "start", "only", "engine", "duration", "gui"),
    "Rules": ("select", "ignore", "extend_select", "node"),
    "Fixes": ("fix", "unsafe_fixes", "diff"),
    "Joints": ("joints", "exclude", "joint", "left", "right", "traction", "steering"),
    "Controllers": (
        *("types", "controller", "chain", "interface", "command_interface", "state", "group", "broadcaster", "rate"),
        *("namespace", "name", "sensor", "frame", "hardware", "controllers"),
    ),
    "Output": (
        *(
            "formats",
            "diff_formats",
            "graph_formats",
            "focus",
            "collapse",
            "output_format",
            "output_file",
            "quiet",
            "statistics",
            "report",
            "show_settings",
        ),
        *("output", "into", "macro", "form", "package", "templates", "list_templates", "force", "check", "update"),
    ),
    "Exit status and known findings": ("fail_on", "areas", "exit_zero", "allow_empty", "baseline", "write_baseline"),
    "Files and limits": (
        *("workspace", "package_path", "env", "trust", "config", "timeout", "memory", "jobs", "shard", "no_cache"),
    ),
}
"""The options of each group, in the order of the help. Other options come last."""

CHOICES: dict[str, Sequence[str]] = {
    "distro": ALL,
    "simulator": SIMULATORS,
    "formats": FORMATS,
    "diff_formats": ("text", "markdown", "html", "json"),
    "graph_formats": ("mermaid", "dot", "svg", "html", "json"),
    "fail_on": ("error", "warning", "info"),
    "engine": ("auto", "pybullet", "mujoco", "both", "none"),
    "output_format": ("text", "json"),
    "form": ("python", "xml", "yaml"),
    "interface": ("position", "velocity", "effort"),
    "command_interface": ("position", "velocity", "effort"),
    "hardware": ("gz", "gazebo-classic", "mock", "mujoco", "topic-based"),
}
"""The values of options that the help lists and a shell completes. The commands check them."""

_OPEN = ("hardware", "interface", "command_interface")
_METAVARS = {
    **dict.fromkeys(("workspace", "package_path", "templates"), "FOLDER"),
    **dict.fromkeys(("config", "baseline", "write_baseline", "output_file", "report", "into"), "FILE"),
    **dict.fromkeys(("select", "ignore", "extend_select"), "CODE,..."),
    **dict.fromkeys(("start", "only", "joint", "left", "right", "traction", "steering", "state"), "NAME,..."),
    **dict.fromkeys(("joints", "exclude"), "REGEX"),
    **dict.fromkeys(("env", "name", "sensor", "frame", "package", "namespace"), "NAME"),
    "distro": "DISTRO",
    "areas": "AREA,...",
    "focus": "NAME",
    "node": "NAME=FILE",
    "types": "TYPE",
    "controller": "NAME=TYPE[:JOINTS]",
    "output": "PATH",
    "controllers": "FILE",
    "timeout": "SECONDS",
    "duration": "SECONDS",
    "memory": "MIB",
    "jobs": "N",
    "rate": "HZ",
}


class GroupedCommand(TyperCommand):
    """A command whose help shows its options in groups, with the values that they accept."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        for parameter in self.params:
            choices = CHOICES.get(parameter.name or "")
            if parameter.param_type_name != "option" or parameter.is_flag:  # type: ignore[attr-defined]
                continue
            if parameter.metavar is None:
                parameter.metavar = _metavar(parameter.name or "", choices)
            elif parameter.metavar.startswith("["):
                choices = tuple(parameter.metavar.strip("[]").split("|"))
            if choices:
                parameter._custom_shell_complete = _completing(choices)

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the arguments, then the options in groups."""
        records: dict[str, list[tuple[str, str]]] = {name: [] for name in ("Arguments", *GROUPS, "Other")}
        group_of = {option: group for group, options in GROUPS.items() for option in options}
        if all(parameter.name != "fix" for parameter in self.params):
            group_of["diff"] = "Output"
        for parameter in self.get_params(ctx):
            record = parameter.get_help_record(ctx)
            if record is not None:
                group = group_of.get(parameter.name or "", "Other")
                records[group if parameter.param_type_name == "option" else "Arguments"].append(record)
        used = {name: entries for name, entries in records.items() if entries}
        options = [name for name in used if name != "Arguments"]
        for name, entries in used.items():
            with formatter.section("Options" if options == [name] else name):
                formatter.write_dl(entries)


def _metavar(name: str, choices: Sequence[str] | None) -> str:
    if choices is None or name == "distro":
        return _METAVARS.get(name, "VALUE")
    return f"[{'|'.join(choices)}{'|...' if name in _OPEN else ''}]"


def _completing(choices: Sequence[str]) -> Any:
    def completed(_ctx: Any, _parameter: Any, incomplete: str) -> list[str]:
        return [choice for choice in choices if choice.startswith(incomplete)]

    return completed
