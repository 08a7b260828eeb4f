// The controls of a value, made from its row in the table of commands: a slider with a number, a switch, or
// choices. Each gives {elements, show(value)}, where a value is what the state has.
import { button, element } from "../base/elements.js";
import { keyStep, scaleOf } from "./scales.js";

const UNITS = { degrees: "°", metres: "m", "metres per second": "m/s" };
const ARROWS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };
const SHORT = 26; // letters: choices that have no more stand side by side

/** Returns a choice's name for people. */
const spoken = (name) => name[0].toUpperCase() + name.slice(1).replaceAll("_", " ");

/** Makes a slider with a number to read and to type. */
function numberControl(field, act) {
  const scale = scaleOf(field);
  const id = `value-${field.name}`;
  let shown = NaN;
  let typing = false;

  const number = element("input", "number");
  Object.assign(number, { type: "number", id, step: "any", inputMode: "decimal" });
  if (!field.wraps) {
    Object.assign(number, { min: field.minimum, max: field.maximum });
  }
  const restore = () => {
    typing = false;
    number.value = shown;
  };
  number.oninput = () => (typing = true);
  number.onchange = () => {
    const typed = number.value;
    restore(); // the state then says what became of it
    if (typed !== "") {
      act(field.name, Number(typed));
    }
  };
  number.onblur = restore;
  number.onkeydown = (event) => {
    if (event.key !== "Escape") {
      return;
    }
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
    if (steps === undefined) {
      return;
    }
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
      if (!typing) {
        number.value = value;
      }
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

function listControl(field, act) {
  const list = element("select");
  for (const [i, name] of field.choices.entries()) {
    list.append(new Option(spoken(name), String(i)));
  }
  list.onchange = () => act(field.name, Number(list.value));
  const label = element("label", "whole", element("span", "", field.title), list);
  return { elements: [label], show: (value) => (list.value = String(field.choices.indexOf(value))) };
}

let sets = 0; // of choices side by side: each needs a name of its own

/** Makes choices side by side. They are radio buttons, so that the arrows go from one to the next. */
export function segmentsControl(field, act) {
  const name = `segments-${++sets}`;
  const inputs = field.choices.map((choice, i) => {
    const input = element("input");
    Object.assign(input, { type: "radio", name, value: choice });
    input.onchange = () => act(field.name, i);
    return input;
  });
  const segments = element(
    "div",
    "segments",
    ...inputs.map((input, i) => element("label", "", input, element("span", "", spoken(field.choices[i])))),
  );
  segments.setAttribute("role", "radiogroup");
  segments.setAttribute("aria-label", field.title);
  const title = element("span", "whole", field.title);
  return {
    elements: [title, segments],
    show: (value) => inputs.forEach((input) => (input.checked = input.value === value)),
  };
}

/** Makes the control that fits a field. act: does a command, telling what goes wrong. */
export function control(field, act) {
  if (!field.choices) {
    return numberControl(field, act);
  }
  if (field.choices.join() === "off,on") {
    return switchControl(field, act);
  }
  return field.choices.join("").length <= SHORT ? segmentsControl(field, act) : listControl(field, act);
}

/** Returns a field's default as the state would have it. */
export const defaultOf = (field) => (field.choices ? field.choices[field.default] : field.default);
