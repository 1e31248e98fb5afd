"""Keep expressions from running code, reading outside the workspace, or never ending; see replacements.py."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import partial, reduce
from operator import getitem
from types import FunctionType, SimpleNamespace
from typing import Any

from urdfctl.source.disk.files import Files
from urdfctl.source.disk.gate import matching
from urdfctl.source.xacro.expressions import guards
from urdfctl.source.xacro.expressions.compiling import GUARDS, compile_checked, plain_path
from urdfctl.source.xacro.expressions.meter import Meter
from urdfctl.source.xacro.private.replacements import replace
from urdfctl.source.yaml.size import check_size

_PURE_BUILTINS = (
    "abs all any bool complex dict divmod enumerate filter float frozenset hash int isinstance issubclass "
    "len list map max min ord range repr reversed round set slice sorted str sum tuple zip"
).split()

_BYTES = 8
"""As many bytes of a YAML file are as much work as one item of a list."""


def install_safety(module: Any, files: Files, meter: Meter, *, trust: bool) -> None:
    """Replace what evaluates expressions and lists files; with `trust`, keep xacro's own."""
    if trust:
        replace(module, "_global_symbols", module.create_global_symbols())
        return
    replace(module, "safe_eval", _evaluator(meter))
    replace(module, "tokenize", guards.tokenized(module.tokenize))
    replace(module, "glob", SimpleNamespace(glob=partial(_glob, files)))
    replace(module, "_global_symbols", _harmless_symbols(module, meter))


def install_yaml(module: Any, files: Files, meter: Meter, loaded: dict[str, None]) -> None:
    """Replace load_yaml; the files that it reads are added to `loaded`."""

    # a function, because a partial would show expressions what it was made of
    def load_yaml(filename: str) -> Any:
        return _load_yaml(module, files, meter, loaded, filename)

    replace(module, "load_yaml", load_yaml)


def _harmless_symbols(module: Any, meter: Meter) -> Any:
    """Return the names that xacro exposes to expressions, made from guarded builtins and a guarded math."""
    plain = module.__dict__["__builtins__"], module.math
    module.__dict__["__builtins__"], module.math = guards.harmless_builtins(meter.calling), guards.harmless_math()
    try:
        return module.create_global_symbols()
    finally:
        module.__dict__["__builtins__"], module.math = plain


def _glob(files: Files, pattern: str) -> list[str]:
    """Return the files that the pattern of an include matches. Folders that must not be read are not listed."""
    fixed = re.split(r"[*?[]", pattern, maxsplit=1)[0]
    return matching(pattern) if files.may_read(os.path.dirname(fixed)) else []


def _evaluator(meter: Meter) -> Callable[..., Any]:
    def safe_eval(expression: str, symbols: Any, _local: object = None) -> Any:
        expression = expression.strip()
        path = plain_path(expression)
        if path is not None:
            try:
                value = symbols[path[0]]
            except KeyError:  # the expression below says that the name is not defined
                pass
            else:
                return meter.looked_up(value) if len(path) == 1 else meter.checked(reduce(getitem, path[1:], value))
        symbols.update(__builtins__={})
        function = FunctionType(compile_checked(expression, function=True), symbols)
        meter.begin()
        return meter.checked(function(*meter.guards))

    return safe_eval


def _load_yaml(module: Any, files: Files, meter: Meter, loaded: dict[str, None], filename: str) -> Any:
    """Return the content of a YAML file, wrapped as xacro does it. It is read by libyaml if that is installed."""
    from urdfctl.startup.lazy_yaml import SAFE_LOADER, yaml

    loader = type("Loader", (SAFE_LOADER,), {})
    for unit in module.ConstructUnits:
        loader.add_constructor(unit.value.tag, unit.constructor)  # type: ignore[attr-defined]
    path = module.abs_filename_spec(filename)
    text = files.read(path).data
    check_size(text)
    meter.spend(len(text) // _BYTES)
    loaded[path] = None
    module.filestack.append(path)
    try:
        return module.YamlListWrapper.wrap(yaml.load(text, loader))
    finally:
        module.filestack.pop()
        module.all_includes.append(path)


def evaluate_text(module: Any, meter: Meter, expression: str, context: dict[str, Any]) -> str:
    """Evaluate `$(eval ...)` behind the same allow-list as `${...}`, with harmless builtins only."""
    arguments = context.setdefault("arg", {})

    def arg(name: str) -> Any:
        return module.convert_value(module._eval_arg(name, args=arguments), "auto")

    if "__" in expression:
        raise module.SubstitutionException("$(eval ...) may not contain double underscore expressions")
    values = {**module._eval_dict, **vars(guards.harmless_math())}
    known = {"arg": arg, **{name: value for name, value in values.items() if not name.startswith("__")}}
    code = compile_checked(expression.strip())
    meter.begin()
    return str(meter.checked(eval(code, _harmless_globals(meter), module._DictWrapper(arguments, known))))  # noqa: S307 (only the allow-list comes so far)


def _harmless_globals(meter: Meter) -> dict[str, Any]:
    named = guards.harmless_builtins(meter.calling)
    own = zip(GUARDS, meter.guards, strict=True)
    return {"__builtins__": {**{name: named[name] for name in _PURE_BUILTINS}, **dict(own)}}
