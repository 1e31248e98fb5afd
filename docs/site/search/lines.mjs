// Lets the site's search find the page of a message from the line that a runtime printed. The search wants every word
// of what is typed on one page; a printed line has times, numbers and names that no page has. So a long query is
// replaced by the rare words of the message that it resembles most, all of which its page has.

const LONG = 4;
const MOST = 6;
const ENOUGH = 0.6;
const WORDS = /[A-Za-z_][A-Za-z_0-9]{2,}/g;
const STAMPED = /\d[.:]\d|^\s*\[/;

const distinct = (text) => [...new Set(text.toLowerCase().match(WORDS) ?? [])];

/** Return a function from what is typed to what is searched for. messages: the literal words of each known message. */
export function searcher(messages) {
  const counts = new Map();
  for (const words of messages) for (const word of words) counts.set(word, (counts.get(word) ?? 0) + 1);
  const weight = (word) => Math.log(1 + messages.length / counts.get(word));
  const total = (words) => words.reduce((sum, word) => sum + weight(word), 0);
  const says = (word) => weight(word) * word.length;
  return (line) => {
    const here = new Set(distinct(line));
    if (here.size < LONG && !STAMPED.test(line)) return line;
    let best = [];
    let most = 0;
    for (const words of messages) {
      const shared = words.filter((word) => here.has(word));
      if (shared.length < 2) continue;
      const part = total(shared) / total(words);
      const score = part * total(shared);
      if (part >= ENOUGH && score > most) [best, most] = [shared, score];
    }
    if (best.length === 0) return line;
    return best.sort((a, b) => says(b) - says(a)).slice(0, MOST).join(" ");
  };
}

/** Shorten the long queries that the page sends to its search worker. */
function install(address) {
  const send = Worker.prototype.postMessage;
  let searched = null;
  let newest = 0;
  Worker.prototype.postMessage = function (message, ...others) {
    const line = message?.type === 2 ? message.data?.input : undefined;
    const number = ++newest;
    if (typeof line !== "string" || distinct(line).length < 2) return send.call(this, message, ...others);
    searched ??= fetch(address).then((answer) => answer.json()).then(searcher).catch(() => (typed) => typed);
    return searched.then((find) => {
      if (number === newest) send.call(this, { ...message, data: { ...message.data, input: find(line) } }, ...others);
    });
  };
}

if (typeof Worker !== "undefined" && typeof document !== "undefined") install(new URL("messages.json", import.meta.url));
