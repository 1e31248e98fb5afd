// Python in a worker: the page stays usable, and can end it when a robot takes too long.
import {loadPyodide} from './pyodide/pyodide.mjs';

const ready = (async () => {
  const python = await loadPyodide({indexURL: new URL('./pyodide/', import.meta.url).href});
  const fetched = async name => (await fetch(new URL(name, import.meta.url))).arrayBuffer();
  const [packages, driver] = await Promise.all([fetched('packages.zip'), fetched('driver.py')]);
  const library = python.runPython('import sysconfig; sysconfig.get_path("purelib")');
  python.unpackArchive(new Uint8Array(packages), 'zip', {extractDir: library});
  python.FS.writeFile('/home/driver.py', new Uint8Array(driver));
  python.runPython('import sys; sys.path.insert(0, "/home")');
  return python.pyimport('driver');
})();

ready.then(() => postMessage({ready: true}), error => postMessage({failed: String(error)}));

onmessage = async ({data}) => {
  try {
    const driver = await ready;
    const given = data.given.map(value => value instanceof ArrayBuffer ? new Uint8Array(value) : value);
    postMessage({id: data.id, answer: driver[data.verb](...given) ?? null});
  } catch (error) {
    postMessage({id: data.id, error: String(error.message || error).trim().split('\n').pop()});
  }
};
