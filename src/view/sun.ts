import { type Box3, DirectionalLight, Matrix4, Vector3 } from 'three';

const corner = new Vector3();
const turned = new Matrix4();

/** The sun: a directional light whose shadow map is fitted to what casts shadows. */
export class Sun extends DirectionalLight {
  /** From the scene to the sun, unit length. */
  readonly direction = new Vector3(0.8, 0.5, 0.28).normalize();

  constructor(mapSize: number) {
    super();
    this.name = 'sun';
    this.castShadow = true;
    this.shadow.mapSize.setScalar(mapSize);
    this.shadow.radius = 2.2;
  }

  /** Fits the shadow's frustum to a box around the casters, y up; receivers below them, on the ground, are covered too. */
  fit(box: Box3): void {
    const centre = box.getCenter(new Vector3());
    const size = box.getSize(new Vector3()).length() || 1;
    this.target.position.copy(centre);
    this.position.copy(centre).addScaledVector(this.direction, size);
    this.updateMatrixWorld();
    this.target.updateMatrixWorld();
    turned.identity().lookAt(this.position, centre, this.up).setPosition(this.position).invert();
    const { camera } = this.shadow;
    let right = 0;
    let top = 0;
    let far = 0;
    for (let i = 0; i < 8; i++) {
      corner.set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
      corner.applyMatrix4(turned);
      right = Math.max(right, Math.abs(corner.x));
      top = Math.max(top, Math.abs(corner.y));
      far = Math.max(far, -corner.z);
    }
    // A long shadow ends where the ray from the highest corner meets the ground.
    const reach = Math.max(0, box.max.y) / Math.max(0.05, this.direction.y);
    camera.left = -right;
    camera.right = right;
    camera.top = top;
    camera.bottom = -top;
    camera.near = 0.01 * size;
    camera.far = far + reach;
    camera.updateProjectionMatrix();
    // Half a texel's slope of a leaf that lies aslant to the light; in metres for the normal, in depth for the rest.
    const texel = (2 * Math.max(right, top)) / this.shadow.mapSize.x;
    this.shadow.normalBias = texel * 1.6;
    this.shadow.bias = (-texel * 0.6) / (camera.far - camera.near);
    this.shadow.needsUpdate = true;
  }
}
