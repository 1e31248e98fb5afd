/** Where urdfctl is: the setting, the selected Python environment, PATH, or an environment of the extension's own. */

import * as path from "node:path";

/** A command line that starts urdfctl, and where it was found. */
export interface Found {
  command: string;
  args: string[];
  from: "setting" | "environment" | "path" | "own";
}

/** What finding depends on. */
export interface Surroundings {
  /** The setting `urdfctl.path`; empty if it is not set. */
  setting: string;
  /** The interpreter of the selected Python environment, if there is one. */
  interpreter?: string;
  /** The environment variable PATH. */
  searchPath: string;
  /** The folder of the Python environment that the extension makes for urdfctl. */
  own: string;
  platform: NodeJS.Platform;
  home: string;
  isFile: (file: string) => boolean;
}

/** Return the commands that may start urdfctl, the preferred one first. A setting is the only one. */
export function findUrdfctl(around: Surroundings): Found[] {
  const setting = around.setting.trim();
  if (setting) {
    return [{ command: withHome(setting, around.home), args: [], from: "setting" }];
  }
  const found: Found[] = [];
  const look = (folder: string, from: Found["from"]): void => {
    const command = executable(folder, around);
    if (command && !found.some((one) => one.command === command)) {
      found.push({ command, args: [], from });
    }
  };
  if (around.interpreter) {
    look(pathsOf(around.platform).dirname(around.interpreter), "environment");
  }
  around.searchPath
    .split(around.platform === "win32" ? ";" : ":")
    .filter(Boolean)
    .forEach((folder) => look(folder, "path"));
  look(pathsOf(around.platform).dirname(pythonOf(around.own, around.platform)), "own");
  return found;
}

/** Return the interpreter of a Python environment in a folder. */
export function pythonOf(environment: string, platform: NodeJS.Platform): string {
  const words = platform === "win32" ? ["Scripts", "python.exe"] : ["bin", "python"];
  return pathsOf(platform).join(environment, ...words);
}

function executable(folder: string, around: Surroundings): string | undefined {
  const names = around.platform === "win32" ? ["urdfctl.exe", "Scripts\\urdfctl.exe"] : ["urdfctl"];
  return names.map((name) => pathsOf(around.platform).join(folder, name)).find(around.isFile);
}

function pathsOf(platform: NodeJS.Platform): path.PlatformPath {
  return platform === "win32" ? path.win32 : path.posix;
}

function withHome(file: string, home: string): string {
  return file === "~" || file.startsWith("~/") ? home + file.slice(1) : file;
}
