import {
  Extension,
  ExtensionProperty,
  type IProperty,
  type Node,
  type Nullable,
  PropertyType,
  RefList,
  type WriterContext,
} from '@gltf-transform/core';

const NAME = 'MSFT_lod';

interface ILevels extends IProperty {
  nodes: RefList<Node>;
}

/** The coarser levels of a node, finest first. */
export class LevelsOfDetail extends ExtensionProperty<ILevels> {
  static override EXTENSION_NAME = NAME;
  declare extensionName: string;
  declare propertyType: string;
  declare parentTypes: PropertyType[];

  protected override init(): void {
    this.extensionName = NAME;
    this.propertyType = 'LevelsOfDetail';
    this.parentTypes = [PropertyType.NODE];
  }

  protected override getDefaults(): Nullable<ILevels> {
    return Object.assign(super.getDefaults() as IProperty, { nodes: new RefList<Node>() });
  }

  addNode(node: Node): this {
    return this.addRef('nodes', node);
  }

  listNodes(): Node[] {
    return this.listRefs('nodes');
  }
}

/**
 * MSFT_lod: a node that stands for the finest level of detail names the nodes of the coarser ones, which stand in no scene. A program that
 * does not know it shows the finest. Written, not read. Source: glTF's registry of vendor extensions.
 */
export class MsftLod extends Extension {
  static override readonly EXTENSION_NAME = NAME;
  override readonly extensionName = NAME;

  createLevels(): LevelsOfDetail {
    return new LevelsOfDetail(this.document.getGraph());
  }

  override read(): this {
    return this;
  }

  override write(context: WriterContext): this {
    for (const node of this.document.getRoot().listNodes()) {
      const levels = node.getExtension<LevelsOfDetail>(NAME);
      const at = context.nodeIndexMap.get(node);
      const definition = at === undefined ? undefined : context.jsonDoc.json.nodes?.[at];
      if (!levels || !definition) continue;
      const ids = levels.listNodes().map((each) => context.nodeIndexMap.get(each) as number);
      definition.extensions = { ...definition.extensions, [NAME]: { ids } };
    }
    return this;
  }
}
