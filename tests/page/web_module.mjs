// Lets tests without a browser use a module of the page.
import { fileURLToPath } from "node:url";
import esbuild from "esbuild";

/** Imports a module of web/, which has to do without a document. */
export async function importWebModule(file) {
  const entryPoints = [fileURLToPath(new URL(`../../web/${file}`, import.meta.url))];
  const { outputFiles } = await esbuild.build({ entryPoints, bundle: true, write: false, format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}
