/** The server's commands that are about the open file. Knows nothing of the editor. */

export interface FileCommand {
  command: string;
  /** How the menu of the status item names it. */
  label: string;
  /** Whether it reads the files from disk, so that they are saved first. */
  needsSaving: boolean;
}

export const FILE_COMMANDS: readonly FileCommand[] = [
  { command: "urdfctl.graph", label: "$(type-hierarchy) Draw the wiring", needsSaving: false },
  { command: "urdfctl.view", label: "$(eye) Show the robot in 3-D", needsSaving: false },
  { command: "urdfctl.smoke", label: "$(beaker) Run a smoke test", needsSaving: true },
  { command: "urdfctl.moveit", label: "$(rocket) Write a package that plans with MoveIt", needsSaving: true },
  { command: "urdfctl.migrate", label: "$(arrow-up) Migrate the package to another distro", needsSaving: true },
  { command: "urdfctl.chooseVariant", label: "$(list-selection) Choose the variant to show", needsSaving: false },
];

/** Return the command with a name, if it is about a file. */
export function fileCommand(name: string): FileCommand | undefined {
  return FILE_COMMANDS.find((each) => each.command === name);
}

/** Return the arguments of a command: from the palette it has none, and is about the open file, if there is one. */
export function withFile(name: string, given: readonly unknown[], open: string | undefined): unknown[] | undefined {
  if (!fileCommand(name) || typeof given[0] === "string") {
    return [...given];
  }
  return open === undefined ? undefined : [open];
}

/** A question of the server, with the choices that it offers. */
export interface Question {
  title: string;
  choices: string[];
}
