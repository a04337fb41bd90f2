// Speaks with a Windgrove viewer in a frame. Copy it beside your page; it needs nothing else. MIT licence.
//
//   import { viewerIn } from './viewer-client.js';
//   const tree = viewerIn(document.querySelector('iframe'));
//   tree.on('load', () => console.log('it stands'));
//   await tree.call('pause');
//   await tree.call('set', { season: 'autumn', 'wind-speed': '9m/s' });
//   const picture = await tree.call('toBlob', { width: 1200, height: 800 });

/**
 * @param {HTMLIFrameElement} frame whose page is viewer.html
 * @returns `call(name, ...args)` gives a promise of the answer, `on(event, listener)` hears events and gives back what stops it, `close()` ends both
 */
export function viewerIn(frame) {
  const { origin } = new URL(frame.src, document.baseURI);
  const waiting = new Map();
  const listeners = new Map();
  let calls = 0;
  // Until the frame's page runs, it hears nothing: the first calls wait for it.
  let hear;
  const heard = new Promise((done) => {
    hear = done;
  });

  const receive = (message) => {
    const { data, source } = message;
    if (source !== frame.contentWindow || message.origin !== origin || data?.windgrove !== 1) return;
    hear();
    if (data.event !== undefined) {
      for (const listener of listeners.get(data.event) ?? []) listener(data.detail);
      return;
    }
    const call = waiting.get(data.id);
    waiting.delete(data.id);
    if ('error' in data) call?.fail(new Error(data.error));
    else call?.done(data.result);
  };
  addEventListener('message', receive);
  // It may run already: it answers this one as soon as it hears it.
  const greet = () => frame.contentWindow?.postMessage({ windgrove: 1, id: 'hello', call: 'getState' }, '*');
  frame.addEventListener('load', greet);
  greet();

  return {
    async call(name, ...args) {
      await heard;
      return new Promise((done, fail) => {
        const id = ++calls;
        waiting.set(id, { done, fail });
        frame.contentWindow.postMessage({ windgrove: 1, id, call: name, args }, origin);
      });
    },
    on(event, listener) {
      const all = listeners.get(event) ?? new Set();
      listeners.set(event, all.add(listener));
      return () => all.delete(listener);
    },
    close() {
      removeEventListener('message', receive);
      frame.removeEventListener('load', greet);
      for (const { fail } of waiting.values()) fail(new Error('closed'));
    },
  };
}
