import type { BufferGeometry, InstancedBufferGeometry, Mesh } from 'three';

/** The coarser form that a mesh has for shadow maps: indices of its own geometry that come after those of the picture. */
export interface ShadowForm {
  readonly first: number;
  readonly indices: number;
  instances: number;
}

/** Where the form of the picture ends, and what comes after it. */
export interface Forms {
  readonly indices: number;
  instances: number;
  readonly shadow: ShadowForm;
}

const formsOf = (geometry: BufferGeometry): Forms | undefined => geometry.userData.forms as Forms | undefined;

/** Arrays of a mesh: attributes by name, and the index. */
export interface Copies {
  readonly attributes: Readonly<Record<string, Float32Array>>;
  readonly index: Uint16Array | Uint32Array;
  readonly vertices: number;
}

function after(a: Float32Array, b: Float32Array): Float32Array {
  const out = new Float32Array(a.length + b.length);
  out.set(a);
  out.set(b, a.length);
  return out;
}

/** Copies for the picture and, after them, those for shadow maps, as arrays of one geometry. */
export function joined(picture: Copies, shadow: Copies): Copies {
  const vertices = picture.vertices + shadow.vertices;
  const length = picture.index.length + shadow.index.length;
  const index = vertices > 65535 ? new Uint32Array(length) : new Uint16Array(length);
  index.set(picture.index);
  shadow.index.forEach((at, i) => {
    index[picture.index.length + i] = at + picture.vertices;
  });
  const names = Object.keys(picture.attributes);
  const attributes = Object.fromEntries(
    names.map((name) => [name, after(picture.attributes[name]!, shadow.attributes[name]!)]),
  );
  return { attributes, index, vertices };
}

/**
 * Shadow maps draw a mesh in the coarser form of its geometry, where it has one: three draws one geometry into both, so its range is another for
 * that while. A shadow's texel is a centimetre wide and blurred: what is finer costs as much as in the picture, and is not seen.
 */
export function castCoarsely(mesh: Mesh<InstancedBufferGeometry>): void {
  mesh.onBeforeShadow = (_renderer, _object, _camera, _shadowCamera, geometry) => {
    const forms = formsOf(geometry);
    if (!forms) return;
    geometry.setDrawRange(forms.shadow.first, forms.shadow.indices);
    (geometry as InstancedBufferGeometry).instanceCount = forms.shadow.instances;
  };
  mesh.onAfterShadow = (_renderer, _object, _camera, _shadowCamera, geometry) => {
    const forms = formsOf(geometry);
    if (!forms) return;
    geometry.setDrawRange(0, forms.indices);
    (geometry as InstancedBufferGeometry).instanceCount = forms.instances;
  };
}
