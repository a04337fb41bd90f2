/** What is said while trees grow. */
export const growingWords = {
  growing: (name: string) => `Growing ${name}`,
  stands: (name: string, leaves: number) => `${name}, ${leaves} leaves`,
  own: 'your tree',
  failed: 'This tree could not be grown',
  linkFailed: 'The species in this link cannot be grown',
  noSpecies: (id: string) => `There is no species ${id}`,
};
