// One line about what is drawn.
import { byId } from "../base/elements.js";

const PAUSE_MS = 250;

const counted = (count, one, many = `${one}s`) => `${count.toLocaleString("en")} ${count === 1 ? one : many}`;

/** Keeps the line up to date. */
export function followStatus(program) {
  const line = byId("status");
  const update = (state) => {
    const parts = [`${state.detail === "both" ? "Both models" : `${state.level === "low" ? "Low" : "High"} model`}`];
    // The evidence of a task may say something else of triangles, in words.
    const triangles = state.evidence.find(({ label, value }) => label === "Triangles" && /^\d+$/.test(value));
    if (triangles) {
      parts.push(counted(Number(triangles.value), "triangle"));
    }
    parts.push(counted(program.drawCalls(), "draw call"));
    if (state.sparks > 0) {
      parts.push(counted(state.sparks, "spark"));
    }
    if (state.shot) {
      parts.push("projectile in flight");
    }
    line.textContent = parts.join(" · ");
  };
  // The picture of a state is drawn after it was told.
  program.listen((state) => requestAnimationFrame(() => update(state)), PAUSE_MS);
}
