/** What is said of a stem that was clicked in the scene. */
export const stemWords = {
  one: ['Trunk', 'Limb', 'Branch', 'Twig'] as readonly string[],
  name: (level: number, number: number, count: number, clone: boolean) => {
    const kind = ['Trunk', 'Limb', 'Branch', 'Twig'][level] ?? `Stem of level ${level}`;
    return `${kind}${count > 1 ? ` ${number} of ${count}` : ''}${clone ? ', a split' : ''}`;
  },
  card: 'Selected stem',
  length: 'Length',
  radius: 'Radius',
  downAngle: 'Down angle',
  lean: 'Lean',
  place: 'Along its parent',
  placeValue: (percent: number) => `${percent} %`,
  probe: 'Put the probe here',
  close: 'Let go of this stem',
  edit: (level: string) => `Shape all ${level.toLowerCase()}`,
  editTrunk: 'Shape the trunk',
  handles: 'Its handles drag length, down angle and curve of all stems of this level.',
  none: 'No stem is selected',
} as const;
