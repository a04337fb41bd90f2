/** Colours and light of the stage in one theme. Sky colours are sRGB as they appear on screen; lights go through tone mapping. */
export interface StageLook {
  readonly horizon: string;
  readonly middle: string;
  readonly zenith: string;
  /** Haze around the sun, added. */
  readonly haze: string;
  readonly cloud: string;
  readonly cloudCover: number;
  readonly sun: string;
  readonly sunIntensity: number;
  readonly skyLight: string;
  readonly groundLight: string;
  readonly skyIntensity: number;
  readonly grassLight: string;
  readonly grassDark: string;
  readonly earth: string;
  readonly exposure: number;
}

/** Late morning with a warm sun, in the colours of the page's paper; and the same meadow at dusk on the dark ground. */
export const STAGE_LOOKS: Readonly<Record<'light' | 'dark', StageLook>> = {
  light: {
    horizon: '#eef1ea',
    middle: '#cfe0ea',
    zenith: '#8fb6d8',
    haze: '#5a4a2a',
    cloud: '#fbfaf6',
    cloudCover: 0.75,
    sun: '#fff0d6',
    sunIntensity: 3.8,
    skyLight: '#cfe4ff',
    groundLight: '#97ad84',
    skyIntensity: 2.15,
    grassLight: '#8c9c52',
    grassDark: '#41592f',
    earth: '#8a7458',
    exposure: 1,
  },
  dark: {
    horizon: '#27353d',
    middle: '#1b262e',
    zenith: '#10151a',
    haze: '#3a2c1c',
    cloud: '#33424d',
    cloudCover: 0.5,
    sun: '#ffd9a8',
    sunIntensity: 3.4,
    skyLight: '#8fb2d8',
    groundLight: '#3c4232',
    skyIntensity: 1.7,
    grassLight: '#5d6d44',
    grassDark: '#33452c',
    earth: '#544838',
    exposure: 1.2,
  },
};
