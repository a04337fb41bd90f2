/** What a name of a project file ends in. */
export const PROJECT_ENDING = '.windgrove.json';

/** A project has some ten kilobytes, with measured winds in it some hundred; this much is something else. */
export const LONGEST_PROJECT = 10_000_000;

/** Snapshots that a project holds. */
export const MOST_SNAPSHOTS = 100;

/** Letters of a snapshot's name. */
export const LONGEST_SNAPSHOT_NAME = 80;

/** Whether a text says that it is a project, whatever else is wrong with it. */
export const isProjectText = (text: string): boolean => /"format"\s*:\s*"windgrove-project"/.test(text);
