"""Values in launch files in Python: paths, substitutions, descriptions and conditions, in several idioms."""

from __future__ import annotations

from dataclasses import dataclass, field

from systems.possible import Idioms
from systems.render.actions import Arg, Name, Share, Value, Variable, When, args_in

_IMPORTS = {
    "os": "import os",
    "Path": "from pathlib import Path",
    "xacro": "import xacro",
    "NamedTemporaryFile": "from tempfile import NamedTemporaryFile",
    "LaunchDescription": "from launch import LaunchDescription",
    "FindPackageShare": "from launch_ros.substitutions import FindPackageShare",
    "get_package_share_directory": "from ament_index_python.packages import get_package_share_directory",
    "get_package_share_path": "from ament_index_python.packages import get_package_share_path",
    "ParameterValue": "from launch_ros.parameter_descriptions import ParameterValue",
    "ParameterFile": "from launch_ros.descriptions import ParameterFile",
    "ReplaceString": "from nav2_common.launch import ReplaceString",
    "RewrittenYaml": "from nav2_common.launch import RewrittenYaml",
    "XMLLaunchDescriptionSource": "from launch_xml.launch_description_sources import XMLLaunchDescriptionSource",
    "YAMLLaunchDescriptionSource": "from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource",
    "WebotsController": "from webots_ros2_driver.webots_controller import WebotsController",
    **dict.fromkeys(("Node", "PushRosNamespace"), "from launch_ros.actions import {}"),
    **dict.fromkeys(
        (
            "DeclareLaunchArgument",
            "ExecuteProcess",
            "GroupAction",
            "IncludeLaunchDescription",
            "OpaqueFunction",
            "RegisterEventHandler",
            "SetLaunchConfiguration",
            "TimerAction",
        ),
        "from launch.actions import {}",
    ),
    **dict.fromkeys(
        (
            "Command",
            "EnvironmentVariable",
            "FindExecutable",
            "LaunchConfiguration",
            "PathJoinSubstitution",
            "PythonExpression",
            "EqualsSubstitution",
            "NotEqualsSubstitution",
        ),
        "from launch.substitutions import {}",
    ),
    **dict.fromkeys(
        ("IfCondition", "UnlessCondition", "LaunchConfigurationEquals", "LaunchConfigurationNotEquals"),
        "from launch.conditions import {}",
    ),
    **dict.fromkeys(("OnProcessExit", "OnProcessStart"), "from launch.event_handlers import {}"),
    **dict.fromkeys(
        ("PythonLaunchDescriptionSource", "AnyLaunchDescriptionSource"),
        "from launch.launch_description_sources import {}",
    ),
}


def call(name: str, *arguments: str) -> str:
    """Return a call, on several lines if it is long."""
    line = f"{name}({', '.join(arguments)})"
    if len(line) < 100 and "\n" not in line:
        return line
    inside = "".join(f"    {argument},\n".replace("\n", "\n    ").rstrip(" ") for argument in arguments)
    return f"{name}(\n{inside})"


def listed(items: list[str]) -> str:
    """Return a list, on several lines if it is long."""
    return call("", *items).replace("(", "[", 1)[:-1] + "]"


def _merged(pieces: list[str]) -> list[str]:
    """Pieces with literal texts beside each other joined."""
    merged: list[str] = []
    for piece in pieces:
        if merged and piece[:1] == merged[-1][:1] == '"' and piece[-1:] == merged[-1][-1:] == '"':
            merged[-1] = merged[-1][:-1] + piece[1:]
        else:
            merged.append(piece)
    return merged


