/** The client of one server: started by a command that was found, and started again if the server crashes. */

import { CloseAction, type ErrorHandler, LanguageClient, type LanguageClientOptions } from "vscode-languageclient/node";

import type { Found } from "./find";
import { begin, type Running } from "./processes";

/**
 * Start a server, and return its client once it answers; otherwise why it does not.
 *
 * folder: where it starts; it learns from the editor what it works on.
 * prepare: registers what the server may ask, before it is started.
 */
export async function connect(
  found: Found,
  folder: string,
  options: LanguageClientOptions,
  prepare: (client: LanguageClient) => void,
): Promise<LanguageClient | string> {
  const start = (): Promise<Running> => begin(found.command, [...found.args, "server"], { folder });
  let first: Running;
  try {
    first = await start();
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
  let isFirst = true;
  const launch = async (): Promise<Running["process"]> => {
    const running = isFirst ? first : await start();
    isFirst = false;
    return running.process;
  };
  const client = new PatientClient("urdfctl", "urdfctl", launch, options);
  prepare(client);
  const answered = client.start().then(() => client.isRunning(), () => false);
  client.hasAnswered = await Promise.race([answered, first.ended.then(() => false)]);
  if (client.hasAnswered) {
    return client;
  }
  first.process.kill();
  return (await first.ended).reason;
}

/** Starts a crashed server again, but not one that never answered: its caller says so once, and why. */
class PatientClient extends LanguageClient {
  hasAnswered = false;

  constructor(id: string, name: string, launch: () => Promise<Running["process"]>, options: LanguageClientOptions) {
    let usual: ErrorHandler | undefined;
    const handler = (): ErrorHandler => (usual ??= this.createDefaultErrorHandler());
    super(id, name, launch, {
      ...options,
      initializationFailedHandler: () => false,
      errorHandler: {
        error: (error, message, count) => handler().error(error, message, count),
        closed: () =>
          this.hasAnswered ? handler().closed() : { action: CloseAction.DoNotRestart, handled: true },
      },
    });
  }

  override error(message: string, data?: unknown, shown?: boolean | "force"): void {
    super.error(message, data, this.hasAnswered ? shown : false);
  }
}
