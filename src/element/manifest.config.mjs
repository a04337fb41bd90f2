import { readFileSync } from 'node:fs';

/** The custom-elements manifest of `<wind-tree>`: `npm run manifest` writes it, tests/element/manifest.test.ts holds it against the code. */

/** The attributes by their properties, as the table (attributes.ts) has them; the analyzer cannot read a table. */
const named = new Map(
  [...readFileSync('src/element/attributes.ts', 'utf8').matchAll(/^ {2}'?([\w-]+)'?: row\('(\w+)'/gm)].map(
    ([, attribute, property]) => [property, attribute],
  ),
);

const attributeNames = {
  name: 'attribute names',
  packageLinkPhase({ customElementsManifest }) {
    const all = customElementsManifest.modules.flatMap(({ declarations }) => declarations ?? []);
    const element = all.find(({ tagName }) => tagName === 'wind-tree');
    if (!element) return;
    element.members = element.members.filter(({ name, privacy }) => !name.startsWith('#') && privacy !== 'protected');
    const attributes = new Map();
    for (const member of element.members) {
      delete member.inheritedFrom;
      if (member.kind !== 'field') continue;
      const attribute = named.get(member.name) ?? (member.attribute === undefined ? undefined : member.attribute);
      if (!attribute) continue;
      member.attribute = attribute;
      attributes.set(attribute, {
        name: attribute,
        fieldName: member.name,
        description: member.description,
        type: member.type,
        ...(member.default === undefined ? {} : { default: member.default }),
      });
    }
    element.attributes = [...attributes.values()].sort((a, b) => a.name.localeCompare(b.name));
    // Events are what the element's comment tells of; the analyzer also finds the helper that sends them.
    element.events = element.events.filter(({ description }) => description);
    element.superclass = { name: 'ReactiveElement', package: '@lit/reactive-element' };
    // What it is made of is nobody's business: one module, one element.
    customElementsManifest.modules = customElementsManifest.modules
      .filter(({ path }) => /(wind-tree-element|define)\.ts$/.test(path))
      .map((module) => ({ ...module, declarations: (module.declarations ?? []).filter((each) => each === element) }));
  },
};

export default {
  globs: ['src/element/wind-tree-*.ts', 'src/element/define.ts'],
  outdir: '.',
  litelement: true,
  packagejson: false,
  plugins: [attributeNames],
};
