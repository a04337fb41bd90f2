import own from '../../shaders/branch/bark-own.glsl';
import { providePart } from './inject.ts';

// The shader of bark names it; a page that shows none of these kinds never loads it.
providePart('bark_own', own);
