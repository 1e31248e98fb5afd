"""Run a launch file against the stand-in, and print what it would start as JSON.

Words: a JSON object with the folders of packages by name, the launch file, and arguments NAME:=VALUE.
"""

from __future__ import annotations

import json
import os
import pathlib
import sys
import types

import acting
import core


def share_of(name):
    """The folder of a package: that of the workspace, or one of ROS."""
    return PACKAGES.get(name, f"/stand_in/{name}")


def path_of(name):
    """The same as a path."""
    return pathlib.Path(share_of(name))


class FindPackageShare(core.Substitution):
    def __init__(self, package):
        self.package = core.parts(package)

    def perform(self, context):
        return share_of(core.text_of(context, self.package))

    def find(self, name):
        return share_of(name)


class FindPackagePrefix(FindPackageShare):
    pass


def module(name, *sources, **more):
    """Make a module of a stand-in that has the names of others."""
    made = types.ModuleType(name)
    made.__path__ = []
    for source in sources:
        vars(made).update({key: value for key, value in vars(source).items() if not key.startswith("_")})
    vars(made).update(more)
    sys.modules[name] = made


def install():
    """Make the modules of launch, launch_ros and ament_index_python."""
    module("launch", core, acting)
    for name in ("actions", "event_handlers", "events", "conditions", "substitutions", "launch_description_sources"):
        module(f"launch.{name}", core, acting)
    module("launch_ros", acting)
    ros = {"FindPackageShare": FindPackageShare, "FindPackagePrefix": FindPackagePrefix}
    for name in ("actions", "descriptions", "parameter_descriptions", "substitutions"):
        module(f"launch_ros.{name}", acting, **ros, PushROSNamespace=acting.PushRosNamespace)
    for name in ("ament_index_python", "ament_index_python.packages"):
        module(name, get_package_share_directory=share_of, get_package_prefix=share_of, get_package_share_path=path_of)


def main(packages, path, *given):
    """Print what a launch file starts."""
    PACKAGES.update(json.loads(packages))
    install()
    context = core.Context(word.split(":=", 1) for word in given)
    context.environment["STAND_IN_PACKAGES"] = packages
    context.environment["PYTHONPATH"] = os.path.join(os.path.dirname(os.path.abspath(__file__)), "for_xacro")
    context.file = path
    acting.described_by(path).visit(context)
    print(json.dumps(context.started))


PACKAGES: dict[str, str] = {}
if __name__ == "__main__":
    main(*sys.argv[1:])
