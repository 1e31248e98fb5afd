import { existsSync, mkdirSync, realpathSync, statSync } from "node:fs";
import { homedir } from "node:os";
import * as path from "node:path";
import * as vscode from "vscode";
import { type LanguageClient, type LanguageClientOptions, State } from "vscode-languageclient/node";

import { connect } from "./client";
import { FILE_COMMANDS, fileCommand, type Question, withFile } from "./commands";
import { findUrdfctl } from "./find";
import { install } from "./install";
import { showDocument } from "./pages";
import { DOCUMENTS, wishes } from "./settings";
import { type Known, statusOf } from "./status";

const INSTALL = "Install urdfctl";
const TRUST = "Manage workspace trust";
const SETTINGS = "Open settings";
const OUTPUT = "Show output";
const EXPLAIN = "urdfctl.explain";

let client: LanguageClient | undefined;
let known: Known | undefined;
let status: vscode.StatusBarItem;
let output: vscode.OutputChannel;
let environment: string;
/** The extension's own folder: where the programs start that it runs. */
let own: string;
let started: Promise<void> = Promise.resolve();

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  status = vscode.window.createStatusBarItem("urdfctl", vscode.StatusBarAlignment.Right, 100);
  status.name = "urdfctl";
  status.command = "urdfctl.menu";
  output = vscode.window.createOutputChannel("urdfctl");
  own = context.globalStorageUri.fsPath;
  environment = path.join(own, "environment");
  context.subscriptions.push(
    status,
    output,
    vscode.commands.registerCommand("urdfctl.restart", restart),
    vscode.commands.registerCommand("urdfctl.install", installOwn),
    vscode.commands.registerCommand("urdfctl.showOutput", () => output.show()),
    vscode.commands.registerCommand("urdfctl.explainHere", explainHere),
    vscode.commands.registerCommand("urdfctl.live", openRecording),
    vscode.commands.registerCommand("urdfctl.menu", menu),
    vscode.window.onDidChangeActiveTextEditor(showStatus),
    vscode.workspace.onDidGrantWorkspaceTrust(restart),
    vscode.workspace.onDidChangeConfiguration((event) => event.affectsConfiguration("urdfctl") && restart()),
  );
  const environments = await pythonEnvironments();
  const changed = environments?.onDidChangeActiveEnvironmentPath(() => void restart());
  context.subscriptions.push(...(changed ? [changed] : []));
  await restart();
}

export async function deactivate(): Promise<void> {
  await stop();
}

/** Stop the server. One that crashed cannot be stopped any more, and says so. */
async function stop(): Promise<void> {
  const stopped = client;
  client = undefined;
  try {
    await stopped?.dispose();
  } catch (error) {
    output.appendLine(String(error));
  }
}

/** Start the server again, after what is started already. */
function restart(): Promise<void> {
  started = started.then(start, start);
  return started;
}

async function start(): Promise<void> {
  await stop();
  learn(undefined);
  const setting = vscode.workspace.getConfiguration("urdfctl").get("path", "");
  const found = findUrdfctl({
    setting,
    interpreter: (await pythonEnvironments())?.getActiveEnvironmentPath().path,
    searchPath: process.env.PATH ?? "",
    own: environment,
    platform: process.platform,
    home: homedir(),
    isFile: (file) => existsSync(file) && statSync(file).isFile(),
    untrusted: vscode.workspace.isTrusted ? [] : workspaceFolders(),
    realPath: (file) => (existsSync(file) ? realpathSync(file) : file),
  });
  mkdirSync(own, { recursive: true });
  const failures: string[] = [];
  for (const one of found) {
    const connected = await connect(one, own, options(), listen);
    if (typeof connected !== "string") {
      client = connected;
      return;
    }
    failures.push(`'${one.command}' cannot serve the editor: ${connected}`);
    output.appendLine(failures.at(-1)!);
  }
  const why = failures[0] ?? "urdfctl was not found in the selected Python environment or on PATH";
  learn({ robots: [], problems: [why] });
  void offerHelp(why, setting ? [SETTINGS, OUTPUT] : [vscode.workspace.isTrusted ? INSTALL : TRUST, SETTINGS, OUTPUT]);
}

function workspaceFolders(): string[] {
  const folders = vscode.workspace.workspaceFolders ?? [];
  return folders.filter((folder) => folder.uri.scheme === "file").map((folder) => folder.uri.fsPath);
}

