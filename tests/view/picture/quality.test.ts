import { describe, expect, it } from 'vitest';
import { QualityMeter } from '../../../src/view/picture/quality.ts';

const run = (meter: QualityMeter, frames: number, milliseconds: number): string => {
  for (let i = 0; i < frames; i++) meter.frame(milliseconds);
  return meter.level;
};

describe('quality by measuring', () => {
  it('gives way after sixty slow frames, not after a few, nor where most are quick enough', () => {
    const meter = new QualityMeter();
    expect(run(meter, 59, 80)).toBe('medium');
    meter.restart();
    for (let i = 0; i < 60; i++) meter.frame(i % 3 === 0 ? 400 : 30);
    expect(meter.level).toBe('medium');
    expect(run(meter, 60, 41)).toBe('low');
  });

  it('takes back only after many quick frames in a row, and later each time', () => {
    const meter = new QualityMeter();
    run(meter, 60, 50);
    expect(run(meter, 300, 16)).toBe('low');
    run(meter, 60, 25);
    expect(run(meter, 300, 16)).toBe('low');
    expect(run(meter, 60, 16)).toBe('medium');
    run(meter, 60, 50);
    expect(run(meter, 660, 16)).toBe('low');
    expect(run(meter, 60, 16)).toBe('medium');
  });
});
