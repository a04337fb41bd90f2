import { describe, expect, test } from 'vitest';
import { ANGLE, numberBy, ORBIT, oneOf, SECONDS, SPEED, SWITCH } from '../../src/element/attribute-rules.ts';
import { ATTRIBUTES, type AttributeName, attributeFault, readProperty } from '../../src/element/attributes.ts';

describe('attributes with units', () => {
  test.each([
    ['6m/s', 6],
    [' 6 m/s ', 6],
    ['20km/h', 20 / 3.6],
    ['0', 0],
    ['.5M/S', 0.5],
    ['6', undefined],
    ['6mph', undefined],
    ['-1m/s', undefined],
    ['61m/s', undefined],
    ['6m/s east', undefined],
    ['', undefined],
    ['1e999m/s', undefined],
  ])('wind-speed "%s" is %s metres a second', (text, value) => {
    if (value === undefined) expect(SPEED.read(text)).toBeUndefined();
    else expect(SPEED.read(text)).toBeCloseTo(value, 12);
  });

  test.each([
    ['240deg', 240],
    ['0.5turn', 180],
    ['1rad', 180 / Math.PI],
    ['-90°', -90],
    ['240', undefined],
    ['west', undefined],
  ])('wind-direction "%s" is %s degrees', (text, value) => {
    if (value === undefined) expect(ANGLE.read(text)).toBeUndefined();
    else expect(ANGLE.read(text)).toBeCloseTo(value, 12);
  });

  test.each([
    ['3s', 3],
    ['3', 3],
    ['500ms', 0.5],
    ['2min', 120],
    ['-3s', undefined],
    ['3h', undefined],
  ])('time "%s" is %s seconds', (text, value) => expect(SECONDS.read(text)).toBe(value));

  test.each([
    ['30deg 75deg auto', { azimuth: 30, polar: 75, distance: null }],
    ['auto auto 12m', { azimuth: null, polar: null, distance: 12 }],
    ['0.25turn  AUTO\n250cm', { azimuth: 90, polar: null, distance: 2.5 }],
    ['30deg 75deg', undefined],
    ['30deg 181deg auto', undefined],
    ['30deg 75deg 12', undefined],
    ['30deg 75deg 0m', undefined],
  ])('camera-orbit "%s"', (text, value) => expect(ORBIT.read(text)).toEqual(value));

  test('words, switches and bare numbers', () => {
    expect(oneOf(['auto', 'low']).read(' Low ')).toBe('low');
    expect(oneOf(['auto', 'low']).read('lowest')).toBeUndefined();
    expect(['', 'on', 'off', 'true', 'no'].map(SWITCH.read)).toEqual([true, true, false, true, undefined]);
    const seed = numberBy({ label: '', unit: '', min: 0, max: 10, decimals: 0 });
    expect(['7', '7.5', '-1', '11', 'x'].map(seed.read)).toEqual([7, undefined, undefined, undefined, undefined]);
  });

  test('what is written is read back as it was', () => {
    const values: [AttributeName, unknown][] = [
      ['wind-speed', 20 / 3.6],
      ['wind-direction', 4.2],
      ['time', 3.5],
      ['camera-orbit', { azimuth: 30, polar: null, distance: 12.25 }],
      ['seed', 4294967295],
      ['gust', 0.35],
      ['shadow', false],
      ['playback-rate', 0.5],
    ];
    for (const [name, value] of values) {
      const { rule } = ATTRIBUTES[name] as (typeof ATTRIBUTES)['species'];
      const again = rule.read(rule.write(value as never));
      if (typeof value === 'number') expect(again).toBeCloseTo(value, 6);
      else expect(again).toEqual(value);
    }
  });

  test('the usual value of every attribute is one that it may have', () => {
    for (const name of Object.keys(ATTRIBUTES) as AttributeName[]) {
      const { usual } = ATTRIBUTES[name];
      expect(readProperty(name, usual), name).toEqual(usual);
      expect(readProperty(name, null), name).toBe(usual);
    }
  });

  test('properties take values and texts, and refuse what is neither', () => {
    expect(readProperty('wind-speed', 6)).toBe(6);
    expect(readProperty('wind-speed', '6m/s')).toBe(6);
    for (const bad of [-1, Number.NaN, 'fast', {}, true])
      expect(readProperty('wind-speed', bad), String(bad)).toBeUndefined();
    expect(readProperty('camera-orbit', { azimuth: 0, polar: 75, distance: null })).toEqual({
      azimuth: 0,
      polar: 75,
      distance: null,
    });
    for (const bad of [{}, 7, { azimuth: 'north', polar: 1, distance: 1 }])
      expect(readProperty('camera-orbit', bad)).toBeUndefined();
  });

  test('a fault names the attribute, what stands there, cut short, and what may', () => {
    expect(attributeFault('wind-speed', '6 mph')).toBe(
      'wind-speed="6 mph" is not allowed: it may be a speed from 0 to 60 m/s with its unit: "6m/s" or "20km/h".',
    );
    expect(attributeFault('detail', 'x'.repeat(500)).length).toBeLessThan(150);
  });
});
