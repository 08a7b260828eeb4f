// A control for each value of the state, made from the program's table: sliders, and boxes for choices.

function slider(field, program) {
  const input = document.createElement("input");
  input.type = "range";
  input.min = field.minimum;
  input.max = field.maximum;
  input.step = field.step;
  input.oninput = () => program.command(field.name, Number(input.value));
  return { input, show: (value) => (input.value = value) };
}

function choice(field, program) {
  const input = document.createElement("select");
  for (const [i, name] of field.choices.entries()) input.append(new Option(name, String(i)));
  input.oninput = () => program.command(field.name, Number(input.value));
  return { input, show: (value) => (input.value = String(field.choices.indexOf(value))) };
}

const UNITS = { degrees: "°", metres: " m" };

/** Fills the panel of values; the controls follow the state. */
export function showValues(program, states) {
  const panel = document.getElementById("values");
  let group = "";
  for (const field of program.commands().filter((c) => c.kind === "set" && c.fields.length === 1 && c.name === c.fields[0])) {
    if (field.group !== group) {
      group = field.group;
      const title = document.createElement("h2");
      title.textContent = group;
      panel.append(title);
    }
    const row = document.createElement("label");
    row.className = "value-row";
    const name = document.createElement("span");
    name.textContent = field.title;
    const shown = document.createElement("output");
    const control = field.choices ? choice(field, program) : slider(field, program);
    row.append(name, ...(field.choices ? [control.input] : [shown, control.input]));
    panel.append(row);
    states.listen((state) => {
      const value = state[field.name];
      if (document.activeElement !== control.input || field.choices || Number(control.input.value) !== value) control.show(value);
      shown.textContent = field.choices ? "" : `${value}${UNITS[field.unit] ?? ""}`;
    });
  }
}
