import type { Species } from '../core/species/species.ts';
import type { GrownTree } from '../view/picture/grow-tree.ts';
import type { Picture } from '../view/picture/picture.ts';

/** Pixels of a snapshot's picture; twice what is shown, for fine screens. */
const WIDTH = 192;
const HEIGHT = 144;

/** A small picture of a tree at rest, as a data: address; rejects where none can be drawn. */
export async function thumbnailOf(
  picture: Pick<Picture, 'portrait'>,
  grown: GrownTree,
  species: Species,
): Promise<string> {
  const blob = await picture.portrait(grown, species, { width: WIDTH, height: HEIGHT });
  return new Promise((done, fail) => {
    const reader = new FileReader();
    reader.onload = () => done(String(reader.result));
    reader.onerror = () => fail(reader.error);
    reader.readAsDataURL(blob);
  });
}
