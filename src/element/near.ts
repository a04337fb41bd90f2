/** How near an element is to the window. */
export interface Nearness {
  /** Some of it is in the window. */
  readonly visible: boolean;
  /** Within half a window of it: time to load. */
  readonly near: boolean;
  /** Beyond three windows: what it has on the GPU may go. */
  readonly far: boolean;
}

type Told = (how: Nearness) => void;

/** Room around the window, in parts of it, within which an element counts. */
const MARGINS = { visible: '0px', near: '50%', far: '300%' } as const;
type Ring = keyof typeof MARGINS;

interface Watched {
  readonly tell: Told;
  /** In which rings it is. */
  readonly rings: Record<Ring, boolean>;
}

const watched = new Map<Element, Watched>();
let observers: readonly IntersectionObserver[] | null = null;

function observe(ring: Ring): IntersectionObserver {
  return new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const found = watched.get(target);
        if (!found || found.rings[ring] === isIntersecting) continue;
        found.rings[ring] = isIntersecting;
        const { visible, near, far } = found.rings;
        found.tell({ visible, near: near || visible, far: !far });
      }
    },
    { rootMargin: MARGINS[ring] },
  );
}

/** Tells of every change until the returned function is called; three observers serve all elements. */
export function watchNearness(element: Element, tell: Told): () => void {
  observers ??= (Object.keys(MARGINS) as Ring[]).map(observe);
  watched.set(element, { tell, rings: { visible: false, near: false, far: false } });
  for (const observer of observers) observer.observe(element);
  return () => {
    watched.delete(element);
    for (const observer of observers ?? []) observer.unobserve(element);
  };
}

/** How far the middle of an element is from that of the window, CSS pixels: the nearer is served first. */
export function distanceToMiddle(element: Element): number {
  const { left, top, width, height } = element.getBoundingClientRect();
  return Math.hypot(left + width / 2 - innerWidth / 2, top + height / 2 - innerHeight / 2);
}
