import { html, nothing, type TemplateResult } from 'lit';
import { faultText } from '../core/file/fault.ts';
import { oneLine } from '../core/file/one-line.ts';
import { LONGEST_NAME } from '../core/forest/forest-numbers.ts';
import { LONGEST_MAP, readDensityMap, readHeightMap } from '../core/forest/grey-map.ts';
import { slider } from './slider.ts';
import type { Store } from './store.ts';
import { words } from './words.ts';

/** Takes a file as a height map or a density map; a fault is shown, and the forest stays. */
export async function takeMap(store: Store, kind: 'height' | 'density', file: File | undefined): Promise<void> {
  if (!file) return;
  // No more is read than may be in a map: the reader says what is wrong with the rest.
  const bytes = await file
    .slice(0, LONGEST_MAP + 1)
    .arrayBuffer()
    .catch(() => null);
  const title = kind === 'height' ? words.heightMap : words.densityMap;
  const refuse = (line: string): void => store.set({ notice: { kind: 'error', title, lines: [line] } });
  // A folder that was dropped is no file that can be read.
  if (!bytes) return refuse(words.unreadable(oneLine(file.name)));
  const { map, fault } = (kind === 'height' ? readHeightMap : readDensityMap)(new Uint8Array(bytes), file.name);
  if (fault) return refuse(faultText(fault));
  const name = file.name.slice(0, LONGEST_NAME);
  if (kind === 'height') store.setHeightMap(map, name);
  else store.setDensityMap(map, name);
}

/** The shape of the ground, and where it is bare. */
export function groundFields(store: Store): TemplateResult {
  const { terrain, density } = store.state.document;
  const heightOf = (key: 'relief' | 'rise', label: string, max: number): TemplateResult | typeof nothing =>
    terrain.kind === 'hills'
      ? slider({
          label,
          min: 0,
          max,
          step: 1,
          value: terrain[key],
          text: words.metres(terrain[key]),
          onInput: (value) => store.edit({ terrain: { ...terrain, [key]: value } }),
        })
      : nothing;
  const greyOf = (key: 'black' | 'white', label: string): TemplateResult | typeof nothing =>
    terrain.kind === 'map'
      ? slider({
          label,
          min: -100,
          max: 400,
          step: 1,
          value: terrain[key],
          text: words.metres(terrain[key]),
          onInput: (value) => store.edit({ terrain: { ...terrain, [key]: value } }),
        })
      : nothing;
  return html`
    ${heightOf('relief', words.relief, 150)} ${heightOf('rise', words.rise, 250)}
    ${greyOf('black', words.black)} ${greyOf('white', words.white)}
    ${mapField(store, 'height', terrain.kind === 'map' ? terrain.name : null)}
    ${
      density.kind === 'clearings'
        ? slider({
            label: words.bare,
            min: 0,
            max: 0.9,
            step: 0.01,
            value: density.bare,
            text: words.percent(density.bare),
            onInput: (bare) => store.edit({ density: { ...density, bare } }),
          })
        : nothing
    }
    ${mapField(store, 'density', density.kind === 'map' ? density.name : null)}`;
}

/** A picture to choose or to drop. */
function mapField(store: Store, kind: 'height' | 'density', used: string | null): TemplateResult {
  const label = kind === 'height' ? words.heightMap : words.densityMap;
  const there = kind === 'height' ? store.state.heightMap : store.state.densityMap;
  const change = (event: Event): void => {
    const input = event.target as HTMLInputElement;
    void takeMap(store, kind, input.files?.[0]);
    input.value = '';
  };
  const takeOut = (): void => (kind === 'height' ? store.setHeightMap(null, '') : store.setDensityMap(null, ''));
  return html`<div class="map" data-map=${kind}>
    <label class="button">
      <span class="label">${label}</span>
      <span class="soft">${used === null ? words.choose : there ? words.used(used) : words.absent(used)}</span>
      <input type="file" accept="image/png,.png" aria-label=${label} @change=${change}>
    </label>
    ${used === null ? nothing : html`<button class="quiet own" type="button" title=${words.takeOut(label)} aria-label=${words.takeOut(label)} @click=${takeOut}>×</button>`}
  </div>`;
}
