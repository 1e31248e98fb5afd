import assert from "node:assert/strict";
import { test } from "node:test";

import { findUrdfctl, installCommand, type Surroundings } from "../src/find";

function around(changes: Partial<Surroundings>, files: string[] = []): Surroundings {
  const isFile = (file: string): boolean => files.includes(file);
  return { setting: "", searchPath: "/usr/bin:/opt/bin", platform: "linux", home: "/home/ada", isFile, ...changes };
}

test("the setting comes first", () => {
  const found = findUrdfctl(around({ setting: "~/venv/bin/urdfctl", interpreter: "/v/bin/python" }, ["/v/bin/urdfctl"]));
  assert.deepEqual(found, { command: "/home/ada/venv/bin/urdfctl", args: [], from: "setting" });
});

test("the selected Python environment comes before PATH", () => {
  const found = findUrdfctl(around({ interpreter: "/v/bin/python" }, ["/v/bin/urdfctl", "/usr/bin/urdfctl"]));
  assert.deepEqual(found, { command: "/v/bin/urdfctl", args: [], from: "environment" });
});

test("an environment without urdfctl leaves it to PATH, in its order", () => {
  const found = findUrdfctl(around({ interpreter: "/v/bin/python" }, ["/opt/bin/urdfctl"]));
  assert.equal(found?.command, "/opt/bin/urdfctl");
  assert.equal(found?.from, "path");
});

test("nothing is found where nothing is installed", () => {
  assert.equal(findUrdfctl(around({ interpreter: "/v/bin/python" })), undefined);
});

test("on Windows it is beside the interpreter or in Scripts", () => {
  const windows = { platform: "win32" as const, searchPath: "C:\\bin;D:\\bin", interpreter: "C:\\py\\python.exe" };
  assert.equal(
    findUrdfctl(around(windows, ["C:\\py\\Scripts\\urdfctl.exe"]))?.command,
    "C:\\py\\Scripts\\urdfctl.exe",
  );
  assert.equal(findUrdfctl(around(windows, ["D:\\bin\\urdfctl.exe"]))?.from, "path");
});

test("it is installed into the selected environment, whatever its path contains", () => {
  assert.equal(installCommand("/my env/it's/python", "linux"), `'/my env/it'\\''s/python' -m pip install "urdfctl[server]"`);
  assert.equal(installCommand(undefined, "win32"), `& "py" -m pip install "urdfctl[server]"`);
});
