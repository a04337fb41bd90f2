import type { ChannelView } from '../view/picture/picture.ts';
import type { Doing } from './doing.ts';
import { savePreferences } from './preferences.ts';

/** What the export needs of the page. */
export function exportActions({ preferences, services, session }: Doing) {
  return {
    /** Gives the reader a file. */
    saveFile: (name: string, content: Blob): void => services.save(name, content),
    /** The whole address of what is shown now, its time too. */
    linkNow: (): string => services.addressOf(services.now()),
    /** Keeps what was chosen for one kind of file. */
    rememberExport(kind: string, choices: Readonly<Record<string, unknown>>): void {
      preferences.exports[kind] = { ...choices };
      savePreferences(preferences);
    },
    /** Colours the tree by a wind channel; null: as it looks. */
    setChannel(channel: ChannelView | null): void {
      if (session.getState().channel !== channel) session.setState({ channel });
    },
  };
}
