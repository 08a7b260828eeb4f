// What shows live that a task is done: labels and values, and the tree of parts as a tree.
import { element } from "./elements.js";

const IS_TREE = /^\w+ \([\w (),]+\)$/;

/** Reads "a (b, c (d))" into {name, children}. */
function readTree(text) {
  const top = { children: [] };
  const path = [top];
  for (const [token] of text.matchAll(/\w+|[()]/g)) {
    if (token === "(") path.push(path.at(-1).children.at(-1));
    else if (token === ")") path.pop();
    else path.at(-1).children.push({ name: token, children: [] });
  }
  return top.children[0];
}

/** Joins leaves that only differ by the number at their end: "wheel left 1 … 7". */
function joined(children) {
  const rows = [];
  for (const child of children) {
    const [, stem, number] = /^(.*)_(\d+)$/.exec(child.name) ?? [];
    const last = rows.at(-1);
    if (stem && last?.stem === stem) last.to = number;
    else rows.push({ ...child, stem, from: number });
  }
  return rows.map(({ name, stem, from, to, children }) => ({ name: (to ? `${stem} ${from} … ${to}` : name).replaceAll("_", " "), children }));
}

const treeElement = (nodes) =>
  element("ul", "tree", ...joined(nodes).map(({ name, children }) => element("li", "", name, ...(children.length > 0 ? [treeElement(children)] : []))));

/** Writes a value of the evidence into an element. */
function write(place, value) {
  if (IS_TREE.test(value)) place.replaceChildren(treeElement([readTree(value)]));
  else place.textContent = value.replace(/\b([a-z]+)_([a-z]+)/g, "$1 $2").replaceAll("_", " ");
}

/** Makes a list of evidence. Returns {list, show(evidence)}; show touches only what has changed. */
export function evidenceList() {
  const list = element("dl", "facts");
  let shown = [];
  const show = (evidence) => {
    if (evidence.length !== shown.length || evidence.some(({ label }, i) => label !== shown[i].label)) {
      list.replaceChildren(...evidence.flatMap(({ label }) => [element("dt", "", label), element("dd")]));
      shown = evidence.map(({ label }) => ({ label, value: null }));
    }
    const places = list.querySelectorAll("dd");
    for (const [i, { value }] of evidence.entries()) if (value !== shown[i].value) write(places[i], value);
    shown = evidence;
  };
  return { list, show };
}
