"""The actions of `launch` and `launch_ros`, which raise where those of ROS 2 do."""

from __future__ import annotations

import importlib.util
import os
import re
from collections.abc import Mapping
from pathlib import Path

import yaml
from core import IfCondition, LaunchConfigurationEquals, Substitution, parts, text_of

PROCESS_WORDS = frozenset(
    """
    prefix cwd env additional_env shell sigterm_timeout sigkill_timeout emulate_tty output output_format log_cmd
    cached_output on_exit respawn respawn_delay respawn_max_retries condition exec_name
    """.split()
)


class Action:
    def __init__(self, *, condition=None):
        if condition is not None and not isinstance(condition, (IfCondition, LaunchConfigurationEquals)):
            raise TypeError(f"condition is a {type(condition)}")
        self.condition = condition

    def visit(self, context):
        if self.condition is None or self.condition.evaluate(context):
            for each in self.execute(context) or ():
                each.visit(context)


class LaunchDescription:
    def __init__(self, initial_entities=None):
        self.entities = list(initial_entities or [])
        for one in self.entities:
            if not isinstance(one, (Action, LaunchDescription)):
                raise TypeError(f"{one!r} is no action")

    def add_action(self, action):
        self.entities.append(action)

    def visit(self, context):
        for one in self.entities:
            one.visit(context)


class DeclareLaunchArgument(Action):
    def __init__(self, name, *, default_value=None, description=None, choices=None, **more):
        super().__init__(**more)
        if not isinstance(name, str):
            raise TypeError("the name of an argument is no text")
        self.name, self.choices = name, choices
        self.default_value = parts(default_value) if default_value is not None else None

    def execute(self, context):
        if self.name not in context.configurations:
            if self.default_value is None:
                raise RuntimeError(f"Required launch argument '{self.name}' was not provided.")
            context.configurations[self.name] = text_of(context, self.default_value)
        if self.choices and context.configurations[self.name] not in self.choices:
            raise RuntimeError(f"argument '{self.name}' is none of {self.choices}")


class SetLaunchConfiguration(Action):
    def __init__(self, name, value, **more):
        super().__init__(**more)
        self.name, self.value = parts(name), parts(value)

    def execute(self, context):
        context.configurations[text_of(context, self.name)] = text_of(context, self.value)


class SetEnvironmentVariable(Action):
    def __init__(self, name, value, **more):
        super().__init__(**more)
        self.name, self.value = parts(name), parts(value)

    def execute(self, context):
        context.environment[text_of(context, self.name)] = text_of(context, self.value)


class AppendEnvironmentVariable(SetEnvironmentVariable):
    def __init__(self, name, value, prepend=False, separator=os.pathsep, **more):
        super().__init__(name, value, **more)

    def execute(self, context):
        name = text_of(context, self.name)
        old = context.environment.get(name, "")
        context.environment[name] = os.pathsep.join(filter(None, [old, text_of(context, self.value)]))


class GroupAction(Action):
    def __init__(self, actions, *, scoped=True, forwarding=True, launch_configurations=None, **more):
        super().__init__(**more)
        self.description, self.scoped = LaunchDescription(actions), scoped

    def execute(self, context):
        kept = dict(context.configurations), dict(context.environment)
        self.description.visit(context)
        if self.scoped:
            context.configurations, context.environment = kept


class OpaqueFunction(Action):
    def __init__(self, *, function, args=(), kwargs=None, **more):
        super().__init__(**more)
        self.call = lambda context: function(context, *args, **(kwargs or {}))

    def execute(self, context):
        return self.call(context)


class TimerAction(Action):
    def __init__(self, *, period, actions, **more):
        super().__init__(**more)
        self.description = LaunchDescription(actions)

    def execute(self, context):
        self.description.visit(context)


class LogInfo(Action):
    def __init__(self, *, msg, **more):
        super().__init__(**more)
        self.message = parts(msg)

    def execute(self, context):
        text_of(context, self.message)


class Shutdown(Action):
    def __init__(self, *, reason="", **more):
        super().__init__(**more)

    def execute(self, context):
        context.note(kind="shutdown")


class EmitEvent(Action):
    def __init__(self, *, event, **more):
        super().__init__(**more)

    def execute(self, context):
        context.note(kind="event")


class _Handler:
    def __init__(self, *, target_action=None, handle_once=False, **then):
        self.actions = []
        for name, value in then.items():
            if not name.startswith("on_"):
                raise TypeError(f"unexpected keyword argument '{name}'")
            self.actions += [] if callable(value) else value if isinstance(value, (list, tuple)) else [value]


