// One line about what is drawn.
import { byId } from "../base/elements.js";

const PAUSE_MS = 250;

const counted = (count, one, many = `${one}s`) => `${count.toLocaleString("en")} ${count === 1 ? one : many}`;

/** Keeps the line up to date. */
export function followStatus(program) {
  const line = byId("status");
  const update = (status) => {
    const models = status.detail === "both" ? "Both models" : `${status.level === "low" ? "Low" : "High"} model`;
    const parts = [models, counted(status.triangles, "triangle"), counted(program.drawCalls(), "draw call")];
    if (status.sparks > 0) {
      parts.push(counted(status.sparks, "spark"));
    }
    if (status.flies) {
      parts.push("projectile in flight");
    }
    line.textContent = parts.join(" · ");
  };
  // Not within the frame that tells it.
  program.listen((status) => requestAnimationFrame(() => update(status)), PAUSE_MS);
}
