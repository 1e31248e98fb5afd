// The page: files, what urdfctl finds in them, and what it makes of them. Python runs in worker.js.
import {explained} from './explained.js';

const MOST_SECONDS = 60;
const EXAMPLE = './example.json';
const byId = id => document.getElementById(id);
const files = new Map();
let shown = '';
let python;

// -- Python ---------------------------------------------------------------------------------------------------------

class Python {
  constructor() {
    this.waiting = new Map();
    this.asked = 0;
    this.start();
  }

  start() {
    this.worker = new Worker(new URL('./worker.js', import.meta.url), {type: 'module'});
    this.ready = new Promise((done, failed) => { this.isReady = done; this.isFailed = failed; });
    this.ready.then(() => say('Ready'), error => say(`Python does not start here: ${error}`));
    this.worker.onmessage = ({data}) => this.take(data);
    this.worker.onerror = event => this.isFailed(event.message);
  }

  take(data) {
    if (data.ready) return this.isReady();
    if (data.failed) return this.isFailed(data.failed);
    const call = this.waiting.get(data.id);
    this.waiting.delete(data.id);
    if (!call) return undefined;
    clearTimeout(call.timer);
    return data.error ? call.failed(new Error(data.error)) : call.done(data.answer);
  }

  async ask(verb, ...given) {
    await this.ready;
    const id = ++this.asked;
    return new Promise((done, failed) => {
      const timer = setTimeout(() => this.end(), MOST_SECONDS * 1000);
      this.waiting.set(id, {done, failed, timer});
      this.worker.postMessage({id, verb, given});
    });
  }

  end() {
    this.worker.terminate();
    const error = new Error(`this took longer than ${MOST_SECONDS} s and was stopped: the robot never ends, or is too large for a page`);
    for (const call of this.waiting.values()) { clearTimeout(call.timer); call.failed(error); }
    this.waiting.clear();
    this.start();
  }
}

async function command(...words) {
  await python.ask('put', Object.fromEntries(files));
  return JSON.parse(await python.ask('run', words));
}

// -- the page -------------------------------------------------------------------------------------------------------

function say(text) { byId('state').textContent = text; }

function element(tag, text = '', properties = {}) {
  const made = Object.assign(document.createElement(tag), properties);
  made.textContent = text;
  return made;
}

function problem(text) { return element('p', text, {className: 'finding error'}); }

async function busy(what, panel, work) {
  const start = performance.now();
  say(`${what}…`);
  try {
    await work();
    say(`Done in ${((performance.now() - start) / 1000).toFixed(1)} s`);
  } catch (error) {
    panel.replaceChildren(problem(error.message));
    say('Stopped');
  }
}

function show(name) {
  keep();
  shown = files.has(name) ? name : [...files.keys()][0] ?? '';
  byId('file').replaceChildren(...[...files.keys()].sort().map(key => element('option', key, {value: key, selected: key === shown})));
  byId('name').value = shown || 'robot.xacro';
  byId('text').value = files.get(shown) ?? '';
  number();
}

function keep() {
  const text = byId('text').value;
  const name = byId('name').value.trim().replace(/^\/+/, '') || 'robot.xacro';
  if (shown && name !== shown) files.delete(shown);
  if (text || shown) files.set(name, text);
  shown = files.has(name) ? name : '';
}

const bad = new Map();

function number() {
  const marked = bad.get(shown) ?? new Set();
  const count = byId('text').value.split('\n').length;
  byId('lines').replaceChildren(...Array.from({length: count}, (_, at) => element('span', `${at + 1}\n`, {className: marked.has(at + 1) ? 'bad' : ''})));
  byId('lines').scrollTop = byId('text').scrollTop;
}

function goTo(file, line) {
  if (!files.has(file)) return;
  widen(false);
  show(file);
  const text = byId('text');
  const before = text.value.split('\n').slice(0, line - 1).join('\n').length + (line > 1 ? 1 : 0);
  const end = text.value.indexOf('\n', before);
  text.focus();
  text.setSelectionRange(before, end < 0 ? text.value.length : end);
  text.scrollTop = Math.max(0, (line - 6) * 19.5);
  number();
}

// -- lint -----------------------------------------------------------------------------------------------------------

