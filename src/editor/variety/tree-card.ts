import { html, nothing, svg, type TemplateResult } from 'lit';
import { metresHigh } from '../../view/picture/frame-view.ts';
import { varietyWords } from '../words/variety.ts';
import type { Portrait, Size } from './portraits.ts';
import type { Frame } from './sketch.ts';

/** The tree at the scale of its frame, standing on a little shade: the portrait, or as long as that is not there its sketch. */
function standing({ url, sketch }: Portrait, frame: Frame, size: Size): TemplateResult {
  const h = metresHigh(frame, size);
  const w = (h * size.width) / size.height;
  const top = -(h + frame.height) / 2;
  return html`<svg class="tree-drawing" viewBox="${-w / 2} ${top} ${w} ${h}" aria-hidden="true">
    <ellipse cx="0" cy="0" rx=${frame.width * 0.3} ry=${(frame.width * FOOT) / 2}></ellipse>
    ${
      url
        ? svg`<image href=${url} x=${-w / 2} y=${top} width=${w} height=${h}></image>`
        : sketch?.strokes.map(({ width: thick, path }) => svg`<path d=${path} stroke-width=${thick}></path>`)
    }
  </svg>`;
}

/** Height of the shade under a tree as a part of the frame's width. */
const FOOT = 0.05;

/** The picture of a tree: its portrait, until that is there its sketch, until that is there an empty place. */
export function treePicture(portrait: Portrait, frame: Frame | null, size: Size): TemplateResult {
  const { url, sketch, failed } = portrait;
  if (failed !== null) return html`<span class="tree-picture failed" title=${failed}>${varietyWords.failed}</span>`;
  const room = frame ?? (sketch && { width: 2.2 * sketch.reach, height: 1.1 * sketch.height });
  return html`<span class="tree-picture" ?data-drawn=${url !== null}>${
    room ? standing(portrait, room, size) : nothing
  }</span>`;
}
