// A leaf as a point, as large on screen as its blade is.
// Which side of it the eye sees.
flat out float vLeafFront;
// 1 where the point is large enough to be seen as round.
flat out float vLeafRound;

// Half the picture's height in pixels.
uniform float pointScale;

// p: the blade's middle, n: its normal, both in view space; w: of the position on screen. own: the leaf's number, 0..1.
float leafPointSize(vec3 p, vec3 n, float w, int place, float own) {
  vec3 eye = projectionMatrix[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-p);
  float facing = dot(n, eye);
  vLeafFront = step(0.0, facing);
  float metres = sqrt(leafPart.z * leafSize.x * leafSize.y * abs(facing)) * length(modelViewMatrix[0].xyz);
  float size = metres * pointScale * projectionMatrix[1][1] / w;
  // Where its blade is drawn it keeps to a pixel of it.
  float blade = clamp(leafPart.x - float(place), 0.0, 1.0);
  float alone = size * (1.0 - blade) * clamp(leafPart.y - float(place), 0.0, 1.0);
  vLeafRound = step(3.0, alone);
  // No point is smaller than a pixel: of those that ought to be, so many are left out that the rest cover as much.
  float cover = max(alone * alone, blade * step(2.0, size));
  return cover > fract(own * 71.7) ? max(1.0, alone * mix(1.0, 1.128, vLeafRound)) : 0.0;
}
