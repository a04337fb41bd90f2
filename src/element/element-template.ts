import { html, nothing, svg, type TemplateResult } from 'lit';
import { elementWords } from './words.ts';

/** What is to be seen of an element at the moment. */
export interface ElementParts {
  /** What the picture shows; empty: it is decoration. */
  readonly label: string;
  /** The camera can be turned. */
  readonly turns: boolean;
  /** Address of the poster's picture, '' for none; null: the poster is gone. */
  readonly poster: string | null;
  /** The poster waits to be pressed. */
  readonly asks: boolean;
  /** 0..1, null: nothing is on its way. */
  readonly progress: number | null;
  /** The browser cannot draw it. */
  readonly unable: boolean;
  readonly message: string;
  readonly status: string;
  readonly controls: boolean;
  readonly paused: boolean;
  readonly onToggle: () => void;
  readonly onPoster: () => void;
}

const PLAY = svg`<path d="M4 2.5v11l9.5-5.5z"/>`;
const PAUSE = svg`<path d="M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z"/>`;

/** The shadow tree. It has no style attributes and no handlers in its markup: strict pages allow neither. */
export function elementTemplate(parts: ElementParts): TemplateResult {
  const { label, turns, poster, asks, progress, unable, message, status, controls, paused } = parts;
  const decoration = label === '' && !turns;
  return html`
    <canvas
      part="canvas"
      class=${turns ? 'turns' : ''}
      width="1"
      height="1"
      role=${decoration ? 'presentation' : 'img'}
      aria-label=${decoration ? nothing : label || elementWords.alt(null, null)}
      aria-describedby=${turns ? 'keys' : nothing}
      tabindex=${turns && poster === null ? 0 : nothing}
    ></canvas>
    <div class="ring"></div>
    <slot></slot>
    <div part="poster" class=${poster === null ? 'poster gone' : 'poster'} @click=${parts.onPoster}>
      <slot name="poster">${poster ? html`<img src=${poster} alt="" />` : nothing}</slot>
      ${
        asks
          ? html`<button part="button" class="show" type="button" @click=${parts.onPoster}>
              <svg viewBox="0 0 16 16" aria-hidden="true">${PLAY}</svg>&nbsp;${elementWords.show}
            </button>`
          : nothing
      }
    </div>
    ${unable ? html`<div class="fallback"><slot name="fallback"></slot></div>` : nothing}
    ${
      progress === null
        ? nothing
        : html`<slot name="progress"
            ><progress part="progress" max="1" .value=${progress} aria-label=${elementWords.progress}></progress
          ></slot>`
    }
    ${message ? html`<p part="message" class="message">${message}</p>` : nothing}
    <div part="controls" class="controls" ?hidden=${!controls}>
      <slot name="controls">
        <button
          part="button"
          type="button"
          aria-label=${paused ? elementWords.play : elementWords.pause}
          @click=${parts.onToggle}
        >
          <svg viewBox="0 0 16 16" aria-hidden="true">${paused ? PLAY : PAUSE}</svg>
        </button>
      </slot>
    </div>
    <p id="keys" class="said" ?hidden=${!turns}>${elementWords.keys}</p>
    <p part="status" class="said" role="status">${status}</p>
  `;
}
