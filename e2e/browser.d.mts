/** Flags under which pictures are the same bytes everywhere. */
export const browserArgs: string[];

/** The first browser that starts; throws with what was tried. */
export function findBrowser(): Promise<{ name: string; executablePath: string }>;
