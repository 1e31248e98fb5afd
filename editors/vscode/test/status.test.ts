import assert from "node:assert/strict";
import { test } from "node:test";

import { type Robot, statusOf } from "../src/status";

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

test("a file that no robot reads has no status", () => {
  assert.equal(statusOf("/ws/other.xacro", [ARM]), undefined);
  assert.equal(statusOf(undefined, [ARM]), undefined);
});

test("the status of a macro file is that of the robot which includes it, with the evidence for the distro", () => {
  const status = statusOf("/ws/macros.xacro", [ARM]);
  assert.equal(status?.text, "$(circuit-board) arm · jazzy");
  assert.equal(
    status?.tooltip,
    "arm prefix:=left_\nstarted by launch/bringup.launch.py\ndistro: jazzy (from package.xml)\nsimulator: gz",
  );
});

test("several robots with a file are counted, and so are their distros", () => {
  const other = { ...ARM, robot: "arm2", distro: null, distro_from: null, launch: null, simulator: null, arguments: {} };
  const status = statusOf("/ws/macros.xacro", [ARM, other]);
  assert.equal(status?.text, "$(circuit-board) arm +1 · jazzy, unknown distro");
  assert.match(status?.tooltip ?? "", /arm2\ndistro: unknown$/);
});

test("the variant that was chosen is shown, with the arguments that tell it from the others", () => {
  const both = { side: "front", prefix: "left_" };
  const left = { ...ARM, arguments: both };
  const right = { ...ARM, arguments: { ...both, prefix: "right_" }, distro: "humble", shown: true };
  const status = statusOf("/ws/macros.xacro", [left, right]);
  assert.equal(status?.text, "$(circuit-board) arm prefix:=right_ · humble");
  assert.match(status?.tooltip ?? "", /arm side:=front prefix:=right_ \(shown\)/);
});
