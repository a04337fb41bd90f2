/** The colours of the page's tokens that plots are drawn with, as they are in the theme of the moment. */
export interface PlotColours {
  readonly paper: string;
  readonly ink: string;
  readonly soft: string;
  readonly hairline: string;
  readonly force: string;
  readonly forceSoft: string;
  readonly answer: string;
  readonly velocity: string;
  readonly reference: string;
  readonly wrong: string;
}

export function plotColours(): PlotColours {
  const style = getComputedStyle(document.documentElement);
  const token = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  return {
    paper: token('paper'),
    ink: token('ink'),
    soft: token('ink-soft'),
    hairline: token('hairline'),
    force: token('force'),
    forceSoft: token('force-soft'),
    answer: token('answer'),
    velocity: token('velocity'),
    reference: token('reference'),
    wrong: token('wrong'),
  };
}

/** Calls back when the theme of the page changes; returns how to stop. */
export function onTheme(listener: () => void): () => void {
  const observer = new MutationObserver(listener);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
  return () => observer.disconnect();
}
