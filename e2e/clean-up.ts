import { rmSync } from 'node:fs';

/** Removes the build that the tests looked at. */
export default function cleanUp(): void {
  const build = process.env.WINDGROVE_TEST_BUILD;
  if (build) rmSync(build, { recursive: true, force: true });
}
