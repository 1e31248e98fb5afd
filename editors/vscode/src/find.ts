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
  /** The folders of a workspace that is not trusted: nothing in them is run. */
  untrusted: readonly string[];
  /** Where the links of a path lead to. */
  realPath: (file: string) => string;
}

/**
 * Return the commands that may start urdfctl, the preferred one first. A setting is the only one.
 *
 * Folders that are named relative to the current one are left out: that is wherever the editor was started.
 */
export function findUrdfctl(around: Surroundings): Found[] {
  const setting = around.setting.trim();
  if (setting) {
    return [{ command: withHome(setting, around.home), args: [], from: "setting" }];
  }
  const found: Found[] = [];
  const look = (folder: string, from: Found["from"]): void => {
    const command = pathsOf(around.platform).isAbsolute(folder) ? executable(folder, around) : undefined;
    if (command && isTrusted(command, around) && !found.some((one) => one.command === command)) {
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

function isTrusted(command: string, { untrusted, realPath, platform }: Surroundings): boolean {
  const { relative, isAbsolute } = pathsOf(platform);
  const isIn = (file: string, folder: string): boolean => {
    const way = relative(folder, file);
    return !isAbsolute(way) && way.split(/[\\/]/)[0] !== "..";
  };
  return !untrusted.some((folder) => isIn(command, folder) || isIn(realPath(command), realPath(folder)));
}

function pathsOf(platform: NodeJS.Platform): path.PlatformPath {
  return platform === "win32" ? path.win32 : path.posix;
}

function withHome(file: string, home: string): string {
  return file === "~" || file.startsWith("~/") ? home + file.slice(1) : file;
}
