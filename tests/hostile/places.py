"""Places that files may be in, or that options may name: pipes, devices, full disks, odd names; and what is said.

An entry of a table is a command line and the line that it must print.
"""

from __future__ import annotations

NAMES = [
    "b.urdf",
    "x.yaml",
    "x.launch",
    "package.xml",
    "urdfctl.toml",
    "pyproject.toml",
    ".gitignore",
    "CMakeLists.txt",
]
"""Files in whose place is a pipe, a device or a loop."""
GEN = "--type effort --distro noetic"
ARM = """\
<robot name="arm">
  <link name="base"/><link name="fore"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="fore"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""

PIPES = [
    ("lint a.urdf --baseline pipe", "'pipe' cannot be read: it is not a regular file"),
    ("lint a.urdf --write-baseline pipe", "'pipe' cannot be written: it is a pipe that no program reads"),
    ("lint a.urdf --config pipe", "pipe: it is not a regular file"),
    ("lint a.urdf --format json=pipe", "'pipe' cannot be written: it is a pipe that no program reads"),
    ("lint a.urdf --workspace pipe", "folder 'pipe' does not exist"),
    ("lint a.urdf --package-path pipe", "folder 'pipe' does not exist"),
    ("smoke a.urdf --engine none --report pipe", "'pipe' cannot be written: it is a pipe that no program reads"),
    (
        "smoke a.urdf --engine none --format json=pipe",
        "'pipe' cannot be written: it is a pipe that no program reads",
    ),
    ("expand a.urdf -o pipe", "'pipe' cannot be written: it is a pipe that no program reads"),
    ("explain ./pipe", "'./pipe' is not a regular file"),
    (f"gen-controllers pipe.yaml {GEN}", "'pipe.yaml' cannot be read: it is not a regular file"),
    (f"gen-controllers --joint a {GEN} -o pipe", "'pipe' cannot be written: it is a pipe that no program reads"),
    (f"gen-controllers --joint a {GEN} --templates pipe", "template folder does not exist: 'pipe'"),
    (f"gen-transmissions a.urdf {GEN} --into pipe", "'pipe' cannot be read: it is not a regular file"),
    (f"gen-all --joint a {GEN} -o pipe", "'pipe/config/controllers.yaml' cannot be written: Not a directory"),
]
"""`pipe` and `pipe.yaml` are pipes that no program reads or writes."""

ENVIRONMENTS: list[dict[str, str | None]] = [
    {"HOME": None, "USER": None, "TERM": None},
    {"LC_ALL": "C", "LANG": None, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
    {"LC_ALL": "none_XX.nowhere"},
]

IN_ANY_ENVIRONMENT = [
    "lint PATH",
    "lint PATH --fix --diff",
    "expand PATH",
    "gen-all PATH --type effort --distro noetic -o OUT",
    "explain fehler.log",
    "smoke PATH --engine none",
]
"""PATH is a robot, and OUT a folder for what is made; both have odd names."""

ON_A_FULL_DISK = ["lint a.urdf --format sarif=/dev/full", "expand a.urdf -o /dev/full", "expand a.urdf"]

SHOWN = [
    ("lint settings/a.urdf", 2, "settings/urdfctl.toml: unknown key '\\x1b[31mred'"),
    (f"gen-controllers names {GEN}", 2, "several robots found: names/\\x1b[31m.urdf, names/b.urdf"),
    (
        "gen-check made",
        2,
        (
            "'made/c.yaml' is skipped: its input '\\x1b[31mred.urdf' does not exist\n"
            "urdfctl: no generated file was checked in made"
        ),
    ),
    ("smoke made/\x1b[31m", 2, "file or folder 'made/\\x1b[31m' does not exist"),
]
"""What names and files hold that a terminal would obey, the exit status, and what is said."""
