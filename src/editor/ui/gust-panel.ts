import { html, type TemplateResult } from 'lit';
import { shownGustNumber } from '../../core/link/waves.ts';
import { GUST_NUMBERS } from '../../core/link/wind-numbers.ts';
import { forceOfSpeed, speedOfForce } from '../../core/wind/speed.ts';
import { type Gust, MOST_GUSTS } from '../../core/wind/wind.ts';
import { withKeys } from '../shortcuts.ts';
import { gustWords } from '../words/wind.ts';
import { dial } from './dial.ts';
import { icon } from './icons.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';

const DIRECTION = GUST_NUMBERS.find((n) => n.key === 'direction')!;
const capital = (text: string): string => text[0]!.toUpperCase() + text.slice(1);

/** The gusts of the wind: throw one, change it, take it away. */
class GustPanel extends Part {
  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { gusts } = actions.edited().wind;
    const { throwing } = this.session;
    return html`<p class="soft">${gustWords.about}</p>
      <div class="buttons">
        <button type="button" class="quiet" title=${withKeys('gust', gustWords.throwTitle)} @click=${() => actions.throwGust()}>${icon('gust')}<span>${gustWords.throw}</span></button>
        <button type="button" class="quiet" aria-pressed=${throwing} title=${withKeys('aim', gustWords.aimTitle)}
          @click=${() => actions.setThrowing(!throwing)}>${icon('aim')}<span>${throwing ? gustWords.stopAiming : gustWords.aim}</span></button>
      </div>
      <ul class="gusts">${gusts.map((gust, i) => this.row(gust, i))}</ul>
      ${gusts.length > 1 ? html`<button type="button" class="text" @click=${() => actions.removeGusts()}>${gustWords.removeAll}</button>` : ''}
      ${gusts.length >= MOST_GUSTS ? html`<p class="soft">${gustWords.most}</p>` : ''}`;
  }

  private row(gust: Gust, index: number): TemplateResult {
    const { actions } = this.editor;
    const open = this.session.gust === index;
    const name = gustWords.gust(index + 1);
    const id = `gust-${index + 1}`;
    return html`<li class="gust" ?data-open=${open}>
      <div class="gust-head">
        <button type="button" class="gust-open" aria-expanded=${open} aria-controls="${id}-more"
          @click=${() => actions.chooseGust(open ? null : index)}>${icon(open ? 'up' : 'down')}<span>${name}</span>
          <span class="soft">${gust.start.toFixed(1)} s, ${speedOfForce(gust.amplitude).toFixed(1)} m/s</span></button>
        ${dial({
          id: `${id}-dial`,
          name: gustWords.dial(name),
          value: Math.round(shownGustNumber(gust, DIRECTION)),
          onInput: (value) => actions.setGustNumber(index, DIRECTION, value),
        })}
        <button type="button" class="round" aria-label=${gustWords.removeGust(index + 1)} title=${gustWords.remove} @click=${() => actions.removeGust(index)}>${icon('bin')}</button>
      </div>
      <div id="${id}-more" ?hidden=${!open}>${
        open
          ? GUST_NUMBERS.map((n) =>
              numberField({
                id: `${id}-${n.key}`,
                label: capital(n.label),
                name: gustWords.of(name, n.label),
                unit: n.unit,
                value: shownGustNumber(gust, n),
                min: n.min,
                max: n.max,
                slider: n.slider,
                step: n.slider.step,
                decimals: n.decimals,
                turns: n.wraps ?? false,
                help: n.help,
                ...(n.key === 'amplitude'
                  ? { also: { unit: 'm/s', decimals: 1, of: speedOfForce, back: forceOfSpeed } }
                  : {}),
                onInput: (value) => actions.setGustNumber(index, n, value),
              }),
            )
          : ''
      }</div>
    </li>`;
  }
}

customElements.define('wg-gusts', GustPanel);
