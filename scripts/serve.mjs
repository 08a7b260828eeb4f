// Serves a folder of static files on 127.0.0.1.
//
//   node scripts/serve.mjs [--port N] [--isolated] [FOLDER]     default: port 8000, build/web
//
// Where the port is taken it takes the next free one. Nothing is cached, and what compresses is sent
// gzipped to those who accept that, so that the sizes a browser reports are those a real host would send.
// --isolated sends the headers that give performance.now() its finest resolution. Ctrl-C stops it.
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";

const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".webmanifest": "application/manifest+json; charset=utf-8",
  ".wasm": "application/wasm",
  ".obj": "text/plain; charset=utf-8",
  ".mtl": "text/plain; charset=utf-8",
  ".txt": "text/plain; charset=utf-8",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".jpg": "image/jpeg",
  ".ico": "image/x-icon",
  ".tga": "image/x-tga",
};
const COMPRESSED_ALREADY = new Set([".png", ".jpg", ".ico"]);
const PORTS_TRIED = 100;

/** Returns the file that a request's path means, or null where it means none below the folder. */
function fileFor(folder, requestPath) {
  let decoded;
  try {
    decoded = decodeURIComponent(requestPath);
  } catch {
    return null;
  }
  if (decoded.includes("\0")) {
    return null;
  }
  let file = path.join(folder, decoded);
  try {
    if (fs.statSync(file).isDirectory()) {
      file = path.join(file, "index.html");
    }
    // Links are followed before the comparison: one that points out of the folder is outside.
    file = fs.realpathSync(file);
    if (!fs.statSync(file).isFile()) {
      return null;
    }
  } catch {
    return null;
  }
  return file.startsWith(fs.realpathSync(folder) + path.sep) ? file : null;
}

function answer(folder, isolated, request, response) {
  const headers = { "Cache-Control": "no-store", "X-Content-Type-Options": "nosniff" };
  if (isolated) {
    headers["Cross-Origin-Opener-Policy"] = "same-origin";
    headers["Cross-Origin-Embedder-Policy"] = "require-corp";
  }
  const refuse = (status, text) => {
    response.writeHead(status, { ...headers, "Content-Type": "text/plain; charset=utf-8" });
    response.end(request.method === "HEAD" ? undefined : `${text}\n`);
  };
  if (request.method !== "GET" && request.method !== "HEAD") {
    return refuse(405, "Only GET and HEAD");
  }
  const requestPath = request.url.replace(/[?#].*$/s, "");
  const file = requestPath.startsWith("/") ? fileFor(folder, requestPath) : null;
  if (!file) {
    return refuse(404, "There is no such file here");
  }

  const extension = path.extname(file).toLowerCase();
  /** @type {Buffer} */
  let bytes = fs.readFileSync(file);
  headers["Content-Type"] = TYPES[extension] ?? "application/octet-stream";
  if (!COMPRESSED_ALREADY.has(extension)) {
    headers.Vary = "Accept-Encoding";
    if (/\bgzip\b/.test(request.headers["accept-encoding"] ?? "")) {
      headers["Content-Encoding"] = "gzip";
      bytes = gzipSync(bytes, { level: 9 });
    }
  }
  headers["Content-Length"] = bytes.length;
  response.writeHead(200, headers);
  response.end(request.method === "HEAD" ? undefined : bytes);
}

/** Serves a folder; port 0 is any free one, another is the first to try.
    Gives { url, port, close() } once it listens. */
export async function serve(folder, { port = 0, isolated = false } = {}) {
  const server = http.createServer((request, response) => {
    try {
      answer(folder, isolated, request, response);
    } catch (error) {
      response.destroy(error);
    }
  });
  for (let next = port; ; ++next) {
    try {
      await new Promise((resolve, reject) => {
        server.once("error", reject);
        server.listen(next, "127.0.0.1", () => {
          server.off("error", reject);
          resolve();
        });
      });
      break;
    } catch (error) {
      const another = error.code === "EADDRINUSE" && port !== 0 && next < Math.min(port + PORTS_TRIED, 65535);
      if (!another) {
        throw new Error(`port ${next} cannot be had (${error.code}); --port names another one`);
      }
    }
  }
  const { port: actual } = /** @type {import("node:net").AddressInfo} */ (server.address());
  const close = () =>
    new Promise((resolve) => {
      server.close(resolve);
      server.closeAllConnections?.();
    });
  return { url: `http://127.0.0.1:${actual}/`, port: actual, close };
}

async function main() {
  const { values, positionals } = parseArgs({
    options: { port: { type: "string", default: "8000" }, isolated: { type: "boolean", default: false } },
    allowPositionals: true,
  });
  const folder = positionals[0] ?? fileURLToPath(new URL("../build/web", import.meta.url));
  const port = Number(values.port);
  if (!Number.isInteger(port) || port < 0 || port > 65535) {
    throw new Error(`'${values.port}' is no port: 0 to 65535`);
  }
  if (!fs.existsSync(folder)) {
    throw new Error(`there is no folder ${folder}`);
  }
  const server = await serve(folder, { port, isolated: values.isolated });
  if (port !== 0 && server.port !== port) {
    console.log(`Port ${port} is taken; using ${server.port}.`);
  }
  console.log(`Tank Lab is at ${server.url} (Ctrl-C stops it)`);
  for (const signal of ["SIGINT", "SIGTERM"]) {
    process.on(signal, () => server.close().then(() => process.exit(0)));
  }
}

if (process.argv[1] && fs.realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  main().catch((error) => {
    console.error(`serve: ${error.message}`);
    process.exit(2);
  });
}