class OnProcessExit(_Handler):
    pass


class OnProcessStart(_Handler):
    pass


class OnShutdown(_Handler):
    pass


class OnExecutionComplete(_Handler):
    pass


class RegisterEventHandler(Action):
    def __init__(self, event_handler, **more):
        super().__init__(**more)
        self.handler = event_handler

    def execute(self, context):
        LaunchDescription(self.handler.actions).visit(context)


class ExecuteProcess(Action):
    def __init__(self, *, cmd, name=None, condition=None, **options):
        super().__init__(condition=condition)
        if unknown := options.keys() - PROCESS_WORDS:
            raise TypeError(f"ExecuteProcess got an unexpected keyword argument {sorted(unknown)}")
        if isinstance(cmd, str):
            raise TypeError("cmd is one text, not a list of words")
        self.command, self.options = [parts(one) for one in cmd], options
        on_exit = options.get("on_exit")
        if on_exit is not None and not isinstance(on_exit, (Action, list, tuple)) and not callable(on_exit):
            raise TypeError("on_exit is no action")

    def execute(self, context):
        words = [text_of(context, one) for one in self.command]
        for name in ("prefix", "cwd"):
            if self.options.get(name) is not None:
                text_of(context, self.options[name])
        if self.options.get("shell"):
            words = [word for one in words for word in one.split()]
        context.note(kind="process", words=words, exits=self.options.get("on_exit") is not None)


class IncludeLaunchDescription(Action):
    def __init__(self, launch_description_source, *, launch_arguments=None, **more):
        super().__init__(**more)
        self.source = launch_description_source
        self.path = getattr(launch_description_source, "path", None) or parts(launch_description_source)
        self.arguments = [(parts(name), parts(value)) for name, value in launch_arguments or ()]

    def execute(self, context):
        path = text_of(context, self.path)
        given = {text_of(context, name): text_of(context, value) for name, value in self.arguments}
        if path.startswith("/stand_in/") or not path.endswith(".py"):
            context.note(kind="include", file=path, arguments=given, is_there=os.path.isfile(path))
            return
        inner = described_by(path)
        for one in inner.entities:
            is_required = isinstance(one, DeclareLaunchArgument) and one.default_value is None and not one.condition
            if is_required and one.name not in given:
                raise RuntimeError(f"Included launch description missing required argument '{one.name}' in {path}")
        context.configurations.update(given)
        above, context.file = context.file, path
        inner.visit(context)
        context.file = above