async function lint() {
  const panel = byId('findings');
  select('findings');
  keep();
  show(shown);
  await busy('Linting', panel, async () => {
    const answer = await command('lint', '.', '--format', 'json', ...distro());
    if (!answer.out.trim()) return panel.replaceChildren(problem(answer.errors || 'nothing to lint here'));
    const report = JSON.parse(answer.out);
    bad.clear();
    for (const one of report.findings) bad.set(one.file, (bad.get(one.file) ?? new Set()).add(one.line));
    number();
    const parts = report.findings.map(finding);
    if (report.findings.some(one => one.fix?.safe)) parts.unshift(element('button', 'Apply all safe fixes', {type: 'button', id: 'fix', onclick: fix}));
    const errors = report.findings.filter(one => one.severity === 'error').length;
    const others = report.findings.length - errors;
    const verdict = report.findings.length ? `${errors} error${errors === 1 ? '' : 's'}, ${others} other finding${others === 1 ? '' : 's'}` : 'No findings';
    panel.replaceChildren(element('p', verdict, {className: errors ? 'error' : 'good', id: 'verdict'}), ...parts);
  });
}

function finding(one) {
  const box = element('div', '', {className: `finding ${one.severity}`});
  const place = element('button', `${one.file}:${one.line}:${one.column}`, {type: 'button', className: 'place', onclick: () => goTo(one.file, one.line)});
  const head = element('p');
  const code = one.url ? element('a', one.code, {href: `../rules/${one.code}/`, target: '_blank'}) : element('span', one.code);
  head.append(place, ' ', element('b', one.severity), ' ', code);
  box.append(head, element('p', one.message));
  for (const note of one.notes ?? []) box.append(element('p', `note: ${note.message}`));
  if (one.fix) box.append(element('p', `fix: ${one.fix.title}${one.fix.safe ? ' (safe)' : ''}`));
  return box;
}

async function fix() {
  await busy('Fixing', byId('findings'), async () => {
    await command('lint', '.', '--fix', '--quiet', ...distro());
    for (const [name, text] of Object.entries(JSON.parse(await python.ask('texts')))) files.set(name, text);
    byId('text').value = files.get(shown) ?? '';
  });
  await lint();
}

function distro() { return byId('distro').value ? ['--distro', byId('distro').value] : []; }

function isRobotHere() { return [...files.values()].some(text => /<robot\b/.test(text)); }

function robot() {
  const named = [...files.keys()].filter(name => /<robot[^>]*\sname\s*=/.test(files.get(name)));
  return named.includes(shown) ? shown : named[0] ?? shown;
}

// -- the other tabs -------------------------------------------------------------------------------------------------

async function explain() {
  keep();
  const panel = byId('explained');
  await busy('Explaining', panel, async () => {
    const where = isRobotHere() ? ['--in', '.', ...distro()] : [];
    const answer = await command('explain', byId('message').value || byId('message').placeholder, ...where, '--format', 'json');
    if (!answer.out.trim()) return panel.replaceChildren(problem(answer.errors || 'nothing to explain'));
    panel.replaceChildren(...explained(JSON.parse(answer.out), {element, goTo}));
  });
}

async function generate() {
  keep();
  const panel = byId('generated');
  await busy('Generating', panel, async () => {
    const kind = byId('generator').value;
    const words = [kind, robot(), '--type', byId('type').value, '--simulator', byId('simulator').value, '--distro', byId('distro').value || 'jazzy'];
    const answer = await command(...words, ...(kind === 'gen-all' ? ['-o', '/home/made'] : []));
    const written = kind === 'gen-all' ? JSON.parse(await python.ask('made')) : {[kind]: answer.out};
    const texts = Object.entries(written).filter(([, text]) => text).flatMap(([name, text]) => [element('h2', name), element('pre', text)]);
    panel.replaceChildren(...texts, ...(answer.errors ? [element('pre', answer.errors)] : []));
  });
}

async function draw() {
  keep();
  const panel = byId('graph');
  widen(true);
  await busy('Drawing', panel, async () => {
    const answer = await command('graph', '.', '--format', 'html', ...distro());
    if (!answer.out.startsWith('<')) return panel.replaceChildren(problem(answer.errors || 'nothing to draw'));
    panel.replaceChildren(framed('what is wired to what', answer.out));
  });
}

/** Return a page of urdfctl, which can run its own scripts and nothing else. */
function framed(title, page) {
  const frame = element('iframe', '', {title});
  frame.setAttribute('sandbox', 'allow-scripts');
  frame.srcdoc = page;
  return frame;
}

async function view() {
  keep();
  const panel = byId('view');
  await busy('Drawing', panel, async () => {
    const answer = await command('view', robot(), '-o', '/home/made/robot.html');
    const page = JSON.parse(await python.ask('made'))['robot.html'];
    if (!page) return panel.replaceChildren(problem(answer.errors || 'nothing to show'));
    panel.replaceChildren(framed('the robot in 3-D', page));
  });
}

