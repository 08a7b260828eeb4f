// The static server: what it sends, to whom, and what it keeps to itself.
import assert from "node:assert/strict";
import fs from "node:fs";
import http from "node:http";
import os from "node:os";
import path from "node:path";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";
import { serve } from "../../scripts/serve.mjs";

const SCRIPT = fileURLToPath(new URL("../../scripts/serve.mjs", import.meta.url));
const TEXT = "tank ".repeat(1000);

let outside;
let folder;
let server;
before(async () => {
  outside = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-serve-"));
  folder = path.join(outside, "site");
  fs.mkdirSync(path.join(folder, "deep er"), { recursive: true });
  fs.writeFileSync(path.join(outside, "secret.txt"), "secret");
  fs.writeFileSync(path.join(outside, "site.txt"), "beside the folder");
  fs.writeFileSync(path.join(folder, "index.html"), TEXT);
  fs.writeFileSync(path.join(folder, "a.wasm"), Buffer.alloc(1000));
  fs.writeFileSync(path.join(folder, "a.png"), Buffer.alloc(1000));
  fs.writeFileSync(path.join(folder, "deep er", "index.html"), "deep");
  fs.symlinkSync(path.join(outside, "secret.txt"), path.join(folder, "link.txt"));
  server = await serve(folder);
});
after(async () => {
  await server.close();
  fs.rmSync(outside, { recursive: true });
});

/** Asks for a path exactly as written; fetch would tidy it up. */
async function get(requestPath, { method = "GET", headers = {} } = {}) {
  const request = http.request({ host: "127.0.0.1", port: server.port, path: requestPath, method, headers }).end();
  const [response] = await once(request, "response");
  const parts = [];
  for await (const part of response) {
    parts.push(part);
  }
  return { status: response.statusCode, headers: response.headers, body: Buffer.concat(parts) };
}

test("a file is sent with its type, uncached, and a folder as its index.html", async () => {
  const index = await get("/");
  assert.equal(index.status, 200);
  assert.equal(index.body.toString(), TEXT);
  assert.match(index.headers["content-type"], /^text\/html/);
  assert.equal(index.headers["cache-control"], "no-store");
  assert.equal((await get("/a.wasm?v=1")).headers["content-type"], "application/wasm");
  assert.equal((await get("/deep%20er/")).body.toString(), "deep");
});

test("what compresses is gzipped for those who accept it, and only for them", async () => {
  const plain = await get("/index.html");
  assert.equal(plain.headers["content-encoding"], undefined);
  const zipped = await get("/index.html", { headers: { "Accept-Encoding": "br, gzip" } });
  assert.equal(zipped.headers["content-encoding"], "gzip");
  assert.equal(Number(zipped.headers["content-length"]), zipped.body.length);
  assert.ok(zipped.body.length < plain.body.length / 10);
  assert.equal(gunzipSync(zipped.body).toString(), TEXT);
  assert.equal(
    (await get("/a.png", { headers: { "Accept-Encoding": "gzip" } })).headers["content-encoding"],
    undefined,
  );
});

test("HEAD sends what GET would, without the body", async () => {
  const head = await get("/index.html", { method: "HEAD" });
  assert.equal(head.status, 200);
  assert.equal(Number(head.headers["content-length"]), TEXT.length);
  assert.equal(head.body.length, 0);
  assert.equal((await get("/index.html", { method: "POST" })).status, 405);
});

for (const requestPath of [
  "/none.html",
  "/../secret.txt",
  "/..%2fsecret.txt",
  "/%2e%2e/secret.txt",
  "/deep%20er/../../secret.txt",
  "/../site.txt",
  "/link.txt",
  "/index.html/",
  "/a%00.png",
  "/%",
  "//etc/passwd",
  "http://elsewhere/",
]) {
  test(`${requestPath} is not found`, async () => {
    const response = await get(requestPath);
    assert.equal(response.status, 404);
    assert.doesNotMatch(response.body.toString(), /secret|beside/);
  });
}

test("a taken port gives the next free one, and it says so; Ctrl-C ends it", async () => {
  const program = spawn(process.execPath, [SCRIPT, "--port", String(server.port), folder]);
  let output = "";
  program.stdout.on("data", (part) => (output += part));
  while (!output.includes("Ctrl-C")) {
    await once(program.stdout, "data");
  }
  const [, port] = /is at http:\/\/127\.0\.0\.1:(\d+)\//.exec(output);
  assert.ok(Number(port) > server.port);
  assert.match(output, new RegExp(`Port ${server.port} is taken; using ${port}`));
  assert.equal(await (await fetch(`http://127.0.0.1:${port}/`)).text(), TEXT);
  program.kill("SIGINT");
  assert.deepEqual(await once(program, "exit"), [0, null]);
});

/** @type {[string[], RegExp][]} */
const REFUSED = [
  [["--port", "x"], /'x' is no port/],
  [["--port", "70000"], /'70000' is no port/],
  [["/there/is/no/folder"], /there is no folder/],
];
for (const [given, complaint] of REFUSED) {
  test(`${given.join(" ")} is refused with status 2`, async () => {
    const program = spawn(process.execPath, [SCRIPT, ...given]);
    let output = "";
    program.stderr.on("data", (part) => (output += part));
    const [status] = await once(program, "close");
    assert.equal(status, 2);
    assert.match(output, complaint);
  });
}
