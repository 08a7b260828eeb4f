// The tree of parts: what hangs on what, which part's joint moves right now and what it carries along. A press of a
// part shows the axis it turns about; of a part with two axes the next press shows the other one.
import { button, element } from "../base/elements.js";

/** Reads "a (b, c (d))" into {name, children}.
    @typedef {{name: string, children: Part[]}} Part
    @returns {Part} */
function readTree(text) {
  const top = { name: "", children: [] };
  /** @type {Part[]} */
  const path = [top];
  for (const [token] of text.matchAll(/\w+|[()]/g)) {
    const { children } = path[path.length - 1];
    if (token === "(") {
      path.push(children[children.length - 1]);
    } else if (token === ")") {
      path.pop();
    } else {
      children.push({ name: token, children: [] });
    }
  }
  return top.children[0];
}

/** Joins leaves that only differ by the number at their end: "wheel left 1 … 7". */
function joined(children) {
  const rows = [];
  for (const child of children) {
    const [, stem, number] = /^(.*)_(\d+)$/.exec(child.name) ?? [];
    const last = rows.at(-1);
    if (stem && last?.stem === stem) {
      last.to = number;
    } else {
      rows.push({ ...child, stem, from: number });
    }
  }
  return rows.map(({ name, stem, from, to, children }) => ({
    part: name,
    title: (to ? `${stem} ${from} … ${to}` : name).replaceAll("_", " "),
    children: joined(children),
  }));
}

/** The values of the field "axis" are named as the parts are, but of the wheels there is one; a second axis of a part
 *  has the part's name and its own. */
const isAxisOf = (part) => {
  const name = part.startsWith("wheel") ? "wheels" : part;
  return (axis) => axis === name || axis.startsWith(`${name}_`);
};

const listed = (titles) => titles.join(", ").replace(/, ([^,]*)$/, titles.length > 2 ? ", and $1" : " and $1");

export class PartTree {
  #rows = []; // {part, title, item, press, parents}
  #axis = "off";
  #moving = "";

  /** text: the tree as the evidence has it. axes: the command that sets the field "axis". act: does a command. */
  constructor(text, axes, act) {
    this.said = element("p", "unseen");
    this.said.setAttribute("role", "status");
    const list = this.#list(joined([readTree(text)]), [], axes, act);
    list.className = "tree";
    list.setAttribute("aria-label", "The hierarchy of parts");
    this.elements = [list, this.said];
  }

  #list(nodes, parents, axes, act) {
    return element("ul", "", ...nodes.map((node) => this.#item(node, parents, axes, act)));
  }

  #item({ part, title, children }, parents, axes, act) {
    const own = axes.choices.filter(isAxisOf(part));
    const press = button("part", title, () => {
      this.#axis = own[own.indexOf(this.#axis) + 1] ?? "off"; // at once: the next press may come before show()
      act(axes.name, axes.choices.indexOf(this.#axis));
    });
    press.title = `Show the axis of the ${title}`;
    const item = element("li", "", press);
    this.#rows.push({ part, title, item, press, parents });
    if (children.length > 0) {
      item.append(this.#list(children, [...parents, part], axes, act));
    }
    return item;
  }

  /** Shows which joints move and whose axis is drawn. */
  show({ moving, axis }) {
    this.#axis = axis;
    for (const { part, press } of this.#rows) {
      press.setAttribute("aria-pressed", String(isAxisOf(part)(axis)));
    }
    const now = moving.join();
    if (now === this.#moving) {
      return;
    }
    this.#moving = now;
    const moves = ({ part }) => moving.includes(part);
    const isCarried = (row) => !moves(row) && row.parents.some((parent) => moving.includes(parent));
    for (const row of this.#rows) {
      row.item.classList.toggle("moving", moves(row));
      row.item.classList.toggle("carried", isCarried(row));
    }
    const titles = (test) => this.#rows.filter(test).map(({ title }) => title);
    const carried = titles(isCarried);
    this.said.textContent =
      now && `Moving: ${listed(titles(moves))}${carried.length > 0 ? `; carried along: ${listed(carried)}` : ""}.`;
  }
}
