// Which files make the user's tank when they come one after the other, without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { importWebModule } from "./web_module.mjs";

const { TankSet } = await importWebModule("own_tank/tank_set.js");

const MANIFEST = { meshes: ["Body.obj", "Gun.obj", "BodyLow.obj", "GunLow.obj"] };
const named = (...names) => names.map((name) => ({ name, bytes: new TextEncoder().encode(name) }));

test("a tank may come in several pieces, and says what it lacks", () => {
  const set = new TankSet(MANIFEST);
  let { files, missing } = set.add(named("lod/BodyLow.obj", "lod/GunLow.obj"));
  assert.match(missing, /^The low models alone make no tank/);
  set.keep(files);
  ({ files, missing } = set.add(named("Body.obj")));
  assert.match(missing, /not complete: Gun\.obj is missing\. Bring it, too/);
  set.keep(files);
  ({ files, missing } = set.add(named("x/gun.obj", "texture.tga")));
  assert.equal(missing, "");
  assert.equal(files.length, 5);
  set.shown(files);
  assert.match(new TankSet(MANIFEST).add(named("texture.tga")).missing, /^A texture alone makes no tank/);
});

test("low models and textures go to the tank that is shown; other high models begin another", () => {
  const set = new TankSet(MANIFEST);
  const first = set.add(named("Body.obj", "Gun.obj", "texture.tga")).files;
  set.shown(first);
  const withLow = set.add(named("BodyLow.obj", "GunLow.obj"));
  assert.equal(withLow.missing, "");
  assert.equal(withLow.files.length, 5);
  set.shown(withLow.files);
  const other = set.add(named("other/Body.obj", "other/Gun.obj"));
  assert.deepEqual(
    other.files.map(({ name }) => name),
    ["other/Body.obj", "other/Gun.obj"],
  );
  const part = set.add(named("other/Body.obj", "BodyLow.obj"));
  assert.match(part.missing, /Gun\.obj and GunLow\.obj are missing\. Bring them, too/);
  set.keep(part.files);
  const whole = set.add(named("third/Body.obj", "third/Gun.obj")); // no mix with what waits of the other one
  assert.deepEqual(
    whole.files.map(({ name }) => name),
    ["third/Body.obj", "third/Gun.obj"],
  );
});
