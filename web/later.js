// Modules that are fetched when they are first needed; scripts/assemble-page.mjs puts their addresses into the page.

/** Imports web/later/NAME.js. Throws an Error with a sentence when it does not arrive. */
export async function importLater(name) {
  const { later } = JSON.parse(document.getElementById("tanklab-files").textContent);
  try {
    return await import(new URL(later[name], document.baseURI).href);
  } catch {
    throw new Error(`The file ${name}.js, which the page needs for this, did not arrive. Check your connection and try again.`);
  }
}
