// What the bench's pages find in their window, and leave there for scripts/bench, as the types' checker needs it told.

declare function createLegacygl(given: object): Promise<any>; // Emscripten's factories
declare function createEmscripten(given: object): Promise<any>;
declare function createReading(given: object): Promise<any>;

interface Window {
  run(name: string, frames: number, draws: boolean): Promise<void>;
  pictures(): Promise<Record<string, number[]>>;
  reading(files: [string, string][], rounds: number): Promise<Record<string, number[]>>;
}
