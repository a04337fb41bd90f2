declare module 'gltf-validator' {
  /** What Khronos' validator says of a file; severity 0 is an error, 1 a warning, 2 information, 3 a hint. */
  export interface Report {
    readonly issues: {
      readonly numErrors: number;
      readonly numWarnings: number;
      readonly numInfos: number;
      readonly messages: readonly { readonly code: string; readonly message: string; readonly severity: number }[];
    };
    readonly info: Readonly<Record<string, unknown>>;
  }
  const validator: {
    validateBytes(bytes: Uint8Array, options?: { maxIssues?: number }): Promise<Report>;
  };
  export default validator;
}
