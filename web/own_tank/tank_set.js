// Which files make the user's tank, when they come one after the other: models first, or texture, or low models.
import { baseName } from "./tank_files.js";

const listed = (names) => (names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`);

/** Returns `before` without what comes again, and what is new. Two of one name among the new ones both stay:
    the program tells whether they are the same. */
function merged(before, files) {
  const again = new Set(files.map(({ name }) => baseName(name)));
  return [...before.filter(({ name }) => !again.has(baseName(name))), ...files];
}

export class TankSet {
  #high;
  #low;
  #shown = []; // the files of the tank that is shown
  #waiting = []; // files that do not make a tank yet

  /** manifest: see Program.assetManifest. Its meshes are the high ones, then as many low ones. */
  constructor({ meshes }) {
    this.#high = meshes.slice(0, meshes.length / 2);
    this.#low = meshes.slice(meshes.length / 2);
  }

  /** Adds files to those that wait; files without a high model go to the tank that is shown.
      Returns {files, missing}: what to make a tank of, and a sentence about what that needs first, or "". */
  add(files) {
    const missingIn = (some, names) =>
      names.filter((name) => !some.some((file) => baseName(file.name) === name.toLowerCase()));
    // All high models begin a tank of their own: what waits of another one is none of it.
    const begins =
      missingIn(files, this.#high).length === 0 && missingIn(this.#waiting, this.#high).length < this.#high.length;
    let all = merged(begins ? [] : this.#waiting, files);
    const missingOf = (names) => missingIn(all, names);
    if (missingOf(this.#high).length === this.#high.length) {
      all = merged(this.#shown, all);
    }
    const [high, low] = [missingOf(this.#high), missingOf(this.#low)];
    let missing = "";
    if (high.length === this.#high.length) {
      const only = low.length < this.#low.length ? "The low models alone" : "A texture alone";
      missing = `${only} make${low.length < this.#low.length ? "" : "s"} no tank. Bring the models of tankLab.zip, too; what you brought is kept until then.`;
    } else {
      const names = [...high, ...(low.length < this.#low.length ? low : [])];
      if (names.length > 0) {
        missing = `The tank is not complete: ${listed(names)} ${names.length > 1 ? "are" : "is"} missing. Bring ${names.length > 1 ? "them" : "it"}, too; what you brought is kept until then.`;
      }
    }
    return { files: all, missing };
  }

  /** Keeps files for the next that come. */
  keep(files) {
    this.#waiting = files;
  }

  /** Notes which files are shown. */
  shown(files) {
    this.#shown = files;
    this.#waiting = [];
  }
}
