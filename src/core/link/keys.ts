import { PLACES } from '../species/edits.ts';

const PLAIN = new Set(
  's own file called z seed t paused rate cam levels leaves view theme season stage hour arrows fronts handle probe blow compare'.split(
    ' ',
  ),
);
const OF_WIND =
  /^(b\.)?(wind|name|says|strength|waves|w[1-8]|g([1-9]|1[0-6])|profile|zero|rec|stiff|model|spring|levelhz|leveldamp|sway|p|m|pose|paper)$/;

/** Whether a key may stand in a link: in the query of an address there are others, which belong to somebody else. */
export const isLinkKey = (key: string): boolean => PLAIN.has(key) || OF_WIND.test(key) || PLACES.has(key);
