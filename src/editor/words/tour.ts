/** The tour: a title and a sentence or two at each stop. */
export const tourWords = {
  next: 'Next',
  back: 'Back',
  done: 'Done',
  close: 'End the tour',
  progress: '{{current}} of {{total}}',
  stops: {
    picture: {
      title: 'A tree in the wind',
      wide: 'Drag the picture to walk around it; scroll to come closer. The arrow on the ground is the wind: drag its end to turn it.',
      narrow:
        'Drag the picture to walk around it; pinch to come closer. The arrow on the ground is the wind: drag its end to turn it.',
    },
    grow: {
      title: 'What grows',
      wide: 'Choose a species and roll the dice for another tree of it. Below stands everything that shapes it, from the trunk to the leaves.',
      narrow:
        'Choose a species, roll the dice, shape the tree. Pull the sheet up by its handle; while you hold a slider it steps back from the tree.',
    },
    undo: {
      title: 'Nothing is lost',
      wide: 'Take back any step, or go to any earlier one. Your tree is kept on this machine by itself.',
      narrow: 'Take back any step. Your tree is kept on this machine by itself.',
    },
    wind: {
      title: 'What blows',
      wide: 'Begin with one of the winds, then mix your own: waves, gusts, and how the branches answer.',
      narrow: 'Begin with one of the winds, then mix your own: waves, gusts, and how the branches answer.',
    },
    time: {
      title: 'Time is yours',
      wide: 'Stop it, step it, slow it down or drag it along the ruler. The studio above it measures what the wind does.',
      narrow: 'Stop it, step it, slow it down or drag it along the ruler.',
    },
    take: {
      title: 'Take it with you',
      wide: 'Share a link, or export models with their wind, pictures and films. “Other trees” grows you a dozen to choose from.',
      narrow: 'Here you share a link, export models and films, and find all the rest.',
    },
    find: {
      title: 'Find anything by its name',
      wide: 'Every command and every setting of the tree is in here. The question mark shows all keys, and this tour again.',
      narrow: '',
    },
  },
} as const;