const DONE_WHEN_SHOWN = {graph: draw, view};

function select(name) {
  for (const tab of document.querySelectorAll('[role=tab]')) {
    const chosen = tab.getAttribute('aria-controls') === name;
    tab.setAttribute('aria-selected', chosen);
    tab.tabIndex = chosen ? 0 : -1;
    byId(tab.getAttribute('aria-controls')).hidden = !chosen;
  }
}

function widen(wide) {
  document.querySelector('main').classList.toggle('wide', wide);
  byId('wide').setAttribute('aria-pressed', wide);
}

// -- files in, and an address that has them -------------------------------------------------------------------------

async function take(entries) {
  const texts = {};
  for (const [path, file] of entries) {
    if (/\.zip$/i.test(path)) Object.assign(texts, JSON.parse(await python.ask('unpacked', await file.arrayBuffer())));
    else if (file.size < 2e6) texts[path] = await file.text();
  }
  const wanted = Object.entries(texts).filter(([path, text]) => !/(^|\/)\.git\//.test(path) && !text.includes('\0'));
  if (!wanted.length) return say('No text files in it');
  replace(Object.fromEntries(wanted));
  return lint();
}

function replace(texts) {
  files.clear();
  bad.clear();
  shown = '';
  byId('text').value = '';
  for (const [path, text] of Object.entries(texts)) files.set(path, text);
  show([...files.keys()].find(name => /\.(urdf|xacro)$/.test(name)));
}

async function walked(entry, found) {
  if (entry.isFile) found.push([entry.fullPath.slice(1), await new Promise((done, failed) => entry.file(done, failed))]);
  else if (entry.name !== '.git') {
    const reader = entry.createReader();
    for (;;) {
      const some = await new Promise((done, failed) => reader.readEntries(done, failed));
      if (!some.length) break;
      for (const one of some) await walked(one, found);
    }
  }
}

async function dropped(event) {
  event.preventDefault();
  document.body.classList.remove('dropping');
  const found = [];
  const entries = [...event.dataTransfer.items].map(item => item.webkitGetAsEntry()).filter(Boolean);
  for (const entry of entries) await walked(entry, found);
  await busy('Reading', byId('findings'), () => take(found));
}

async function through(stream, bytes) {
  const piped = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

async function share() {
  keep();
  const packed = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(JSON.stringify(Object.fromEntries(files))));
  const text = btoa(Array.from(packed, byte => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  location.hash = text;
  await navigator.clipboard?.writeText(location.href).catch(() => undefined);
  say(`The address has these files now (${Math.ceil(text.length / 1000)} kB); what comes after # is sent to nobody`);
}

async function shared() {
  const text = location.hash.slice(1).replaceAll('-', '+').replaceAll('_', '/');
  const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(new DecompressionStream('deflate-raw'), bytes)));
}

// -- start ----------------------------------------------------------------------------------------------------------

async function start() {
  python = new Python();
  for (const name of DISTROS) byId('distro').append(element('option', name, {value: name}));
  byId('lint').onclick = lint;
  byId('explain').onclick = explain;
  byId('generate').onclick = generate;
  byId('share').onclick = share;
  byId('wide').onclick = () => widen(!document.querySelector('main').classList.contains('wide'));
  byId('example').onclick = async () => { replace(await (await fetch(EXAMPLE)).json()); await lint(); };
  byId('file').onchange = event => show(event.target.value);
  byId('text').oninput = number;
  byId('text').onscroll = number;
  byId('files').onchange = event => take([...event.target.files].map(file => [file.name, file]));
  byId('folder').onchange = event => take([...event.target.files].map(file => [file.webkitRelativePath, file]));
  const tabs = [...document.querySelectorAll('[role=tab]')];
  for (const tab of tabs) {
    tab.onclick = () => { select(tab.getAttribute('aria-controls')); DONE_WHEN_SHOWN[tab.getAttribute('aria-controls')]?.(); };
    tab.onkeydown = event => {
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (step) tabs.at((tabs.indexOf(tab) + step) % tabs.length).focus();
    };
  }
  document.body.ondragover = event => { event.preventDefault(); document.body.classList.add('dropping'); };
  document.body.ondragleave = () => document.body.classList.remove('dropping');
  document.body.ondrop = dropped;
  if (location.hash.length > 1) {
    try { replace(await shared()); await lint(); } catch { say('The address has no files that can be read'); }
  }
}

const DISTROS = JSON.parse(document.documentElement.dataset.distros || '[]');
start();
