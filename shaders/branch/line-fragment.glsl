// A line is a pixel wide however thin the stem is: it covers as many of its pixels as the stem would cover of theirs.
in float vWide;

// Part that is left of the thinnest: a trunk a mile away is a line still.
const float LEAST_LINE = 0.3;

bool lineGap() {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return noise >= max(vWide, LEAST_LINE);
}
