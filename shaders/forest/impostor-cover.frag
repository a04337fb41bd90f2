// For each cell the alpha above which lies as large a part of it as is covered: tested there, trees neither thin nor fill
// with distance (after Castano 2010, who scales alpha by it).
uniform sampler2D fineColour;
// Texels along the side of a cell.
uniform int cell;

out vec4 threshold;

const int MOST = 32;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * cell;
  int step_ = max(1, cell / MOST);
  int n = cell / step_;
  float covered = 0.0;
  for (int y = 0; y < n; y++) {
    for (int x = 0; x < n; x++) covered += texelFetch(fineColour, first + step_ * ivec2(x, y), 0).a;
  }
  float low = 0.0;
  float high = 1.0;
  for (int round_ = 0; round_ < 7; round_++) {
    float middle = 0.5 * (low + high);
    float above = 0.0;
    for (int y = 0; y < n; y++) {
      for (int x = 0; x < n; x++) above += step(middle, texelFetch(fineColour, first + step_ * ivec2(x, y), 0).a);
    }
    if (above > covered) low = middle; else high = middle;
  }
  threshold = vec4(0.5 * (low + high), 0.0, 0.0, 1.0);
}
