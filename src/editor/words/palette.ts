/** The palette: everything that can be done or set, by its name. */
export const paletteWords = {
  label: 'Find a command, a setting, a species or a wind',
  placeholder: 'Type what you want to do or change',
  results: 'Found',
  kinds: { command: '', setting: 'Setting', species: 'Species', wind: 'Wind', levels: 'Tree' },
  stems: ['of the trunk', 'of limbs', 'of branches', 'of twigs'],
  count: (count: number): string => (count === 0 ? 'Nothing found' : `${count} found`),
  none: 'Nothing is called so. Try one word of it, such as “angle”, “gust” or “willow”.',
  more: (count: number): string => `${count} more: type on to find them`,
  changeTo: (name: string): string => `Grow ${name}`,
  blow: (name: string): string => `Let ${name} blow`,
} as const;
