import type { FigureSpec, FigureStage, Values } from './figure.ts';

/** Writes readouts into every `<output data-live="FIGURE.READOUT">` of the page. */
function write(figure: string, places: readonly HTMLElement[], readouts: ReturnType<FigureStage['draw']>): void {
  for (const place of places) {
    const text = String(readouts[(place.dataset.live ?? '').slice(figure.length + 1)] ?? '');
    if (text && place.textContent !== text) place.textContent = text;
  }
}

/** The same figure, whose readouts stand in the running text, too: in every `<output data-live="FIGURE.READOUT">`. */
export function inText(spec: FigureSpec): FigureSpec {
  return {
    ...spec,
    stage: (host) => {
      const stage = spec.stage(host);
      const places = [...document.querySelectorAll<HTMLElement>(`output[data-live^="${spec.id}."]`)];
      const draw = stage.draw.bind(stage);
      return Object.assign(stage, {
        draw: (values: Values, time: number) => {
          const readouts = draw(values, time);
          write(spec.id, places, readouts);
          return readouts;
        },
      });
    },
  };
}