@dataclass
class PythonValues:
    """Writes values, and remembers what has to be imported for them.

    own: the package of the launch file.
    performs: whether the code has a launch context, so that each value is a text.
    """

    idioms: Idioms
    performs: bool
    own: str = ""
    imports: set[str] = field(default_factory=set)

    def use(self, name: str) -> str:
        """Return a name that is imported."""
        self.imports.add(_IMPORTS[name].format(name))
        return name

    def configuration(self, name: str) -> str:
        """Return the value of a launch argument."""
        plain = f'{self.use("LaunchConfiguration")}("{name}")'
        return f"{plain}.perform(context)" if self.performs else plain

    def value(self, value: Value) -> str:
        """Return a value as an action accepts it: a text, a substitution, or a list of them."""
        if not value:
            return '""'
        pieces = _merged([piece for each in value for piece in self._pieces(each)])
        if len(pieces) == 1:
            return pieces[0]
        if self.performs or not (args_in(value) or self._is_substituted(value)):
            return " + ".join(pieces)
        return f"[{', '.join(pieces)}]"

    def text(self, value: Value) -> str:
        """Return a value as a text, in code that has no launch context either. It depends on no argument then."""
        before, self.performs = self.performs, True
        try:
            return self.value(value)
        finally:
            self.performs = before

    def _is_substituted(self, value: Value) -> bool:
        """Whether a path in it is made by a substitution."""
        paths = self.idioms["paths"]
        return paths in ("find_package_share", "joined") and any(isinstance(piece, Share) for piece in value)

    def _pieces(self, piece: object) -> list[str]:
        if isinstance(piece, Arg):
            return [self.configuration(piece.name)]
        if isinstance(piece, Name):
            return [piece.name]
        if isinstance(piece, Variable):
            return [f'{self.use("EnvironmentVariable")}("{piece.name}", default_value="{piece.default}")']
        if isinstance(piece, Share):
            return self._path(piece)
        return [f'"{piece}"']

    # -- paths ----------------------------------------------------------------------------------------------------

    def _path(self, share: Share) -> list[str]:
        if self.performs:
            return [self._joined_text(share)]
        if args_in(share):
            return self._substituted(share)
        if self.idioms["paths"] in ("find_package_share", "joined"):
            return self._substituted(share)
        return [self._joined_text(share)]

    def _substituted(self, share: Share) -> list[str]:
        """A path made of substitutions: its package or its parts may be arguments."""
        package = self.value(share.package)
        base = f"{self.use('FindPackageShare')}({package})"
        if self.idioms["paths"] not in ("find_package_share", "joined") and not args_in(share.package):
            base = self._base(package)
        parts = [self.value(part) for part in share.parts]
        if self.idioms["paths"] == "joined":
            return [base, *(piece for part in parts for piece in ('"/"', part))]
        return [f"{self.use('PathJoinSubstitution')}([{', '.join([base, *parts])}])"]

    def _base(self, package: str) -> str:
        paths = self.idioms["paths"]
        if paths == "find":
            return f"{self.use('FindPackageShare')}(package={package}).find({package})"
        if paths == "share_path":
            return f"str({self.use('get_package_share_path')}({package}))"
        return f"{self.use('get_package_share_directory')}({package})"

    def _joined_text(self, share: Share) -> str:
        package, paths = self.value(share.package), self.idioms["paths"]
        parts = [self.value(part) for part in share.parts]
        if paths == "file" and share.package == (self.own,):
            return self._beside(parts)
        if paths == "plus":
            ends = " + ".join(f'"/" + {part}' for part in parts)
            return f"{self.use('get_package_share_directory')}({package}) + {ends}".replace('" + "', "")
        if paths in ("pathlib", "share_path"):
            base = f"{self.use('get_package_share_path')}({package})"
            if paths == "pathlib":
                base = f"{self.use('Path')}({self.use('get_package_share_directory')}({package}))"
            return f"str({' / '.join([base, *parts])})"
        base = self._base(package)
        self.imports.add("import os")
        return f"os.path.join({', '.join([base, *parts])})"

    def _beside(self, parts: list[str]) -> str:
        """A path from the launch file itself: it is installed beside the other folders of its package."""
        self.imports.add("import os")
        words = ["os.path.dirname(os.path.abspath(__file__))", '".."', *parts]
        return f"os.path.join({', '.join(words)})"

    # -- conditions -----------------------------------------------------------------------------------------------

    def condition(self, when: When) -> str:
        """Return a condition on an argument."""
        argument = f'{self.use("LaunchConfiguration")}("{when.arg}")'
        if when.form == "expression":
            sign = "==" if when.holds else "!="
            expression = f"[\"'\", {argument}, \"' {sign} '{when.value}'\"]"
            return f"{self.use('IfCondition')}({self.use('PythonExpression')}({expression}))"
        if when.form == "substitution":
            name = "EqualsSubstitution" if when.holds else "NotEqualsSubstitution"
            return f'{self.use("IfCondition")}({self.use(name)}({argument}, "{when.value}"))'
        if when.form == "equals":
            name = "LaunchConfigurationEquals" if when.holds else "LaunchConfigurationNotEquals"
            return f'{self.use(name)}("{when.arg}", "{when.value}")'
        name = "IfCondition" if (when.value == "true") is when.holds else "UnlessCondition"
        return f"{self.use(name)}({argument})"
