/** The part of the browser's Trusted Types that is used; types of the DOM have none of it. */
interface ScriptPolicy {
  createScriptURL(address: string): string;
}
interface Factory {
  createPolicy(name: string, rules: ScriptPolicy): ScriptPolicy;
}

let policy: ScriptPolicy | null | undefined;

function ourPolicy(): ScriptPolicy | null {
  const { trustedTypes } = globalThis as { trustedTypes?: Factory };
  try {
    return trustedTypes?.createPolicy('windgrove', { createScriptURL: (address) => address }) ?? null;
  } catch {
    // The page does not allow the policy: it may not demand one, either.
    return null;
  }
}

/**
 * The browser's Worker, for addresses of our own files alone: a page that asks for Trusted Types (`require-trusted-types-for 'script'`) is told
 * by the policy `windgrove` that they can be trusted.
 *
 * It is handed to the function that starts a worker as `Worker`, since bundlers look for the very words `new Worker(new URL(...))`.
 */
export function trustedWorker(): typeof Worker {
  if (policy === undefined) policy = ourPolicy();
  return policy ? vouchedFor(policy) : Worker;
}

const vouchedFor = (trusted: ScriptPolicy): typeof Worker =>
  class extends Worker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(trusted.createScriptURL(String(address)), options);
    }
  };