def described_by(path):
    """The launch description of a file in Python."""
    spec = importlib.util.spec_from_file_location(re.sub(r"\W", "_", path), path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.generate_launch_description()


def space_of(context, namespace):
    """The namespace of a node: below those pushed, or absolute."""
    pushed = context.configurations.get("ros_namespace", "")
    if namespace.startswith("/"):
        return namespace.rstrip("/")
    return "/".join(filter(None, [pushed, namespace.strip("/")]))


class PushRosNamespace(Action):
    def __init__(self, namespace, **more):
        super().__init__(**more)
        self.namespace = parts(namespace)

    def execute(self, context):
        found = space_of(context, text_of(context, self.namespace))
        context.configurations["ros_namespace"] = found if found.startswith("/") or not found else f"/{found}"


class SetParameter(Action):
    def __init__(self, name, value, **more):
        super().__init__(**more)
        self.name, self.value = parts(name), checked({"it": value})["it"]

    def execute(self, context):
        kept = dict(context.configurations.get("global_params", {}))
        kept[text_of(context, self.name)] = evaluated(context, self.value)
        context.configurations["global_params"] = kept


class SetRemap(Action):
    def __init__(self, src, dst, **more):
        super().__init__(**more)
        self.pair = parts(src), parts(dst)

    def execute(self, context):
        pair = [tuple(text_of(context, one) for one in self.pair)]
        context.configurations["ros_remaps"] = [*context.configurations.get("ros_remaps", []), *pair]


class ParameterValue:
    def __init__(self, value, *, value_type=None):
        self.value, self.value_type = value, value_type
        if not isinstance(value, (bool, int, float, list, tuple)):
            parts(value)


class ParameterFile:
    def __init__(self, param_file, *, allow_substs=False):
        self.path = parts(param_file)


def checked(values):
    """Parameters in a dictionary, as normalize_parameter_dict() of launch_ros."""
    for name, value in values.items():
        if not isinstance(name, (str, Substitution, tuple)):
            raise TypeError(f"the name of a parameter is a {type(name)}")
        if isinstance(value, Mapping):
            checked(value)
        elif isinstance(value, (list, tuple)):
            if not value:
                raise TypeError(f"the list of parameter '{name}' is empty")
            kinds = {type(one) for one in value if not isinstance(one, Substitution)}
            if any(isinstance(one, Substitution) for one in value):
                parts(value)
            elif len(kinds - {int, float}) > 1 or (len(kinds) > 1 and not kinds <= {int, float}):
                raise TypeError(f"Incompatible types in the list of parameter '{name}': {kinds}")
        elif not isinstance(value, (str, bool, int, float, Substitution, ParameterValue, Path)):
            raise TypeError(f"parameter '{name}' is a {type(value)}")
    return values


def evaluated(context, value):
    """The value of a parameter when a node starts, as evaluate_parameters() of launch_ros."""
    if isinstance(value, ParameterValue):
        if value.value_type in (str, int, float):
            return value.value_type(text_of(context, value.value))
        value = value.value
    if isinstance(value, Mapping):
        return {name: evaluated(context, each) for name, each in value.items()}
    is_text = isinstance(value, (str, Substitution, Path)) or (
        isinstance(value, (list, tuple)) and any(isinstance(one, Substitution) for one in value)
    )
    if not is_text:
        return value
    text = text_of(context, value)
    found = text if isinstance(value, str) else yaml.safe_load(text)
    if isinstance(found, dict) or (found is None and text):
        raise TypeError(f"Allowed value types are bytes, bool, int, float, str, lists of these; got {type(found)}")
    return "" if found is None else found


class Node(ExecuteProcess):
    def __init__(
        self,
        *,
        executable,
        package=None,
        name=None,
        namespace=None,
        parameters=None,
        remappings=None,
        ros_arguments=None,
        arguments=None,
        **options,
    ):
        super().__init__(cmd=[executable], **options)
        self.package = parts(package) if package is not None else None
        self.name = parts(name) if name is not None else None
        self.namespace = parts(namespace) if namespace is not None else []
        for what, given in (("arguments", arguments), ("parameters", parameters)):
            if isinstance(given, (str, Substitution, Mapping)):
                raise TypeError(f"{what} is no list")
        self.words = [parts(one) for one in arguments or ()]
        self.parameters = [
            checked(one) if isinstance(one, Mapping) else one if isinstance(one, ParameterFile) else parts(one)
            for one in parameters or ()
        ]
        self.remaps = [(parts(old), parts(new)) for old, new in remappings or ()]

    def execute(self, context):
        words = [text_of(context, one) for one in self.words]
        if self.options.get("shell"):
            words = [word for one in words for word in one.split()]
        files, values = [], dict(context.configurations.get("global_params", {}))
        for one in self.parameters:
            if isinstance(one, Mapping):
                values |= {
                    name if isinstance(name, str) else text_of(context, name): evaluated(context, each)
                    for name, each in one.items()
                }
            else:
                files.append(text_of(context, one.path if isinstance(one, ParameterFile) else one))
        name = text_of(context, self.name) if self.name is not None else ""
        if name and not re.fullmatch(r"[A-Za-z_]\w*", name):
            raise ValueError(f"'{name}' is no valid name of a node")
        context.note(
            kind="node",
            package=text_of(context, self.package) if self.package else "",
            executable=text_of(context, self.command[0]),
            name=name,
            namespace="/" + space_of(context, text_of(context, self.namespace)).strip("/"),
            words=words,
            files=files,
            values=values,
            remaps=[
                *context.configurations.get("ros_remaps", []),
                *((text_of(context, old), text_of(context, new)) for old, new in self.remaps),
            ],
            exits=self.options.get("on_exit") is not None,
        )


class LifecycleNode(Node):
    def __init__(self, *, name, namespace, **more):
        super().__init__(name=name, namespace=namespace, **more)


class ComposableNode:
    def __init__(
        self, *, package, plugin, name=None, namespace=None, parameters=None, remappings=None, extra_arguments=None
    ):
        self.package = package


class ComposableNodeContainer(Node):
    def __init__(self, *, name, namespace, composable_node_descriptions=None, **more):
        super().__init__(name=name, namespace=namespace, **more)
