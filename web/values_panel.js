// A control for each value of the state, made from the program's table: a slider with a number, a switch, or
// a list of choices.
import { button, element } from "./elements.js";
import { byGroup, foldedGroup } from "./groups.js";
import { keyStep, scaleOf } from "./scales.js";

const UNITS = { degrees: "°", metres: "m", "metres per second": "m/s" };
const ARROWS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

/** Returns a choice's name for people. */
const spoken = (name) => name[0].toUpperCase() + name.slice(1).replaceAll("_", " ");

/** Makes a slider with a number to read and to type. Returns its elements, and show(value). */
function numberControl(field, act) {
  const scale = scaleOf(field);
  const id = `value-${field.name}`;
  let shown = NaN;
  let typing = false;

  const number = element("input", "number");
  Object.assign(number, { type: "number", id, step: "any", inputMode: "decimal" });
  if (!field.wraps) Object.assign(number, { min: field.minimum, max: field.maximum });
  const restore = () => {
    typing = false;
    number.value = shown;
  };
  number.oninput = () => (typing = true);
  number.onchange = () => {
    const typed = number.value;
    restore(); // the state then says what became of it
    if (typed !== "") act(field.name, Number(typed));
  };
  number.onblur = restore;
  number.onkeydown = (event) => {
    if (event.key !== "Escape") return;
    event.preventDefault();
    restore();
    number.select();
  };

  const slider = element("input", "slider");
  Object.assign(slider, { type: "range", min: 0, max: scale.ends, step: "any" });
  slider.setAttribute("aria-label", field.title);
  slider.oninput = () => act(field.name, scale.value(Number(slider.value)));
  slider.ondblclick = () => act(field.name, field.default);
  slider.onkeydown = (event) => {
    const steps = ARROWS[event.key];
    if (steps === undefined) return;
    event.preventDefault();
    act(field.name, shown + steps * (event.shiftKey ? field.step : keyStep(field, shown)));
  };

  const unit = UNITS[field.unit] ?? field.unit;
  const label = element("label", "", field.title);
  label.htmlFor = id;
  const back = button("quiet back", "↺", () => act(field.name, field.default));
  back.title = `Back to ${field.default} ${unit}`.trim();
  back.setAttribute("aria-label", `${field.title}: back to ${field.default} ${field.unit}`.trim());

  return {
    elements: [label, back, element("span", "amount", number, element("span", "unit", unit)), slider],
    show: (value) => {
      shown = value;
      if (!typing) number.value = value;
      const place = scale.place(value);
      const [from, to] = [place, scale.place(field.default)].sort((a, b) => a - b);
      slider.value = place;
      slider.style.setProperty("--from", `${(100 * from) / scale.ends}%`);
      slider.style.setProperty("--to", `${(100 * to) / scale.ends}%`);
      slider.setAttribute("aria-valuetext", `${value} ${field.unit}`.trim());
      back.classList.toggle("idle", value === field.default);
    },
  };
}

function switchControl(field, act) {
  const box = element("input", "switch");
  box.type = "checkbox";
  box.onchange = () => act(field.name, box.checked ? 1 : 0);
  const label = element("label", "whole", element("span", "", field.title), box);
  return { elements: [label], show: (value) => (box.checked = value === "on") };
}

function choiceControl(field, act) {
  const list = element("select");
  for (const [i, name] of field.choices.entries()) list.append(new Option(spoken(name), String(i)));
  list.onchange = () => act(field.name, Number(list.value));
  const label = element("label", "whole", element("span", "", field.title), list);
  return { elements: [label], show: (value) => (list.value = String(field.choices.indexOf(value))) };
}

function control(field, act) {
  if (!field.choices) return numberControl(field, act);
  return field.choices.join() === "off,on" ? switchControl(field, act) : choiceControl(field, act);
}

/** Fills the panel; the controls follow the state. */
export function showValues({ program, act }) {
  const panel = document.getElementById("values");
  // A row that sets several fields has each of them in a row of its own.
  const fields = program.commands().filter((command) => command.kind === "set" && command.fields.length === 1);
  const shows = new Map();
  const row = (field) => {
    const { elements, show } = control(field, act);
    shows.set(field.name, show);
    const made = element("div", "value", ...elements);
    made.dataset.field = field.name;
    return made;
  };
  for (const [title, group] of byGroup(fields)) {
    const said = group.length === 1 && group[0].title === title; // by the row itself
    panel.append(said ? row(group[0]) : foldedGroup(title, `values.${title}`, group.map(row)));
  }

  const shown = {};
  program.listen((state) => {
    for (const [name, show] of shows) {
      if (state[name] === shown[name]) continue;
      shown[name] = state[name];
      show(state[name]);
    }
  });
}
