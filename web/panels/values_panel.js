// A control for each value of the state, made from the program's table, in groups that fold.
import { byId, element } from "../base/elements.js";
import { control, defaultOf } from "../controls/controls.js";
import { byGroup, foldedGroup } from "../controls/groups.js";

const PAUSE_MS = 30;

/** Makes the field that hides the rows without the words typed into it. rows: [{text, row}] */
function finder(panel, rows) {
  const search = element("input", "search");
  Object.assign(search, { type: "search", placeholder: "Find a value", spellcheck: false });
  search.setAttribute("aria-label", "Find a value");
  const unfolded = []; // groups that were folded before something was looked for
  search.oninput = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const { text, row } of rows) {
      row.hidden = !words.every((word) => text.includes(word));
    }
    if (words.length === 0) {
      for (const group of unfolded.splice(0)) {
        group.open = false;
      }
    }
    for (const group of panel.querySelectorAll(".group")) {
      group.hidden = !group.querySelector(".value:not([hidden])");
      if (words.length === 0 || group.open) {
        continue;
      }
      unfolded.push(group);
      group.open = true;
    }
  };
  search.onkeydown = (event) => {
    if (event.key !== "Escape" || !search.value) {
      return;
    }
    event.preventDefault();
    search.value = "";
    search.oninput();
  };
  return search;
}

/** Fills the panel; the controls follow the state. */
export function showValues({ program, act }) {
  const panel = byId("values");
  // A row that sets several fields has each of them in a row of its own.
  const fields = program.commands().filter((command) => command.kind === "set" && command.fields.length === 1);
  const shows = new Map();
  const rows = [];
  const makeRow = (field) => {
    const { elements, show } = control(field, act);
    shows.set(field.name, show);
    const row = element("div", "value", ...elements);
    row.dataset.field = field.name;
    rows.push({
      row,
      text: `${field.title} ${field.name} ${field.group} ${field.choices?.join(" ") ?? ""}`.toLowerCase(),
    });
    return row;
  };
  const groups = [];
  for (const [title, group] of byGroup(fields)) {
    const made = group.map(makeRow);
    if (group.length === 1) {
      panel.append(...made);
      continue;
    }
    const folded = foldedGroup(title, `values.${title}`, made, { open: false });
    groups.push({ group, heading: folded.querySelector("h2"), title });
    panel.append(folded);
  }
  panel.prepend(finder(panel, rows));

  const shown = {};
  const update = (status) => {
    if (panel.hidden || !status) {
      return;
    }
    const values = program.fields();
    for (const [name, show] of shows) {
      if (values[name] === shown[name]) {
        continue;
      }
      shown[name] = values[name];
      show(values[name]);
    }
    for (const { group, heading, title } of groups) {
      const changed = group.filter((field) => values[field.name] !== defaultOf(field)).length;
      const text = changed ? `${title} · ${changed} changed` : title;
      if (heading.textContent !== text) {
        heading.textContent = text;
      }
    }
  };
  program.listen(update, PAUSE_MS);
  panel.addEventListener("shown", () => update(program.newest));
}
