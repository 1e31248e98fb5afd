"""The classes of `launch` that launch files use. They raise where those of ROS 2 do, and note what would be started."""

from __future__ import annotations

import math
import os
import shlex
import subprocess
import sys
from pathlib import Path


class SubstitutionFailure(RuntimeError):
    """A substitution has no value."""


class Substitution:
    """What is a text only when the launch file runs."""


class Context:
    """What a launch file knows while it runs. `started` is the result: one dictionary for each process or include."""

    def __init__(self, given):
        self.configurations = dict(given)
        self.environment = dict(os.environ)
        self.file = ""
        self.started = []

    def note(self, **what):
        self.started.append(what)


def parts(value):
    """The parts of a text, as normalize_to_list_of_substitutions() of launch."""
    if isinstance(value, (str, Path, Substitution)):
        return [value]
    if not isinstance(value, (list, tuple)):
        raise TypeError(f"'{value!r}' is no text: a str, a Substitution, or a list of these")
    wrong = [part for part in value if not isinstance(part, (str, Path, Substitution))]
    if wrong:
        raise TypeError(f"Failed to normalize given item of type '{type(wrong[0])}'")
    return list(value)


def text_of(context, value):
    """The text that a value has now."""
    return "".join(
        part.perform(context) if isinstance(part, Substitution) else os.fspath(part) for part in parts(value)
    )


class LaunchConfiguration(Substitution):
    def __init__(self, variable_name, *, default=None):
        self.name, self.default = parts(variable_name), default

    def perform(self, context):
        name = text_of(context, self.name)
        if name in context.configurations:
            return context.configurations[name]
        if self.default is None:
            raise SubstitutionFailure(f"launch configuration '{name}' does not exist")
        return text_of(context, self.default)


class EnvironmentVariable(Substitution):
    def __init__(self, name, *, default_value=None):
        self.name, self.default = parts(name), default_value

    def perform(self, context):
        name = text_of(context, self.name)
        if name not in context.environment and self.default is None:
            raise SubstitutionFailure(f"environment variable '{name}' does not exist")
        return context.environment.get(name) or text_of(context, self.default or "")


class PathJoinSubstitution(Substitution):
    def __init__(self, substitutions):
        if isinstance(substitutions, (str, Substitution)):
            raise TypeError("PathJoinSubstitution takes a list")
        self.parts = [parts(one) for one in substitutions]

    def perform(self, context):
        return os.path.join(*(text_of(context, one) for one in self.parts))


class TextSubstitution(Substitution):
    def __init__(self, *, text):
        if not isinstance(text, str):
            raise TypeError(f"TextSubstitution expected a str, not {type(text)}")
        self.text = text

    def perform(self, context):
        return self.text


class PythonExpression(Substitution):
    def __init__(self, expression, python_modules=("math",)):
        self.parts = parts(expression)

    def perform(self, context):
        return str(eval(text_of(context, self.parts), {}, {"math": math, **vars(math)}))  # noqa: S307 (as launch does)


class ThisLaunchFileDir(Substitution):
    def perform(self, context):
        return os.path.dirname(context.file)


class ThisLaunchFile(Substitution):
    def perform(self, context):
        return context.file


class Command(Substitution):
    def __init__(self, command, *, on_stderr="fail"):
        if on_stderr not in ("fail", "ignore", "warn", "capture"):
            raise ValueError(f"on_stderr is '{on_stderr}'")
        self.parts, self.on_stderr = parts(command), on_stderr

    def perform(self, context):
        words = shlex.split(text_of(context, self.parts))
        if words[0] == "xacro":
            words[:1] = [sys.executable, "-c", "import xacro; xacro.main()"]
        ran = subprocess.run(words, capture_output=True, text=True, env=context.environment, check=False)
        if ran.returncode:
            raise SubstitutionFailure(f"executed command failed. Command: {shlex.join(words)}\n{ran.stderr}")
        if ran.stderr and self.on_stderr == "fail":
            raise SubstitutionFailure(f"executed command showed stderr output: {ran.stderr}")
        return ran.stdout


class FindExecutable(Substitution):
    def __init__(self, *, name):
        self.name = parts(name)

    def perform(self, context):
        return text_of(context, self.name)


class _Logical(Substitution):
    def __init__(self, *values):
        self.values = [parts(one) if not isinstance(one, bool) else [str(one)] for one in values]

    def truths(self, context):
        return [truth(text_of(context, one)) for one in self.values]


class NotSubstitution(_Logical):
    def perform(self, context):
        return str(not self.truths(context)[0]).lower()


class AndSubstitution(_Logical):
    def perform(self, context):
        return str(all(self.truths(context))).lower()


class OrSubstitution(_Logical):
    def perform(self, context):
        return str(any(self.truths(context))).lower()


class EqualsSubstitution(Substitution):
    def __init__(self, left, right):
        self.left, self.right = parts(left), parts(right)

    def perform(self, context):
        return str(text_of(context, self.left) == text_of(context, self.right)).lower()


class NotEqualsSubstitution(EqualsSubstitution):
    def perform(self, context):
        return str(text_of(context, self.left) != text_of(context, self.right)).lower()


class IfElseSubstitution(Substitution):
    def __init__(self, condition, if_value="", else_value=""):
        self.condition, self.values = parts(condition), (parts(else_value or [""]), parts(if_value or [""]))

    def perform(self, context):
        return text_of(context, self.values[truth(text_of(context, self.condition))])


def truth(text):
    """The truth of a text, as evaluate_condition_expression() of launch."""
    word = text.strip().lower()
    if word not in ("true", "1", "false", "0"):
        raise ValueError(f"'{text}' is no condition: true, false, 1 or 0")
    return word in ("true", "1")


class IfCondition:
    def __init__(self, predicate_expression):
        self.predicate = parts(predicate_expression)

    def evaluate(self, context):
        return truth(text_of(context, self.predicate))


class UnlessCondition(IfCondition):
    def evaluate(self, context):
        return not super().evaluate(context)


class LaunchConfigurationEquals:
    def __init__(self, launch_configuration_name, expected_value):
        self.name, self.value = launch_configuration_name, expected_value

    def evaluate(self, context):
        return context.configurations.get(self.name) == text_of(context, self.value)


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    def evaluate(self, context):
        return not super().evaluate(context)


class _Source:
    def __init__(self, launch_file_path):
        self.path = parts(launch_file_path)


class AnyLaunchDescriptionSource(_Source):
    pass


class PythonLaunchDescriptionSource(_Source):
    pass


class XMLLaunchDescriptionSource(_Source):
    pass


class FrontendLaunchDescriptionSource(_Source):
    pass
