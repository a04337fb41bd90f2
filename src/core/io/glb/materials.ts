import {
  type Document,
  TextureInfo as Info,
  type Material,
  type Texture,
  type TextureInfo,
} from '@gltf-transform/core';
import { KHRMaterialsDiffuseTransmission } from '@gltf-transform/extensions';
import { twigColour } from '../../look/bark-colour.ts';
import { barkMaps } from '../../look/bark-maps.ts';
import type { Colour } from '../../look/colour.ts';
import { brightestLeaf, LEAF_IMAGE_GAIN, leafImage, leafThin, throughColour } from '../../look/leaf-look.ts';
import { leafForm, leafSpecOf } from '../../look/leaf-shapes.ts';
import type { Species } from '../../species/species.ts';
import { pngOf } from './png.ts';

/** The materials of a tree. */
export interface TreeMaterials {
  readonly bark: Material;
  readonly twigs: Material;
  readonly leaves: Material;
  /** White: its colours are those of the vertices. */
  readonly organs: Material;
  /** The colour of the leaves' material, which the colour of each leaf is a part of; without and with its image. */
  readonly leafBase: Colour;
  /** What a leaf's colour is multiplied by before it is divided by `leafBase`. */
  readonly leafGain: number;
}

/** Texels along a side of the image of a leaf. */
const LEAF_SIZE = 128;

const repeat = (info: TextureInfo | null): void => {
  info?.setWrapS(Info.WrapMode.REPEAT).setWrapT(Info.WrapMode.REPEAT);
};

/**
 * Materials for the stems and leaves of a species; `size`: texels along each side of the images, 0 for none.
 *
 * Light through leaves is KHR_materials_diffuse_transmission: where it is not known, leaves are as bright as without it.
 */
export function treeMaterials(
  document: Document,
  { bark, foliage, leaves: shape, organ }: Species,
  size: number,
  report: (done: number) => void = () => {},
): TreeMaterials {
  const image = (name: string, data: Uint8Array, side: number): Texture =>
    document.createTexture(name).setMimeType('image/png').setImage(pngOf(data, side));
  const barkMaterial = document.createMaterial('bark').setMetallicFactor(0);
  if (size > 0) {
    const maps = barkMaps(bark, size);
    report(0.4);
    const surface = image('bark surface', maps.surface, size);
    barkMaterial
      .setBaseColorTexture(image('bark colour', maps.colour, size))
      .setNormalTexture(image('bark normal', maps.normal, size))
      .setMetallicRoughnessTexture(surface)
      .setOcclusionTexture(surface)
      .setRoughnessFactor(1)
      .setMetallicFactor(1);
    for (const info of [
      barkMaterial.getBaseColorTextureInfo(),
      barkMaterial.getNormalTextureInfo(),
      barkMaterial.getMetallicRoughnessTextureInfo(),
      barkMaterial.getOcclusionTextureInfo(),
    ]) {
      repeat(info);
    }
  } else {
    barkMaterial.setBaseColorFactor([...twigColour(bark), 1]).setRoughnessFactor(bark.roughness);
  }
  report(0.9);
  const twigs = document
    .createMaterial('twigs')
    .setMetallicFactor(0)
    .setBaseColorFactor([...twigColour(bark), 1])
    .setRoughnessFactor(bark.roughness);
  const leafGain = size > 0 ? LEAF_IMAGE_GAIN : 1;
  const [r, g, b] = brightestLeaf(foliage);
  const leafBase: Colour = [Math.min(1, leafGain * r), Math.min(1, leafGain * g), Math.min(1, leafGain * b)];
  const leaves = document
    .createMaterial('leaves')
    .setMetallicFactor(0)
    .setDoubleSided(true)
    .setBaseColorFactor([...leafBase, 1])
    .setRoughnessFactor(foliage.roughness);
  if (size > 0)
    leaves.setBaseColorTexture(
      image(
        'leaf veins',
        leafImage(LEAF_SIZE, leafForm(leafSpecOf({ foliage, leaves: shape })), foliage.veins),
        LEAF_SIZE,
      ),
    );
  const through = document
    .createExtension(KHRMaterialsDiffuseTransmission)
    .createDiffuseTransmission()
    .setDiffuseTransmissionFactor(Math.min(1, 0.3 * leafThin(foliage)))
    .setDiffuseTransmissionColorFactor([...throughColour(foliage)]);
  leaves.setExtension('KHR_materials_diffuse_transmission', through);
  const organs = document
    .createMaterial('organs')
    .setMetallicFactor(0)
    .setDoubleSided(true)
    .setRoughnessFactor(organ.kind === 'fruit' ? 0.35 : 0.75);
  return { bark: barkMaterial, twigs, leaves, organs, leafBase, leafGain };
}
