import { html, nothing, type TemplateResult } from 'lit';
import { WIND_CHANNELS } from '../../core/io/channels.ts';
import type { Capture, ChannelView } from '../../view/picture/picture.ts';
import { choice } from '../ui/choice.ts';
import { Part } from '../ui/panel.ts';
import { exportWords } from '../words/export.ts';

/** Pixels of the picture, for twice the density of the page. */
const SIZE = { width: 480, height: 600 };

/** The tree coloured by one of the numbers that an engine gets; the tree behind the dialog is coloured likewise as long as this is seen. */
class ChannelPreview extends Part {
  private channel: ChannelView | null = 'sway';
  private drawn: { readonly channel: ChannelView; readonly canvas: Capture['canvas'] } | null = null;
  private drawing = false;

  override connectedCallback(): void {
    super.connectedCallback();
    void this.look(this.channel);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.editor.actions.setChannel(null);
    this.drawn = null;
  }

  protected override render(): TemplateResult {
    const words = exportWords.channels;
    const { channel, drawn } = this;
    const names = [
      ...WIND_CHANNELS.map((c) => ({ value: c, label: words.names[c] })),
      { value: 'off', label: words.off },
    ];
    return html`<div>${choice({
      name: 'channel',
      legend: words.legend,
      value: channel ?? 'off',
      options: names,
      onChoose: (value) => void this.look(value === 'off' ? null : (value as ChannelView)),
    })}
    <p class="option-help" role="status">${channel ? words.about[channel] : nothing}</p></div>
    ${
      channel === null
        ? nothing
        : html`<div class="channel-picture" role="img" aria-label=${words.picture} data-channel=${drawn?.channel ?? nothing}>
      ${drawn ? drawn.canvas : html`<span>${words.drawing}</span>`}</div>`
    }`;
  }

  private async look(channel: ChannelView | null): Promise<void> {
    this.channel = channel;
    this.editor.actions.setChannel(channel);
    this.requestUpdate();
    if (this.drawing) return;
    this.drawing = true;
    try {
      // The newest choice is drawn last, whatever was chosen meanwhile.
      for (let next = this.channel; this.isConnected && next && next !== this.drawn?.channel; next = this.channel) {
        const capture = await this.editor.picture.openCapture({ ...SIZE, transparent: true });
        try {
          await capture.draw(this.editor.actions.time());
        } finally {
          capture.close();
        }
        if (next === this.channel) this.drawn = { channel: next, canvas: capture.canvas };
        this.requestUpdate();
      }
    } catch {
      // Without the small picture the words and the tree behind still say what it is.
      this.channel = null;
      this.requestUpdate();
    } finally {
      this.drawing = false;
    }
  }
}

customElements.define('wg-channel-preview', ChannelPreview);
