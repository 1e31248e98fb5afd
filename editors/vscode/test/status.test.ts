import assert from "node:assert/strict";
import { test } from "node:test";

import { type Robot, type Status, statusOf } from "../src/status";

const ARM: Robot = {
  file: "/ws/arm.xacro",
  robot: "arm",
  arguments: { prefix: "left_" },
  launch: "launch/bringup.launch.py",
  distro: "jazzy",
  distro_from: "package.xml",
  simulator: "gz",
  files: ["/ws/arm.xacro", "/ws/macros.xacro"],
  shown: false,
};

function shown(file: string | undefined, ...robots: Robot[]): Status | undefined {
  return statusOf(file, { robots, problems: [] }, file !== undefined);
}

test("a file that the server does not get has no status", () => {
  assert.equal(statusOf("/ws/notes.md", { robots: [ARM], problems: [] }, false), undefined);
  assert.equal(shown(undefined, ARM), undefined);
});

test("the status of a file that no robot reads says so, and what to do", () => {
  const status = shown("/ws/other.xacro", ARM);
  assert.equal(status?.text, "$(circuit-board) no robot");
  assert.match(status?.tooltip ?? "", /declare it as \[\[robot\]\] in urdfctl\.toml/);
});

test("a problem is shown whatever is open", () => {
  const known = { robots: [ARM], problems: ["urdfctl.toml: unknown key 'distr'"] };
  assert.deepEqual(statusOf(undefined, known, false), { text: "$(warning) urdfctl", tooltip: known.problems[0] });
});

test("the status of a macro file is that of the robot which includes it, with the evidence for the distro", () => {
  const status = shown("/ws/macros.xacro", ARM);
  assert.equal(status?.text, "$(circuit-board) arm · jazzy");
  assert.equal(
    status?.tooltip,
    "arm prefix:=left_\nstarted by launch/bringup.launch.py\ndistro: jazzy (from package.xml)\nsimulator: gz",
  );
});

test("several robots with a file are counted, and so are their distros", () => {
  const other = { ...ARM, robot: "arm2", distro: null, distro_from: null, launch: null, simulator: null, arguments: {} };
  const status = shown("/ws/macros.xacro", ARM, other);
  assert.equal(status?.text, "$(circuit-board) arm +1 · jazzy, unknown distro");
  assert.match(status?.tooltip ?? "", /arm2\ndistro: unknown; set urdfctl\.distro/);
});

test("the variant that was chosen is shown, with the arguments that tell it from the others", () => {
  const both = { side: "front", prefix: "left_" };
  const left = { ...ARM, arguments: both };
  const right = { ...ARM, arguments: { ...both, prefix: "right_" }, distro: "humble", shown: true };
  const status = shown("/ws/macros.xacro", left, right);
  assert.equal(status?.text, "$(circuit-board) arm prefix:=right_ · humble");
  assert.match(status?.tooltip ?? "", /arm side:=front prefix:=right_ \(shown\)/);
});
