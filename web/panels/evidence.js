// What shows live that a task is done: labels and values, and the tree of parts as a tree.
import { element } from "../base/elements.js";
import { PartTree } from "./part_tree.js";

const IS_TREE = /^\w+ \([\w (),]+\)$/;

/** Makes a list of evidence. axes: the command that sets the axis that is drawn. act: does a command.
    Returns {list, show(live)}; show takes what Program.evidence() gives and touches only what has changed. */
export function evidenceList(axes, act) {
  const list = element("dl", "facts");
  let shown = [];
  let tree = null;
  const write = (place, value) => {
    if (IS_TREE.test(value)) {
      tree = new PartTree(value, axes, act);
      place.replaceChildren(...tree.elements);
    } else {
      place.textContent = value.replace(/\b([a-z]+)_([a-z]+)/g, "$1 $2").replaceAll("_", " ");
    }
  };
  const show = (live) => {
    const { evidence } = live;
    if (evidence.length !== shown.length || evidence.some(({ label }, i) => label !== shown[i].label)) {
      list.replaceChildren(...evidence.flatMap(({ label }) => [element("dt", "", label), element("dd")]));
      shown = evidence.map(({ label }) => ({ label, value: null }));
      tree = null;
    }
    const places = list.querySelectorAll("dd");
    for (const [i, { value }] of evidence.entries()) {
      if (value !== shown[i].value) {
        write(places[i], value);
      }
    }
    shown = evidence;
    tree?.show(live);
  };
  return { list, show };
}
