import { expect, it } from 'vitest';
import { ATTRIBUTES } from '../../src/element/attributes.ts';
import { editorLink } from '../../src/viewer/editor-link.ts';
import { readAddress, VIEWER_ATTRIBUTES } from '../../src/viewer/read-address.ts';

const attributesOf = (search: string, hash = '') => Object.fromEntries(readAddress(search, hash).attributes);

it('takes every attribute of the element by its name, from the query and from behind #', () => {
  for (const name of Object.keys(ATTRIBUTES)) expect(VIEWER_ATTRIBUTES.has(name), name).toBe(true);
  expect(attributesOf('?species=cherry&seed=3&wind-speed=6m%2Fs', '#season=spring')).toEqual({
    'camera-controls': '',
    species: 'cherry',
    seed: '3',
    'wind-speed': '6m/s',
    season: 'spring',
  });
});

it('lets the reader look around unless it is told not to', () => {
  expect(attributesOf('?camera-controls=off&paused=1')).toEqual({ paused: '' });
  expect(attributesOf('?paused=0')).toEqual({ 'camera-controls': '' });
});

it('tells a link of the editor from attributes, with which it shares keys', () => {
  const { attributes, link, faults } = readAddress(
    '?wind-direction=90deg',
    '#s=silver-birch&seed=7&t=2&season=autumn&wind=gale&cam=10,5,20,0,4,0',
  );
  expect(link).toBe('s=silver-birch&seed=7&t=2&season=autumn&wind=gale&cam=10%2C5%2C20%2C0%2C4%2C0');
  expect(Object.fromEntries(attributes)).toEqual({ 'camera-controls': '', 'wind-direction': '90deg' });
  expect(faults).toEqual([]);
  expect(readAddress('', '#z=abc&embed=1').link).toBe('z=abc');
  expect(readAddress('?species=cherry&season=spring', '').link).toBeNull();
});

it('says what nobody reads', () => {
  expect(readAddress('?speces=cherry', '').faults).toEqual([
    '"speces" is no attribute of wind-tree; was species meant?',
  ]);
});

it('lets nobody call where the list of origins has none that is one', () => {
  expect(readAddress('', '').origins).toEqual([]);
  expect(readAddress('?origin=https://a.example/x&origin=https://b.example', '').origins).toEqual([
    'https://a.example',
    'https://b.example',
  ]);
  expect(readAddress('?origin=a.example', '').origins).toEqual(['null']);
});

it('leads to the same tree in the editor', () => {
  const { attributes } = readAddress('?species=cherry&seed=3&wind=https://x.example/w.json&environment=golden', '');
  expect(editorLink(attributes)).toBe('s=cherry&seed=3&stage=golden');
});
