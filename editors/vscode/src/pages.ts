/** Pages of the server, shown beside the files: also where no browser can open a file of the server's machine. */

import * as path from "node:path";
import * as vscode from "vscode";
import type { ShowDocumentParams, ShowDocumentRequest, ShowDocumentResult } from "vscode-languageclient";

import { inPanel } from "./policy";

const panels = new Map<string, vscode.WebviewPanel>();

/** Show what the server asks for: its pages in a panel, other files as usual. */
export async function showDocument(
  asked: ShowDocumentParams,
  next: ShowDocumentRequest.HandlerSignature,
): Promise<ShowDocumentResult> {
  const uri = vscode.Uri.parse(asked.uri);
  if (asked.external && uri.scheme === "file") {
    await showPage(uri);
    return { success: true };
  }
  const shown = await next(asked, new vscode.CancellationTokenSource().token);
  return "success" in shown ? shown : { success: false };
}

/** Show an HTML file in a panel; in the one that shows the page of this name already, if there is one. */
async function showPage(uri: vscode.Uri): Promise<void> {
  const html = Buffer.from(await vscode.workspace.fs.readFile(uri)).toString("utf-8");
  const name = path.posix.basename(uri.path);
  const panel = panels.get(name) ?? newPanel(name);
  panel.title = /<title>([^<]+)<\/title>/.exec(html)?.[1] ?? name;
  const shown = inPanel(html);
  panel.webview.options = { enableScripts: shown.scripts, enableForms: false, localResourceRoots: [] };
  panel.webview.html = shown.html;
  panel.reveal(undefined, true);
}

function newPanel(name: string): vscode.WebviewPanel {
  const shown = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
  const panel = vscode.window.createWebviewPanel("urdfctl.page", name, shown, {
    enableFindWidget: true,
    retainContextWhenHidden: true,
  });
  panels.set(name, panel);
  panel.onDidDispose(() => panels.delete(name));
  return panel;
}
