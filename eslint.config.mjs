// What the modules of the page, the scripts and the tests are held to besides their layout, which is prettier's, and
// their types, which are in tsconfig.json. `npm run lint` checks all three.
import js from "@eslint/js";
import globals from "globals";

/** Each room of web/ knows what lies below it, and itself. */
const ROOMS = {
  base: [],
  program: ["base"],
  controls: ["base"],
  panels: ["base", "controls"],
  picture: ["base"],
  own_tank: ["base"],
};
const mayNotImport = (room) => Object.keys(ROOMS).filter((other) => other !== room && !ROOMS[room].includes(other));

export default [
  js.configs.recommended,
  {
    files: ["**/*.js", "**/*.mjs"],
    languageOptions: { ecmaVersion: 2022, sourceType: "module" },
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      curly: ["error", "all"],
      eqeqeq: "error",
      "no-implicit-globals": "error",
      "no-unused-vars": ["error", { ignoreRestSiblings: true }], // to leave something out is to name it
      "no-var": "error",
      "one-var": ["error", "never"],
      "prefer-const": "error",
    },
  },
  { files: ["web/**", "tests/bench/page/**"], languageOptions: { globals: globals.browser } },
  { files: ["scripts/**", "tests/fuzz/**", "tests/layers/**"], languageOptions: { globals: globals.nodeBuiltin } },
  // What a test or a bench has the browser do stands in it.
  {
    files: ["tests/page/**", "scripts/bench*.mjs"],
    languageOptions: {
      globals: { ...globals.nodeBuiltin, ...globals.browser, tanklab: "readonly", drawScene: "readonly" },
    },
  },
  {
    files: ["tests/bench/page/**"],
    languageOptions: {
      globals: { createLegacygl: "readonly", createEmscripten: "readonly", createReading: "readonly" },
    },
  },
  ...Object.keys(ROOMS).map((room) => ({
    files: [`web/${room}/**`],
    rules: {
      "no-restricted-imports": [
        "error",
        {
          patterns: [
            {
              group: mayNotImport(room).map((other) => `**/${other}/**`),
              message: `${room}/ does not know that room.`,
            },
          ],
        },
      ],
    },
  })),
];
