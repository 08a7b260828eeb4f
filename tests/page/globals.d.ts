// What tests find in the pages that they open, as the types' checker needs it told. What is not there after all fails
// the test.

declare const tanklab: any; // web/main.js puts it there
declare function drawScene(index: number): Promise<{ problem: string; told: string; pixels: string }>; // tests/oracle

interface Window {
  glCalls: Record<string, number>; // these are the tests' own
  said: [number, string][];
  tanklabBench: { firstFrame: number | null; frames: number[]; recording: boolean };
}

/** A selector does not tell which kind of element it finds, and a test asks for what only some kinds have. */
interface Element {
  dataset: DOMStringMap;
  innerText: string;
  disabled: any;
  open: any;
  type: any;
  value: any;
  click(): void;
}
