import { mountFigures } from '../figure.ts';
import { inText } from '../live-text.ts';
import { BRANCH_FIGURE } from './figure-branch.ts';
import { CASTELJAU_FIGURE } from './figure-casteljau.ts';
import { DETAIL_FIGURE } from './figure-detail.ts';
import { FRAMES_FIGURE } from './figure-frames.ts';
import { LOBES_FIGURE } from './figure-lobes.ts';
import { NORMALS_FIGURE } from './figure-normals.ts';
import { PROFILE_FIGURE } from './figure-profile.ts';
import { SECTION_FIGURE } from './figure-section.ts';
import { SHEET_FIGURE } from './figure-sheet.ts';
import { SLOPE_FIGURE } from './figure-slope.ts';
import { TREE_FIGURE } from './figure-tree.ts';
import { TWIST_FIGURE } from './figure-twist.ts';
import { WALK_FIGURE } from './figure-walk.ts';

mountFigures(
  [
    BRANCH_FIGURE,
    SHEET_FIGURE,
    DETAIL_FIGURE,
    PROFILE_FIGURE,
    LOBES_FIGURE,
    SLOPE_FIGURE,
    WALK_FIGURE,
    CASTELJAU_FIGURE,
    FRAMES_FIGURE,
    TWIST_FIGURE,
    SECTION_FIGURE,
    NORMALS_FIGURE,
    TREE_FIGURE,
  ].map(inText),
);
