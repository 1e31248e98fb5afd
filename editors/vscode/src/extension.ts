import { existsSync, statSync } from "node:fs";
import { homedir } from "node:os";
import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions } from "vscode-languageclient/node";

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
  status.command = "urdfctl.showOutput";
  output = vscode.window.createOutputChannel("urdfctl");
  context.subscriptions.push(
    status,
    output,
    vscode.commands.registerCommand("urdfctl.restart", start),
    vscode.commands.registerCommand("urdfctl.showOutput", () => output.show()),
    vscode.commands.registerCommand("urdfctl.explainHere", explainHere),
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
    initializationOptions: wishes((name) => settings.get(name)),
    middleware: {
      executeCommand: async (command, args, next) => {
        const result: unknown = await next(command, args);
        if (command === EXPLAIN && typeof result === "string") {
          await show(result);
        }
        return result;
      },
    },
  };
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

async function show(text: string): Promise<void> {
  const document = await vscode.workspace.openTextDocument({ content: text, language: "markdown" });
  await vscode.window.showTextDocument(document, { preview: true, viewColumn: vscode.ViewColumn.Beside });
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
