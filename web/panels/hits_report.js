// A report of hits as people read it: the whole tank first, then the parts, with a bar for each sphere.
import { element } from "../base/elements.js";

const SAY_PAUSE_MS = 1500; // a reader of screens needs time to speak

const spoken = (name) => name.replaceAll("_", " ");
const metres = (value) => `${value.toFixed(2)} m`;
const place = (point) => `(${point.map((value) => Number(value.toFixed(2))).join(", ")})`;
const size = (value) => metres(Math.abs(value));

/** Says how deep something is inside, or how far outside. */
const depthText = ({ depth, inside = depth >= 0 }) => (inside ? `${size(depth)} deep` : `${size(depth)} outside`);

/** Returns a bar from the sphere's centre, at the left, to its surface and, if what was tested is outside, on to
    that: the bright part is how deep it is. */
function bar({ radius, distance, inside }) {
  const made = element(
    "div",
    `bar${inside ? " inside" : ""}`,
    element("i", "sphere"),
    element("i", "depth"),
    element("i", "tested"),
  );
  const whole = Math.max(radius, distance) || 1;
  made.style.setProperty("--radius", `${(100 * radius) / whole}%`);
  made.style.setProperty("--distance", `${(100 * distance) / whole}%`);
  return made;
}

/** Returns what was found of one sphere. */
function sphere(title, test, isLine, level) {
  const numbers = [
    `${metres(test.distance)} from the centre, radius ${metres(test.radius)}`,
    `centre ${place(test.centre)}`,
  ];
  if (isLine) {
    numbers.push(`closest point ${place(test.closest_point)} at t = ${Number(test.parameter.toFixed(3))}`);
  }
  return element(
    "div",
    `level ${level}${test.inside ? " is-inside" : ""}`,
    element("div", "line", element("b", "", title), element("span", "amount", depthText(test))),
    bar(test),
    element("p", "numbers", ...numbers.map((text) => element("span", "", text))),
  );
}

/** Returns a mark for each part that was tested, filled where it was penetrated. */
function testedParts(tested) {
  const marks = tested.map(({ part, depth }) => {
    const mark = element("i", depth >= 0 ? "is-inside" : "");
    mark.title = `${spoken(part)}: ${depthText({ depth })}`;
    return mark;
  });
  const made = element("div", "tested-parts", ...marks);
  made.setAttribute("aria-hidden", "true"); // the lines below it say the same
  return made;
}

function triangle({ part, inside, distance }) {
  const text = inside ? `${metres(distance)} deep: hit` : `${metres(distance)} away: rejected`;
  return element("div", "line", element("b", "", spoken(part)), element("span", "amount", text));
}

const JOINS = { segment: "to", ray: "through", line: "and" };

function probeText({ probe, from, to, radius }) {
  if (probe === "point") {
    return `Point ${place(from)}${radius > 0 ? ` with radius ${metres(radius)}` : ""}`;
  }
  const name = probe[0].toUpperCase() + probe.slice(1);
  return `${name} ${probe === "line" ? "through" : "from"} A ${place(from)} ${JOINS[probe]} B ${place(to)}; t is 0 at A, 1 at B`;
}

/** Shows a report, or that nothing is tested, in an element. */
export function showReport(box, report) {
  if (!report) {
    box.replaceChildren(element("p", "quietly", "Nothing is tested. Choose a point or a line above."));
    return;
  }
  const parts = [element("p", "", probeText(report))];
  if (report.refusal) {
    box.replaceChildren(...parts, element("p", "failed", `It is not tested: ${report.refusal}.`));
    return;
  }
  const isLine = report.probe !== "point";
  parts.push(element("h3", "", "1. The whole tank"), sphere("Tank", report.root, isLine, "whole"));
  const { tested, parts: hit } = report;
  parts.push(
    element(
      "h3",
      "",
      report.root.inside
        ? `2. Its ${tested.length} parts: ${hit.length || "none"} penetrated`
        : "2. Its parts: not tested",
    ),
  );
  if (report.root.inside) {
    parts.push(testedParts(tested), ...hit.map((test) => sphere(spoken(test.part), test, isLine, "part")));
  }
  if (report.triangles.length > 0) {
    parts.push(element("h3", "", "3. Their triangles"), ...report.triangles.map(triangle));
  }
  box.replaceChildren(...parts);
}

/** Returns what is said of a report: only what is penetrated, not the numbers. */
function summary(report) {
  if (!report) {
    return "Nothing is tested.";
  }
  if (report.refusal) {
    return `Not tested: ${report.refusal}.`;
  }
  if (!report.root.inside) {
    return "Outside the whole tank.";
  }
  if (report.parts.length === 0) {
    return "Inside the whole tank, in none of its parts.";
  }
  return `Inside the whole tank. Penetrates ${report.parts.map(({ part }) => spoken(part)).join(", ")}.`;
}

/** Returns a function that says in an element what is penetrated, when that changes, and not too often. */
export function announcer(element) {
  let timer = 0;
  let newest = null;
  let said;
  return (report) => {
    const text = summary(report);
    if (text === newest) {
      return;
    }
    const isFirst = newest === null;
    newest = text;
    if (isFirst) {
      said = text; // what the page begins with is read where it stands
    }
    if (timer) {
      return;
    }
    timer = setTimeout(() => {
      timer = 0;
      if (newest !== said) {
        element.textContent = said = newest;
      }
    }, SAY_PAUSE_MS);
  };
}
