// Files that people drop on the page or choose.

const MOST_FILES = 10_000;
const DEEPEST_FOLDER = 12;

const tooMany = () =>
  new Error(
    `There are more than ${MOST_FILES.toLocaleString("en")} files. Drop the folder tankobjs itself, or tankLab.zip.`,
  );

async function walk(entry, path, depth, found) {
  if (entry.isFile) {
    if (found.length >= MOST_FILES) {
      throw tooMany();
    }
    found.push({ path, file: await new Promise((done, fail) => entry.file(done, fail)) });
    return;
  }
  if (depth > DEEPEST_FOLDER) {
    return;
  }
  const reader = entry.createReader();
  for (;;) {
    const some = await new Promise((done, fail) => reader.readEntries(done, fail)); // never all at once
    if (some.length === 0) {
      return;
    }
    for (const inner of some) {
      await walk(inner, `${path}/${inner.name}`, depth + 1, found);
    }
  }
}

/** Returns the files of a drop, those in folders with them: [{path, file}]. Call it within the event: the
    browser forgets what was dropped when it is over. */
export function droppedFiles(transfer) {
  const dropped = [...transfer.items]
    .filter((item) => item.kind === "file")
    .map((item) => ({ entry: item.webkitGetAsEntry?.(), file: item.getAsFile() }));
  return (async () => {
    const found = [];
    for (const { entry, file } of dropped) {
      try {
        if (entry) {
          await walk(entry, entry.name, 0, found);
        } else if (file) {
          found.push({ path: file.name, file });
        }
      } catch (error) {
        if (!(error instanceof DOMException)) {
          throw error;
        }
        throw new Error(
          `${entry.name} cannot be read: ${error.message.replace(/\.?$/, ".")} Drop it again, or choose it with the button.`,
        );
      }
    }
    return found;
  })();
}

/** Returns the files that were chosen: [{path, file}]. */
export function chosenFiles(list) {
  if (list.length > MOST_FILES) {
    throw tooMany();
  }
  return [...list].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
}
