// Whether files are laid out as a program lays them out.
import fs from "node:fs";
import path from "node:path";

/** Returns where files differ from what layOut(text, file, full path) makes of them: {file, line, text}; with `write`,
    makes them so. program: what decides. command: what writes. */
export async function checkLayout(root, files, layOut, { program, command, write }) {
  const violations = [];
  for (const file of files) {
    const full = path.join(root, file);
    const text = fs.readFileSync(full, "utf8");
    const laidOut = await layOut(text, file, full);
    if (laidOut === text) {
      continue;
    }
    if (write) {
      fs.writeFileSync(full, laidOut);
      continue;
    }
    const expected = laidOut.split("\n");
    const line = text.split("\n").findIndex((content, index) => content !== expected[index]) + 1;
    violations.push({ file, line, text: `is not as ${program} lays it out (${command} does it)` });
  }
  return violations;
}
