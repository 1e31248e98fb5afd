// Shows what `urdfctl explain --format json` says of a line or a log.

/** Return the parts of the page for a report. tools: element() makes an element, goTo() shows a line of a file. */
export function explained(report, {element, goTo}) {
  const parts = report.messages.map(one => message(one, {element, goTo}));
  const unknown = report.unknown.filter(one => one.level || !report.messages.length);
  for (const one of unknown) {
    const nearest = one.nearest ? ` It resembles “${one.nearest.text}”.` : '';
    parts.push(box(element, 'info', element('p', one.text, {className: 'quoted'}), element('p', `This message is not known.${nearest}`)));
  }
  return parts.length ? parts : [element('p', 'Nothing in this text is a message that means a fault.', {className: 'good'})];
}

function box(element, kind, ...parts) {
  const made = element('div', '', {className: `finding ${kind}`});
  made.append(...parts);
  return made;
}

function message(one, tools) {
  const {element} = tools;
  const kind = {failure: 'error', warning: 'warning'}[one.kind] ?? 'info';
  const head = element('p', '', {className: 'quoted'});
  head.append(element('a', one.text, {href: `../messages/${one.id}/`, target: '_blank'}));
  const causes = element('ol');
  for (const cause of one.causes) causes.append(item(cause, tools));
  const parts = [head, element('p', one.meaning)];
  if (one.causes.length) parts.push(element('p', 'Causes, most likely first:'), causes);
  if (one.fix) parts.push(element('p', `Solution: ${one.fix}`));
  return box(element, kind, ...parts);
}

function item(cause, tools) {
  const {element} = tools;
  const made = element('li', cause.cause);
  for (const rule of cause.rules) made.append(' ', element('a', rule.code, {href: `../rules/${rule.code}/`, target: '_blank', title: rule.name}));
  for (const found of cause.found) {
    made.append(place(found, 'found in your files: ', tools));
    for (const other of found.related) made.append(place(other, 'see: ', tools));
    if (found.fix) made.append(element('p', `fix: ${found.fix}${found.fixable ? ' (safe)' : ''}`));
  }
  return made;
}

function place(at, before, {element, goTo}) {
  const line = element('p', before);
  line.append(element('button', `${at.file}:${at.line}:${at.column}`, {type: 'button', className: 'place', onclick: () => goTo(at.file, at.line)}), ` ${at.message}`);
  return line;
}
