"""Migrate packages to another ROS distro.

A migration is made in a copy of the packages (`Scratch`), judged there, and written only as a whole.

- A `Step` (`step.py`) is a name, a part for `--only`, rows for `--list`, and a function `propose(packages)` that yields
  `Proposal`s. A proposal is made as a whole or not at all: edits of existing files as `Edit(SourceSpan, text)`, new
  files, files to delete, and the entries of the report. A proposal must not be made again once it is applied, because
  a step is called until it proposes no more changes. That also makes a migration idempotent.
- `MigratedPackages` (`packages.py`) is what a step sees: `files(".xacro")` and `read(path)` for texts, `loaded(distro)`
  for robots, controllers and launch files with their places, `options`, `source`, `is_ros1`, `simulator`,
  `crosses("jazzy")`. All paths are of the copy; the report shows the real ones. A created launch file is linted, too.
- Edits that keep comments and formatting are in `edits/`: `yaml_edits.py` (entries of maps), `xml_edits.py`
  (elements), `markup.py` (attributes and texts), `python_edits.py` (calls, lists, imports), `tokens.py` (values
  wherever they are). `shared/controller_files.py` finds the sections of controller files with their types, whether a
  launch file loads them or not.
- Entries: `ReportEntry(EntryKind.DONE | DECIDED | FOR_YOU, message, place, authority=, option=)`. What a person must
  decide is `todo.for_you(place, text)`: a TODO comment in the line above, and its entry. UC708 finds the TODOs.
- The engine (`engine.py`) applies the steps in the order of `steps.py` (`trial/attempt.py`) and lints the result for
  the target; only what a change may concern is read and linted again (`trial/memory.py`). `trial/trials.py` searches
  which steps must be left out: a step is left out of a file if otherwise a finding that it claims (`Proposal.fixes`)
  stays there, an error or warning of a new kind appears, or the kinematics of a robot change without being listed in
  `Proposal.moves`. A warning is accepted if without the step there would be an error in its file.

Steps are in `ros1/`, `classic/` and `distro/`; each of these lists its own in `STEPS`, or in `ROBOT_STEPS` and
`PACKAGE_STEPS`: those of robots come first. A step has examples, as a rule has: `before` and `after`. The tests apply
it alone to each of the packages before, and compare.
"""
