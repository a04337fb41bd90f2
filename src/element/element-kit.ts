import type { Relief } from '../core/look/bark-relief.ts';
import type { LeafForm } from '../core/look/blade.ts';
import type { LeafGrain, LeafMesh } from '../core/look/leaf-mesh.ts';
import { hasMargin, type LeafSpec, leafSpecOf } from '../core/look/leaf-spec.ts';
import { type BarkImage, reliefImage } from '../core/look/relief-image.ts';
import type { BarkKind, OrganKind, Species } from '../core/species/species.ts';
import { hasOwn } from '../view/bark-look.ts';
import type { LineKit, PickKit, TreeKit } from '../view/tree-kit.ts';

type MakeRelief = (size: number) => Relief;

/** A file each, so that a page loads the bark and the leaf that it shows. */
const BARKS: Readonly<Record<BarkKind, () => Promise<MakeRelief>>> = {
  smooth: async () => (await import('../core/look/bark-smooth.ts')).smooth,
  furrowed: async () => (await import('../core/look/bark-furrowed.ts')).furrowed,
  plated: async () => (await import('../core/look/bark-plated.ts')).plated,
  peeling: async () => (await import('../core/look/bark-peeling.ts')).peeling,
  stringy: async () => (await import('../core/look/bark-stringy.ts')).stringy,
  palm: async () => (await import('../core/look/bark-palm.ts')).palm,
  ribbed: async () => (await import('../core/look/bark-ribbed.ts')).ribbed,
  noded: async () => (await import('../core/look/bark-noded.ts')).noded,
};

type Forms = Readonly<Record<number, LeafForm>>;

/** The forms that one of a shape stands among. */
async function formsWith(shape: number): Promise<Forms> {
  if (shape <= 4) return (await import('../core/look/paper-forms.ts')).PAPER_FORMS;
  if (shape === 5 || shape === 9 || shape === 10)
    return (await import('../core/look/compound-leaves.ts')).COMPOUND_FORMS;
  if (shape >= 11 && shape <= 15) return (await import('../core/look/needle-shapes.ts')).NEEDLE_FORMS;
  return (await import('../core/look/blade-forms.ts')).BLADE_FORMS;
}

type LeafName = Pick<LeafSpec, 'shape' | 'margin'>;

const nameOf = ({ shape, margin }: LeafName): string => (hasMargin(margin) ? margin.join() : String(shape));

const missing = (what: string): Error => new Error(`The element has not loaded ${what}.`);

/** What the trees of the page's elements are made with: of each kind what one of them has needed so far. */
class ElementKit implements TreeKit {
  pick: PickKit | null = null;
  lines: LineKit | null = null;
  readonly channelTexels = null;
  #poser: TreeKit['cpuPoser'] | null = null;
  #organs: TreeKit['organMesh'] | null = null;
  readonly #barks = new Map<BarkKind, MakeRelief>();
  readonly #forms = new Map<string, LeafForm>();

  /** Whether a tree of a species, as it is in its season, can be set. */
  has(species: Species): boolean {
    const { bark, organ } = species;
    return (
      this.#barks.has(bark.kind) &&
      this.#forms.has(nameOf(leafSpecOf(species))) &&
      (organ.kind === 'none' || this.#organs !== null)
    );
  }

  /** Loads what such a tree needs and is not there. */
  async load(species: Species): Promise<void> {
    await Promise.all([
      this.#loadBark(species.bark.kind),
      this.#loadForm(leafSpecOf(species)),
      species.organ.kind !== 'none' && this.#loadOrgans(),
    ]);
  }

  /** Loads what answers rays. */
  async loadPick(): Promise<void> {
    const { pickBranch, pickCrown } = await import('../view/pick.ts');
    this.pick ??= { branch: pickBranch, crown: pickCrown };
  }

  /** Loads the lines of `debug: 'skeleton'`. */
  async loadLines(): Promise<void> {
    const { controlLines, setControlLines } = await import('../view/control-lines.ts');
    this.lines ??= { make: controlLines, fit: setControlLines };
  }

  /** Loads what poses trees where the GPU cannot. */
  async loadPoser(): Promise<void> {
    const { loadCpuPoser } = await import('../view/cpu-kit.ts');
    this.#poser ??= await loadCpuPoser();
  }

  barkImage(kind: BarkKind, size: number): BarkImage {
    const relief = this.#barks.get(kind);
    if (!relief) throw missing(`the bark "${kind}"`);
    return reliefImage(relief(size), size);
  }

  leafForm(spec: LeafName): LeafForm {
    const form = this.#forms.get(nameOf(spec));
    if (!form) throw missing(`the leaf ${nameOf(spec)}`);
    return form;
  }

  organMesh(kind: OrganKind, grain: LeafGrain, bundle: number): LeafMesh {
    if (!this.#organs) throw missing('what twigs bear');
    return this.#organs(kind, grain, bundle);
  }

  cpuPoser(...given: Parameters<TreeKit['cpuPoser']>): ReturnType<TreeKit['cpuPoser']> {
    if (!this.#poser) throw missing('the wind for this GPU');
    return this.#poser(...given);
  }

  async #loadBark(kind: BarkKind): Promise<void> {
    if (this.#barks.has(kind)) return;
    const [relief] = await Promise.all([BARKS[kind](), hasOwn(kind) && import('../view/bark-own.ts')]);
    this.#barks.set(kind, relief);
  }

  async #loadForm(spec: LeafSpec): Promise<void> {
    const name = nameOf(spec);
    if (this.#forms.has(name)) return;
    const { shape, margin } = spec;
    const form = hasMargin(margin)
      ? (await import('../core/look/margin-form.ts')).marginForm(margin)
      : (await formsWith(shape))[shape];
    if (!form) throw new RangeError(`There is no leaf of the shape ${shape}.`);
    this.#forms.set(name, form);
  }

  async #loadOrgans(): Promise<void> {
    this.#organs ??= (await import('../core/look/organ-mesh.ts')).organMesh;
  }
}

export const elementKit = new ElementKit();
