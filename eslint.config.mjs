import js from "@eslint/js";
import globals from "globals";

export default [
  { ignores: ["build/"] },
  js.configs.recommended,
  {
    files: ["**/*.js", "**/*.mjs"],
    languageOptions: { ecmaVersion: 2022, sourceType: "module" },
    rules: {
      curly: "error",
      eqeqeq: "error",
      "no-implicit-globals": "error",
      "no-var": "error",
      "prefer-const": "error",
    },
  },
  { files: ["web/**"], languageOptions: { globals: globals.browser } },
  { files: ["tests/bench/page/**"], languageOptions: { globals: globals.browser } },
  { files: ["scripts/**", "tests/**"], languageOptions: { globals: globals.nodeBuiltin } },
  { files: ["tests/page/**", "scripts/bench*"], languageOptions: { globals: globals.browser } },
];
