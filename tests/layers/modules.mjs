// The check of what is JavaScript: the page's modules, the scripts and the tests.
import path from "node:path";
import { checkLayout } from "./layout.mjs";

const MODULE = /\.m?js$/;
const TYPES = /\.d\.ts$/;
const PROJECTS = ["tsconfig.json", "tsconfig.web.json"];

async function load(name) {
  try {
    return await import(name);
  } catch (error) {
    throw new Error(`${name} does not start (${error.message}); scripts/setup web installs it`);
  }
}

/** Returns which rules of eslint.config.mjs are broken; with `write`, mends first what can be mended. */
async function checkRules(root, files, write) {
  const { ESLint } = await load("eslint");
  const results = await new ESLint({ cwd: root, fix: write, globInputPaths: false }).lintFiles(files);
  if (write) {
    await ESLint.outputFixes(results);
  }
  return results.flatMap(({ filePath, messages }) =>
    messages.map(({ line, message, ruleId }) => ({
      file: path.relative(root, filePath),
      line: line ?? 1,
      text: `${message} (${ruleId ?? "eslint"})`,
    })),
  );
}

/** Returns where types do not fit. */
async function checkTypes(root, project) {
  const { default: ts } = await load("typescript");
  const host = { ...ts.sys, onUnRecoverableConfigFileDiagnostic: () => {} };
  const parsed = ts.getParsedCommandLineOfConfigFile(path.join(root, project), {}, host);
  if (!parsed) {
    throw new Error(`${project} cannot be read`);
  }
  const program = ts.createProgram(parsed.fileNames, parsed.options);
  return [...parsed.errors, ...ts.getPreEmitDiagnostics(program)].map(({ file, start, messageText, code }) => ({
    file: file ? path.relative(root, file.fileName) : project,
    line: file ? file.getLineAndCharacterOfPosition(start).line + 1 : 1,
    text: `${ts.flattenDiagnosticMessageText(messageText, " ")} (TS${code})`,
  }));
}

/** Returns which of a tree's files are not laid out as prettier does, break a rule, or have a type that does not fit:
    {file, line, text}; with `write`, mends first what can be mended. */
export async function checkModules(root, files, write = false) {
  const modules = files.filter((file) => MODULE.test(file));
  if (modules.length === 0) {
    return [];
  }
  const rules = await checkRules(root, modules, write);
  const prettier = await load("prettier");
  const layOut = async (text, _, filepath) =>
    prettier.format(text, { ...(await prettier.resolveConfig(filepath, { editorconfig: true })), filepath });
  const how = { program: "prettier", command: "npm run lint:fix", write };
  const layout = await checkLayout(root, [...modules, ...files.filter((file) => TYPES.test(file))], layOut, how);
  const types = [];
  for (const project of PROJECTS) {
    types.push(...(await checkTypes(root, project)));
  }
  return [...rules, ...layout, ...types];
}
