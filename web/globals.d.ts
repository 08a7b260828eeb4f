// What the page's modules find besides the browser's own, as the types' checker needs it told.

/** Emscripten's factory of the program; see scripts/cmake/WebPage.cmake. */
declare module "tanklab" {
  export interface TanklabModule {
    ccall(name: string, returns: string | null, types: string[], values: unknown[]): any;
    HEAPU8: Uint8Array;
    _malloc(bytes: number): number;
    _free(address: number): void;
  }
  export default function createTanklab(given: object): Promise<TanklabModule>;
}

interface Window {
  tanklab: object;
}

interface Navigator {
  keyboard?: { getLayoutMap?(): Promise<Map<string, string>> };
}
