import { expect, it } from 'vitest';
import { linkFaultLines } from '../../src/editor/link-faults.ts';

const fault = (key: string, found: string) => ({ key, found, allowed: 'nothing of this name' });

it('a megabyte of nonsense in a link makes a short message', () => {
  const [line] = linkFaultLines([fault('k'.repeat(1e6), '%'.repeat(1e6))]);
  expect(line).toBe(`${'k'.repeat(40)}…: found “${'%'.repeat(80)}…”; allowed: nothing of this name.`);
});

it('thousands of wrong keys make a few lines and their number', () => {
  const lines = linkFaultLines(Array.from({ length: 5000 }, (_, i) => fault(`k${i}`, '<b>')));
  expect(lines).toHaveLength(9);
  expect(lines[0]).toBe('k0: found “<b>”; allowed: nothing of this name.');
  expect(lines[8]).toBe('4992 more like these.');
});
