import { EXPORT_FORMATS } from '../core/io/export-options.ts';
import { flagHelp } from './option-flags.ts';
import { shippedNames } from './species-files.ts';
import { DEFAULT_WIND, shippedWinds } from './wind-files.ts';

/** What the command says of itself; the part on options is made from the table of the export. */
export const helpText = (): string => `windgrove: trees with wind through every branch

Usage:
  windgrove stats SPECIES [--seed N] [--json]   grow a tree and print its figures
  windgrove validate FILE...                    check files of species and winds; exit status 1 where one has a fault
  windgrove export SPECIES [--seed N] [--format FORMAT] [--out FILE|DIR/] [--wind WIND] [OPTION...]
                                                write a tree as a file
  windgrove bake SPECIES... --seeds A..B --out DIR [--shard K/N] [--jobs N] [--format FORMAT] [--wind WIND] [OPTION...]
                                                write many trees and a manifest; begun again, it goes on where it was
  windgrove bake --merge DIR                    make one manifest of those of all shards
  windgrove --help | --version

SPECIES is a species file, a tree of Arbaro (XML) or ez-tree (JSON), or the name of a shipped one:
  ${shippedNames().join(', ')}
WIND is a wind file, or the name of a shipped one; ${DEFAULT_WIND} where it is left out:
  ${shippedWinds().join(', ')}
FORMAT is one of ${EXPORT_FORMATS.join(', ')}; that of the ending of FILE where it is left out, or glb. A bake also takes none: figures and
hashes in the manifest, and no files.
N of a seed is a whole number from 0 to 4294967295; 1 where it is left out. Seeds of a bake are runs: 1..1000 or 1..10,20,30..40.
K/N is the K-th of N shards: every N-th tree, so that N machines share a bake. --jobs N grows N trees at a time.

Options of export and bake, and the formats that read them:
${flagHelp()}

Lengths are in metres, angles in degrees. Exit status: 0 all well, 1 a fault in a file or a tree too large, 2 a wrong call.`;
