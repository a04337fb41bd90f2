import { expect, test } from 'vitest';
import { minifiedGlsl } from '../../build/glsl-minify.ts';

test('a shader is shorter and means the same: what it declares in a function is renamed, and nothing that others know', () => {
  const shader = `
    uniform vec2 wind;
    struct Push { vec3 push; float stir; };
    float swing(vec2 direction, inout Push given) {
      float length_ = 0.50 - -1.0 * direction.x;
    #ifdef STRONG
      const float strong = 10.0;
    #else
      const float strong = 1e-3;
    #endif
      for (int step_ = 0; step_ < 3; step_++) length_ += float(step_) * wind.y;
      given.push = vec3(strong, length_, 0x1F);
      return other(length_) + given.stir;
    }`;
  expect(minifiedGlsl(shader).split('\n')).toEqual([
    'uniform vec2 wind;struct Push{vec3 push;float stir;};float swing(vec2 a,inout Push b){float c=.5- -1.*a.x;',
    '#ifdef STRONG',
    'const float d=10.;',
    '#else',
    'const float d=1e-3;',
    '#endif',
    'for(int e=0;e<3;e++)c+=float(e)*wind.y;b.push=vec3(d,c,0x1F);return other(c)+b.stir;}',
  ]);
});

test('a function that more text is put into later keeps its names, and a short name is never taken twice', () => {
  expect(minifiedGlsl('void f(float depth) {\n#pragma more\nuse(depth);\n}')).toContain('use(depth)');
  expect(minifiedGlsl('float f(float depth) { return a * depth; }')).toBe('float f(float b){return a*b;}');
});

test('brackets that do not match are a fault of the build, not of the page', () => {
  expect(() => minifiedGlsl('void f() {')).toThrow('open');
  expect(() => minifiedGlsl('}')).toThrow('closes');
});
