/** Season, stage, light and quality; photo mode. */
export const sceneWords = {
  season: 'Season',
  seasons: { spring: 'Spring', summer: 'Summer', autumn: 'Autumn', winter: 'Winter' },
  stage: 'Stage',
  stages: {
    meadow: ['Meadow', 'A meadow in the morning, at dusk in dark colours'],
    park: ['Park', 'A mown lawn under a closed sky: soft light'],
    golden: ['Golden hour', 'Low sun, long shadows, haze'],
    studio: ['Studio', 'A grey room without corners'],
  },
  hour: 'Time of day',
  hourHelp: 'Where the sun stands, on a day in June',
  hourInStudio: 'Where the lamp hangs: each hour takes it a step around the tree',
  ofStage: 'As the stage has it',
  quality: 'Quality',
  qualities: { auto: 'Automatic', low: 'Low', medium: 'Medium', high: 'High' },
  qualityNow: (level: 'low' | 'medium' | 'high'): string =>
    ({ low: 'Now low: this machine is slow', medium: 'Now medium', high: 'Now high' })[level],
  photo: 'Photo mode',
} as const;

export const photoWords = {
  title: 'Photo mode',
  aspect: 'Frame',
  aspects: { free: 'Window', '1:1': '1 : 1', '4:5': '4 : 5', '16:9': '16 : 9', '9:16': '9 : 16' },
  exposure: 'Exposure',
  exposureHelp: 'One step more lets in twice the light',
  lens: 'Lens',
  lensHelp: 'Focal length, as on 35-mm film: short shows more around the tree, long brings it near',
  keepsSize: 'Keep size',
  keepsSizeHelp: 'Step back for a long lens and nearer for a short one, so that the tree stays as large',
  thirds: 'Thirds',
  thirdsHelp: 'Lines at thirds of the frame; they are not in the picture',
  reset: 'A double click, or an emptied box, goes back',
  shutter: 'Take the picture',
  taking: 'Taking the picture…',
  taken: 'The picture was taken.',
  failed: 'The picture could not be taken',
  leave: 'Leave photo mode',
} as const;
