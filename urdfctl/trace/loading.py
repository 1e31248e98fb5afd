"""Load a target as lint does, with expanders that record what each value was evaluated from."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.config.settings import Settings
from urdfctl.load.loader import LoadedTarget, Loader
from urdfctl.load.target import Target
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xacro.tracing.expansion import TracingExpander
from urdfctl.source.xacro.tracing.recording import Recorder
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


class Traced(NamedTuple):
    """A loaded target with a description, and the recorder of its expansion."""

    loaded: LoadedTarget
    root: Element
    recorder: Recorder


def tracing(kind: type[Expander]) -> type[TracingExpander]:
    """Return a kind of expander that records its evaluations."""
    if issubclass(kind, TracingExpander):
        return kind
    return type(f"Tracing{kind.__name__}", (TracingExpander, kind), {})


class _TracingLoader(Loader):
    def __init__(self, settings: Settings, overlay: Mapping[str, bytes] | None = None) -> None:
        super().__init__(settings, overlay)
        self.expanders: list[TracingExpander] = []

    def expander(self, path: str, kind: type[Expander] = Expander, *, strict: bool = False) -> TracingExpander:
        """Return an expander for one file that records its evaluations."""
        made = super().expander(path, tracing(kind), strict=strict)
        assert isinstance(made, TracingExpander)  # noqa: S101 (for mypy)
        self.expanders.append(made)
        return made


def traced(settings: Settings, target: Target) -> Traced | None:
    """Return a loaded target with its recorder; None if there is no description, or it cannot be expanded."""
    loader = _TracingLoader(settings)
    loaded = loader.load(target)
    root = loaded.root
    if root is None:
        return None
    own = next(one for one in loader.expanders if one.cloning is root.cloning)
    return Traced(loaded, root, own.recorder)
