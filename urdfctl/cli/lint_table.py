"""The options of `lint`, as fast_path.py needs them.

Generated from options.py: python -m urdfctl.cli.fast_path lint > urdfctl/cli/lint_table.py
"""

from __future__ import annotations

FLAGS = {
    "--trust": "trust",
    "-q": "quiet",
    "--quiet": "quiet",
    "--statistics": "statistics",
    "--exit-zero": "exit_zero",
    "--no-cache": "no_cache",
    "--show-settings": "show_settings",
    "--fix": "fix",
    "--unsafe-fixes": "unsafe_fixes",
    "--diff": "diff",
}
REPEATABLE = {
    "--package-path": "package_path",
    "--env": "env",
    "--select": "select",
    "--ignore": "ignore",
    "--extend-select": "extend_select",
    "--format": "formats",
    "--node": "node",
}
VALUES = {
    "--workspace": ("workspace", "str"),
    "--timeout": ("timeout", "float"),
    "--memory": ("memory", "int"),
    "--config": ("config", "str"),
    "--distro": ("distro", "str"),
    "--simulator": ("simulator", "str"),
    "--start": ("start", "str"),
    "--jobs": ("jobs", "int"),
    "--shard": ("shard", "str"),
    "--fail-on": ("fail_on", "str"),
    "--baseline": ("baseline", "str"),
    "--write-baseline": ("write_baseline", "str"),
    "-o": ("output_file", "str"),
    "--output-file": ("output_file", "str"),
    "--report": ("report", "str"),
}
DEFAULTS: dict[str, object] = {
    "workspace": None,
    "package_path": None,
    "env": None,
    "trust": False,
    "timeout": 20.0,
    "memory": 2048,
    "config": None,
    "distro": None,
    "simulator": None,
    "paths": None,
    "start": None,
    "jobs": 0,
    "shard": None,
    "select": None,
    "ignore": None,
    "extend_select": None,
    "formats": None,
    "fail_on": None,
    "baseline": None,
    "write_baseline": None,
    "output_file": None,
    "quiet": False,
    "statistics": False,
    "report": None,
    "exit_zero": False,
    "no_cache": False,
    "show_settings": False,
    "fix": False,
    "unsafe_fixes": False,
    "node": None,
    "diff": False,
}
