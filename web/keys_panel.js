// The list of keys, made from the program's table of commands. A row is a button that does what the key does.
import { keycaps, keyLabels } from "./keycaps.js";

function group(commands) {
  const groups = new Map();
  for (const command of commands) {
    if (!groups.has(command.group)) groups.set(command.group, []);
    groups.get(command.group).push(command);
  }
  return groups;
}

function row(command, labels, program) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "key-row";
  button.dataset.command = command.name;
  const title = document.createElement("span");
  title.textContent = command.title;
  button.append(title, keycaps(labels(command)));
  if (command.kind === "press") {
    button.onclick = () => program.command(command.name);
    return button;
  }
  button.onmousedown = (event) => event.preventDefault(); // The picture keeps the focus, and with it its keys.
  const hold = () => program.command(command.name, 1);
  const release = () => program.command(command.name, 0);
  button.onpointerdown = (event) => {
    button.setPointerCapture(event.pointerId);
    hold();
  };
  button.onpointerup = button.onpointercancel = button.onlostpointercapture = release;
  button.onkeydown = (event) => {
    if (event.code === "Enter" || event.code === "Space") {
      event.preventDefault();
      if (!event.repeat) hold();
    }
  };
  button.onkeyup = button.onblur = release;
  return button;
}

/** Fills the panel of keys and lights the rows whose commands are held. */
export async function showKeys(program, states) {
  const panel = document.getElementById("keys");
  const labels = await keyLabels();
  const withKeys = program.commands().filter((command) => command.keys.length > 0);
  for (const [name, commands] of group(withKeys)) {
    const title = document.createElement("h2");
    title.textContent = name;
    panel.append(title, ...commands.map((command) => row(command, labels, program)));
  }
  const mouse = document.createElement("h2");
  mouse.textContent = "Mouse";
  const text = document.createElement("p");
  text.textContent = "Drag to go round the tank, turn the wheel to go nearer or further away.";
  panel.append(mouse, text);
  states.listen((state) => {
    for (const button of panel.querySelectorAll(".key-row"))
      button.classList.toggle("held", state.held.includes(button.dataset.command));
  });
}
