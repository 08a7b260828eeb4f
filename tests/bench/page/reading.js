// What scripts/bench asks of reading.html: reading(rounds), the time to read the tank's OBJ files here and by
// three.js, whose OBJLoader most pages use.
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";

/** Gives { name: milliseconds of each round }; the readers take turns. files: [[name, text]]. */
window.reading = async (files, rounds) => {
  const module = await createReading({ canvas: document.getElementById("reading") });
  if (!module.ccall("reading_open", "number", ["string"], ["#reading"])) {
    throw new Error("the canvas cannot open");
  }
  const contents = files.map(([, text]) => new TextEncoder().encode(text));
  contents.forEach((bytes, index) => {
    const place = module.ccall("reading_file", "number", ["string", "number"], [files[index][0], bytes.length]);
    if (place === 0) {
      throw new Error(`${files[index][0]} is no file of the tank`);
    }
    module.HEAPU8.set(bytes, place);
  });

  const readers = {
    ours: () => module._reading_run(0),
    ours_with_links: () => module._reading_run(1),
    three: () => {
      let triangles = 0;
      for (const bytes of contents) {
        new OBJLoader().parse(new TextDecoder().decode(bytes)).traverse(({ geometry }) => {
          if (geometry) {
            triangles += geometry.getAttribute("position").count / 3;
          }
        });
      }
      return triangles;
    },
  };
  /** @type {Record<string, number[]>} */
  const times = Object.fromEntries(Object.keys(readers).map((name) => [name, []]));
  const WARM_UP = 3;
  for (let round = 0; round < WARM_UP + rounds; ++round) {
    const counts = Object.entries(readers).map(([name, read]) => {
      const start = performance.now();
      const count = read();
      if (round >= WARM_UP) {
        times[name].push(performance.now() - start);
      }
      return count;
    });
    if (counts.some((count) => count === 0 || count !== counts[0])) {
      throw new Error(`the readers find ${counts} triangles`);
    }
  }
  return times;
};
