import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { chmodSync, existsSync, mkdirSync, mkdtempSync, readFileSync, realpathSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import * as path from "node:path";
import { test } from "node:test";
import * as vscode from "vscode";

import manifest from "../package.json";
import { activate } from "../src/extension";
import { install } from "../src/install";
import { begin } from "../src/processes";

const POSIX = { skip: process.platform === "win32" ? "the programs of this test are shell scripts" : false };

/** What stands for the editor, in vscode.cjs. */
const editor = vscode as unknown as {
  told: {
    commands: Map<string, () => Promise<void>>;
    executed: string[][];
    questions: string[][];
    menus: string[][];
    informed: string[];
    python?: unknown;
  };
  workspace: { isTrusted: boolean; workspaceFolders: unknown[] };
  grantTrust: () => Promise<unknown>;
};

function folder(): string {
  return realpathSync(mkdtempSync(path.join(tmpdir(), "urdfctl-")));
}

function program(file: string, ...lines: string[]): void {
  mkdirSync(path.dirname(file), { recursive: true });
  writeFileSync(file, ["#!/bin/sh", ...lines, ""].join("\n"));
  chmodSync(file, 0o755);
}

/** The extension, activated in an untrusted workspace whose environment is selected in the Python extension. */
async function restricted(): Promise<{ workspace: string; own: string; run: () => string }> {
  const [workspace, own] = [folder(), folder()];
  const told = path.join(own, "was_run");
  for (const name of ["python", "urdfctl"]) {
    program(path.join(workspace, ".venv/bin", name), `echo ${name} >> "${told}"`, "exit 1");
  }
  Object.assign(editor.told, { executed: [], questions: [], menus: [], informed: [] });
  const interpreter = { path: path.join(workspace, ".venv/bin/python") };
  const environments = { getActiveEnvironmentPath: () => interpreter, onDidChangeActiveEnvironmentPath: () => ({}) };
  editor.told.python = { isActive: true, exports: { environments } };
  editor.workspace.isTrusted = false;
  editor.workspace.workspaceFolders = [{ uri: { scheme: "file", fsPath: workspace } }];
  process.env.PATH = path.join(workspace, ".venv/bin");
  await activate({ globalStorageUri: { fsPath: own }, subscriptions: [] } as unknown as vscode.ExtensionContext);
  return { workspace, own, run: () => (existsSync(told) ? readFileSync(told, "utf-8") : "") };
}

const SEARCH_PATH = process.env.PATH;
test.afterEach(() => (process.env.PATH = SEARCH_PATH));

test("before the workspace is trusted, nothing of it runs and nothing is installed", POSIX, async () => {
  const { own, run } = await restricted();
  await editor.told.commands.get("urdfctl.install")!();
  await editor.told.commands.get("urdfctl.menu")!();
  assert.equal(run(), "");
  assert.deepEqual(editor.told.questions.flat().filter((word) => word.includes("Install urdfctl")), []);
  assert.deepEqual(editor.told.menus.flat().filter((word) => word.includes("Install urdfctl")), []);
  assert.match(editor.told.informed.join(), /installed only when you trust this workspace/);
  assert.ok(!existsSync(path.join(own, "environment")));
});

test("once it is trusted, the selected environment is used, and installing is offered", POSIX, async () => {
  const { run } = await restricted();
  await editor.grantTrust();
  assert.equal(run(), "urdfctl\n");
  assert.ok(editor.told.questions.at(-1)!.includes("Install urdfctl"));
  await editor.told.commands.get("urdfctl.menu")!();
  assert.ok(editor.told.menus.flat().some((word) => word.includes("Install urdfctl")));
});

test("the command that installs is not in the palette before the workspace is trusted", () => {
  const installing = manifest.contributes.commands.find((each) => each.command === "urdfctl.install");
  assert.equal((installing as { enablement?: string }).enablement, "isWorkspaceTrusted");
  assert.equal(manifest.capabilities.untrustedWorkspaces.supported, "limited");
  assert.deepEqual(manifest.capabilities.untrustedWorkspaces.restrictedConfigurations, ["urdfctl.path"]);
});

test("a program starts in the folder that it is given", async () => {
  const at = folder();
  const running = await begin(process.execPath, ["-e", "console.error(process.cwd())"], { folder: at });
  assert.equal((await running.ended).reason, at);
});

const PYTHON = ["python3", "python"].find((name) => spawnSync(name, ["-c", "import ensurepip"]).status === 0);

test("installing runs no module of the folder that the editor was started in", { skip: !PYTHON }, async () => {
  const [hostile, own] = [folder(), folder()];
  const told = path.join(own, "was_run");
  const spy = `with open(${JSON.stringify(told)}, "a") as file:\n    file.write(__file__ + "\\n")\n`;
  for (const name of ["venv", "pip", "ensurepip", "sitecustomize", "usercustomize", "encodings", "re"]) {
    mkdirSync(path.join(hostile, name));
    writeFileSync(path.join(hostile, name, "__init__.py"), spy);
    writeFileSync(path.join(hostile, name, "__main__.py"), spy);
  }
  const before = process.cwd();
  Object.assign(process.env, { PYTHONPATH: `.${path.delimiter}${hostile}`, PIP_NO_INDEX: "1", PIP_FIND_LINKS: "." });
  process.chdir(hostile);
  try {
    const environment = path.join(own, "environment");
    const failure = await install({ interpreter: PYTHON, environment, platform: process.platform, log: () => undefined });
    assert.match(failure ?? "", /No matching distribution found for urdfctl/);
  } finally {
    process.chdir(before);
    delete process.env.PYTHONPATH;
    delete process.env.PIP_NO_INDEX;
    delete process.env.PIP_FIND_LINKS;
  }
  assert.ok(!existsSync(told), existsSync(told) ? readFileSync(told, "utf-8") : "");
});
