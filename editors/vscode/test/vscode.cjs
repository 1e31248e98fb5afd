"use strict";
// Stands for the editor: what the extension registers and shows can be read in `told`, and `answer` takes its questions.

const told = { commands: new Map(), executed: [], questions: [], menus: [], informed: [], settings: {} };
const listeners = { trust: [] };
const nothing = { dispose() {} };

function event(list) {
  return (listener) => (list.push(listener), nothing);
}

class Anything {}

class EventEmitter {
  event = () => nothing;
  fire() {}
  dispose() {}
}

/** An object whose other functions, such as those that register listeners, do nothing. */
function quiet(own) {
  return new Proxy(own, { get: (target, name) => (name in target ? target[name] : () => nothing) });
}

const known = {
  told,
  version: "1.82.0",
  env: { language: "en", appName: "" },
  grantTrust() {
    known.workspace.isTrusted = true;
    return listeners.trust.at(-1)?.(); // of the extension that was activated last
  },
  answer: async () => undefined,
  EventEmitter,
  StatusBarAlignment: { Left: 1, Right: 2 },
  ProgressLocation: { Notification: 15 },
  ViewColumn: { Beside: -2 },
  Uri: { parse: (text) => ({ fsPath: text }) },
  workspace: quiet({
    isTrusted: true,
    workspaceFolders: [],
    textDocuments: [],
    notebookDocuments: [],
    getConfiguration: () => ({ get: (name, usual) => told.settings[name] ?? usual }),
    onDidGrantWorkspaceTrust: event(listeners.trust),
  }),
  window: quiet({
    activeTextEditor: undefined,
    visibleTextEditors: [],
    tabGroups: quiet({ all: [] }),
    createStatusBarItem: () => ({ show() {}, hide() {}, dispose() {} }),
    createOutputChannel: () => ({ append() {}, appendLine() {}, show() {}, dispose() {} }),
    showWarningMessage: async (text, ...ways) => (told.questions.push([text, ...ways]), known.answer(text, ways)),
    showErrorMessage: async (text, ...ways) => (told.questions.push([text, ...ways]), known.answer(text, ways)),
    showInformationMessage: async (text) => void told.informed.push(text),
    showQuickPick: async (choices) => void told.menus.push(choices.map((choice) => choice.label)),
    withProgress: async (_options, task) => task(),
  }),
  commands: quiet({
    registerCommand: (name, run) => (told.commands.set(name, run), nothing),
    executeCommand: async (name, ...words) => void told.executed.push([name, ...words]),
  }),
  languages: quiet({ match: () => 0, getDiagnostics: () => [] }),
  extensions: quiet({ getExtension: () => told.python }),
};

// the library of the language client derives classes from many of the editor's
module.exports = new Proxy(known, {
  get: (target, name) => (name in target ? target[name] : name === "__esModule" ? undefined : Anything),
});
