"""Select the rules of a run, and their severities."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from urdfctl.diagnostic import Severity
from urdfctl.errors import UserError
from urdfctl.rules import all_faults
from urdfctl.rules.installed import installed_rules
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.config.file import Config


class Selection(NamedTuple):
    """Rules selected by prefixes of their codes. The longest matching prefix decides.

    select: prefixes of the rules to use; empty for all rules.
    ignore: prefixes of the rules not to use.
    extend: prefixes added to `select`.
    severities: pairs of a prefix and a severity, or "off".
    """

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    extend: tuple[str, ...] = ()
    severities: tuple[tuple[str, str], ...] = ()

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Selection:
        """Return the selection that `_asdict` and JSON made `data` from."""
        severities = tuple((code, severity) for code, severity in data["severities"])
        return cls(tuple(data["select"]), tuple(data["ignore"]), tuple(data["extend"]), severities)

    def admits(self, code: str) -> bool:
        """Return whether findings of this code are reported."""
        if not (self.select or self.ignore or self.severities):
            return True
        selected = max((len(p) for p in (*self.select, *self.extend) if code.startswith(p)), default=-1)
        if not self.select:
            selected = max(selected, 0)
        ignored = max((len(p) for p in self.ignore if code.startswith(p)), default=-1)
        return selected > ignored and self._configured_severity(code) != "off"

    def severity(self, code: str, own: Severity) -> Severity:
        """Return the configured severity of a rule, or its own one."""
        configured = self._configured_severity(code)
        return Severity(configured) if configured else own

    def _configured_severity(self, code: str) -> str | None:
        if not self.severities:
            return None
        matching = [(len(prefix), severity) for prefix, severity in self.severities if code.startswith(prefix)]
        return max(matching)[1] if matching else None


def selection_with(config: Config, given: Selection) -> Selection:
    """Return the rules of a run: those given, then those of the configuration. UserError if one is unknown."""
    ignored = (*config.ignore, *(code for _, file_codes in config.per_file_ignores for code in file_codes))
    try:
        validate_selection(Selection(config.select, ignored, config.extend_select, config.severities))
    except UserError as error:
        raise UserError(f"{config.file}: {error}" if config.file else str(error)) from None
    return validate_selection(
        Selection(
            select=given.select or config.select,
            ignore=given.ignore or config.ignore,
            extend=given.extend or config.extend_select,
            severities=config.severities,
        )
    )


def validate_selection(selection: Selection) -> Selection:
    """Return the selection. UserError if one of its prefixes matches no rule, or if installed rules cannot be used."""
    installed_rules()
    for prefix in (
        *selection.select,
        *selection.ignore,
        *selection.extend,
        *(prefix for prefix, _ in selection.severities),
    ):
        if not any(fault.code.startswith(prefix) for fault in all_faults()):
            raise UserError(f"no rule's code begins with '{prefix}'; see urdfctl rules")
    return selection