function listen(client: LanguageClient): void {
  client.onNotification("urdfctl/checked", (checked: Partial<Known> & { whole: boolean }) => {
    if (checked.whole) {
      learn({ robots: checked.robots ?? [], problems: checked.problems ?? [] });
    }
  });
  client.onRequest("urdfctl/pick", pick);
  client.onDidChangeState(({ oldState, newState }) => {
    if (newState === State.Running) {
      learn(undefined);
    } else if (oldState === State.Running) {
      learn({ robots: [], problems: ["the server has stopped; if it does not start again, restart it from the menu"] });
    }
  });
}

function options(): LanguageClientOptions {
  const settings = vscode.workspace.getConfiguration("urdfctl");
  return {
    documentSelector: DOCUMENTS,
    outputChannel: output,
    initializationOptions: { ...wishes((name) => settings.get(name)), pick: true },
    middleware: { executeCommand, window: { showDocument } },
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

const INSTALLING = { label: `$(cloud-download) ${INSTALL}`, command: "urdfctl.install" };
const TRUSTING = { label: `$(shield) ${TRUST}`, command: "workbench.trust.manage" };

async function menu(): Promise<void> {
  const others = [
    { label: "$(pulse) Open a recording of the running system", command: "urdfctl.live" },
    { label: "$(refresh) Restart the server", command: "urdfctl.restart" },
    { label: "$(output) Show the output of the server", command: "urdfctl.showOutput" },
  ];
  const about = client ? FILE_COMMANDS : [vscode.workspace.isTrusted ? INSTALLING : TRUSTING];
  const chosen = await vscode.window.showQuickPick([...about, ...others], { title: "urdfctl" });
  if (chosen) {
    await vscode.commands.executeCommand(chosen.command);
  }
}

interface PythonEnvironments {
  getActiveEnvironmentPath(): { path: string };
  onDidChangeActiveEnvironmentPath: vscode.Event<unknown>;
}

/** What the Python extension knows about environments, if it is installed. */
async function pythonEnvironments(): Promise<PythonEnvironments | undefined> {
  const python = vscode.extensions.getExtension("ms-python.python");
  const api = (python?.isActive ? python.exports : await python?.activate()) as
    | { environments?: PythonEnvironments }
    | undefined;
  return api?.environments;
}

async function offerHelp(why: string, ways: string[]): Promise<void> {
  const chosen = await vscode.window.showWarningMessage(`${why}.`, ...ways);
  if (chosen === SETTINGS) {
    await vscode.commands.executeCommand("workbench.action.openSettings", "urdfctl.path");
  } else if (chosen === INSTALL) {
    await installOwn();
  } else if (chosen === TRUST) {
    await vscode.commands.executeCommand(TRUSTING.command);
  } else if (chosen === OUTPUT) {
    output.show();
  }
}

/** Install urdfctl, or its newest version, into the extension's own environment, and start it. */
async function installOwn(): Promise<void> {
  if (!vscode.workspace.isTrusted) {
    void vscode.window.showInformationMessage("urdfctl is installed only when you trust this workspace.");
    return;
  }
  const interpreter = (await pythonEnvironments())?.getActiveEnvironmentPath().path;
  const failure = await vscode.window.withProgress(
    { location: vscode.ProgressLocation.Notification, title: "Installing urdfctl into an environment of its own" },
    () => install({ interpreter, environment, platform: process.platform, log: (text) => output.append(text) }),
  );
  if (failure === undefined) {
    await restart();
    return;
  }
  const chosen = await vscode.window.showErrorMessage(`urdfctl was not installed: ${failure}.`, OUTPUT);
  if (chosen === OUTPUT) {
    output.show();
  }
}

/** Draw what is really wired, as a recording of `urdfctl doctor --snapshot` shows it, beside the open file's robot. */
async function openRecording(): Promise<void> {
  const open = vscode.window.activeTextEditor?.document.uri;
  if (!open || !client) {
    void vscode.window.showInformationMessage("Open a file of the robot first.");
    return;
  }
  const filters = { "Recordings of urdfctl doctor": ["json"] };
  const chosen = await vscode.window.showOpenDialog({ title: "urdfctl: recording", filters, canSelectMany: false });
  if (chosen?.[0]) {
    await vscode.commands.executeCommand("urdfctl.graph", open.toString(), chosen[0].toString());
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

/** Take what the server said; undefined until it says something. */
function learn(news: Known | undefined): void {
  known = news;
  showStatus();
}

function showStatus(): void {
  const document = vscode.window.activeTextEditor?.document;
  const isOurs = document !== undefined && vscode.languages.match(DOCUMENTS, document) > 0;
  const shown = known && statusOf(document?.uri.fsPath, known, isOurs);
  if (shown) {
    status.text = shown.text;
    status.tooltip = shown.tooltip;
    status.show();
  } else {
    status.hide();
  }
}
