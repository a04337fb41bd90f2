import { hashPacked } from '../../src/core/pack/hash-packed.ts';
import type { Species } from '../../src/core/species/species.ts';
import { growInWorker } from '../../src/worker/client.ts';

// Grows the species and the seed of the address in the worker and writes the hash of the packed arrays to #report.
const q = new URLSearchParams(location.search);
const species: Species = await (await fetch(`../../species/${q.get('species')}.json`)).json();
const { packed } = await growInWorker(species, Number(q.get('seed')), {});
(document.querySelector('#report') as HTMLElement).textContent = hashPacked(packed);
