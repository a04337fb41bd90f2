import { type Fault, faultText } from '../core/file/fault.ts';
import { parseSpecies } from '../core/species/parse.ts';
import type { Species } from '../core/species/species.ts';
import { loadWind as windOfText } from '../core/wind/load-wind.ts';
import type { Wind } from '../core/wind/wind.ts';

/** Why a file was not loaded: it did not come ('network'), or what stands in it is wrong ('invalid': `faults` says where). */
export class LoadError extends Error {
  override readonly name = 'LoadError';
  readonly type: 'network' | 'invalid';
  /** Its full address. */
  readonly url: string;
  readonly faults: readonly Fault[];

  constructor(url: string | URL, why: string | readonly Fault[]) {
    const invalid = typeof why !== 'string';
    super(`${url}: ${invalid ? why.map(faultText).join(' ') : why}`);
    this.type = invalid ? 'invalid' : 'network';
    this.url = String(url);
    this.faults = invalid ? why : [];
  }
}

export interface LoadOptions {
  /** Aborting it rejects with the signal's reason. */
  readonly signal?: AbortSignal;
}

const absolute = (url: string | URL): URL => new URL(url, globalThis.document?.baseURI);

/** The text of a file; a relative address is relative to the document. Throws LoadError. */
export async function loadText(url: string | URL, { signal }: LoadOptions = {}): Promise<string> {
  const address = absolute(url);
  const response = await fetch(address, signal ? { signal } : {}).catch((error: unknown) => {
    if (signal?.aborted) throw signal.reason;
    throw new LoadError(address, error instanceof Error ? error.message : String(error));
  });
  if (!response.ok) throw new LoadError(address, `${response.status} ${response.statusText}`.trim());
  return response.text();
}

/** A species from its JSON file, older versions included. Throws LoadError. */
export async function loadSpecies(url: string | URL, options: LoadOptions = {}): Promise<Species> {
  const { species, faults } = parseSpecies(await loadText(url, options));
  if (species) return species;
  throw new LoadError(absolute(url), faults);
}

/** A wind from its JSON file, and from the CSV file beside it where it names one. Throws LoadError. */
export async function loadWind(url: string | URL, options: LoadOptions = {}): Promise<Wind> {
  const address = absolute(url);
  const beside = (file: string): Promise<string> => loadText(new URL(file, address), options);
  const { wind, faults } = await windOfText(await loadText(address, options), beside);
  if (wind) return wind;
  throw new LoadError(address, faults);
}
