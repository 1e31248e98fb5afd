import { existsSync, statSync } from "node:fs";
import { homedir } from "node:os";
import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions } from "vscode-languageclient/node";

import { FILE_COMMANDS, fileCommand, type Question, withFile } from "./commands";
import { findUrdfctl, installCommand } from "./find";
import { DOCUMENTS, wishes } from "./settings";
import { type Robot, statusOf } from "./status";

const INSTALL = "Install urdfctl";
const SETTINGS = "Open settings";
const EXPLAIN = "urdfctl.explain";

let client: LanguageClient | undefined;
let robots: Robot[] = [];
let status: vscode.StatusBarItem;
let output: vscode.OutputChannel;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  status = vscode.window.createStatusBarItem("urdfctl", vscode.StatusBarAlignment.Right, 100);
  status.name = "urdfctl";
  status.command = "urdfctl.menu";
  output = vscode.window.createOutputChannel("urdfctl");
  context.subscriptions.push(
    status,
    output,
    vscode.commands.registerCommand("urdfctl.restart", start),
    vscode.commands.registerCommand("urdfctl.showOutput", () => output.show()),
    vscode.commands.registerCommand("urdfctl.explainHere", explainHere),
    vscode.commands.registerCommand("urdfctl.menu", menu),
    vscode.window.onDidChangeActiveTextEditor(showStatus),
    vscode.workspace.onDidChangeConfiguration(configured),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await client?.dispose();
}

async function start(): Promise<void> {
  await client?.dispose();
  client = undefined;
  robots = [];
  showStatus();
  const python = await interpreter();
  const found = findUrdfctl({
    setting: vscode.workspace.getConfiguration("urdfctl").get("path", ""),
    interpreter: python,
    searchPath: process.env.PATH ?? "",
    platform: process.platform,
    home: homedir(),
    isFile: (file) => existsSync(file) && statSync(file).isFile(),
  });
  if (!found) {
    void offerToInstall(python);
    return;
  }
  const run = { command: found.command, args: [...found.args, "server"] };
  const started = new LanguageClient("urdfctl", "urdfctl", run, options());
  started.onNotification("urdfctl/checked", (checked: { whole: boolean; robots: Robot[] }) => {
    if (checked.whole) {
      robots = checked.robots;
      showStatus();
    }
  });
  started.onRequest("urdfctl/pick", pick);
  try {
    await started.start();
    client = started;
  } catch (error) {
    output.appendLine(`${run.command} server does not start: ${String(error)}`);
    void offerToInstall(python, `${run.command} server does not start; see the output.`);
  }
}

function options(): LanguageClientOptions {
  const settings = vscode.workspace.getConfiguration("urdfctl");
  return {
    documentSelector: DOCUMENTS,
    outputChannel: output,
    initializationOptions: { ...wishes((name) => settings.get(name)), pick: true },
    middleware: { executeCommand },
  };
}

/** Run a command of the server; those about a file get the open one. */
async function executeCommand(
  command: string,
  given: unknown[],
  next: (command: string, given: unknown[]) => vscode.ProviderResult<unknown>,
): Promise<unknown> {
  const words = withFile(command, given, vscode.window.activeTextEditor?.document.uri.toString());
  if (!words) {
    void vscode.window.showInformationMessage("Open a file of a robot first.");
    return undefined;
  }
  if (fileCommand(command)?.needsSaving) {
    await vscode.workspace.saveAll(false);
  }
  return next(command, words);
}

/** Answer a question of the server: the number of the choice, or null. */
async function pick(question: Question): Promise<number | null> {
  const chosen = await vscode.window.showQuickPick(question.choices, { title: question.title });
  return chosen === undefined ? null : question.choices.indexOf(chosen);
}

async function menu(): Promise<void> {
  const output = { label: "$(output) Show the output of the server", command: "urdfctl.showOutput" };
  const chosen = await vscode.window.showQuickPick([...FILE_COMMANDS, output], { title: "urdfctl" });
  if (chosen) {
    await vscode.commands.executeCommand(chosen.command);
  }
}

async function configured(event: vscode.ConfigurationChangeEvent): Promise<void> {
  if (event.affectsConfiguration("urdfctl")) {
    await start();
  }
}

/** The interpreter of the selected Python environment, if the Python extension is installed. */
async function interpreter(): Promise<string | undefined> {
  const python = vscode.extensions.getExtension("ms-python.python");
  if (!python) {
    return undefined;
  }
  const api = (python.isActive ? python.exports : await python.activate()) as
    | { environments?: { getActiveEnvironmentPath(): { path: string } } }
    | undefined;
  return api?.environments?.getActiveEnvironmentPath().path;
}

async function offerToInstall(python: string | undefined, why = "urdfctl is not installed."): Promise<void> {
  const chosen = await vscode.window.showWarningMessage(why, INSTALL, SETTINGS);
  if (chosen === SETTINGS) {
    await vscode.commands.executeCommand("workbench.action.openSettings", "urdfctl.path");
  } else if (chosen === INSTALL) {
    const terminal = vscode.window.createTerminal("urdfctl");
    terminal.show();
    terminal.sendText(installCommand(python, process.platform));
    const again = await vscode.window.showInformationMessage("Start the server once urdfctl is installed.", "Start");
    if (again) {
      await start();
    }
  }
}

async function explainHere(): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  const found = editor ? vscode.languages.getDiagnostics(editor.document.uri) : [];
  const here = found.find((each) => each.source === "urdfctl" && each.range.contains(editor!.selection.active));
  if (!here || !client) {
    void vscode.window.showInformationMessage("There is no finding of urdfctl at the cursor.");
    return;
  }
  const code = typeof here.code === "object" ? here.code.value : here.code;
  await vscode.commands.executeCommand(EXPLAIN, String(code));
}

function showStatus(): void {
  const shown = statusOf(vscode.window.activeTextEditor?.document.uri.fsPath, robots);
  if (shown) {
    status.text = shown.text;
    status.tooltip = shown.tooltip;
    status.show();
  } else {
    status.hide();
  }
}
