/** What EXT_disjoint_timer_query_webgl2 adds; TypeScript's library does not know it. */
interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/** Measures what a stretch of commands takes on the GPU, where the browser allows it; one measurement at a time. */
export class GpuTimer {
  private readonly gl: WebGL2RenderingContext;
  private extension: TimerExtension | null = null;
  private pending: WebGLQuery | null = null;
  private open = false;
  private smoothed: number | undefined;

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    this.start();
    // A query of a lost context never answers, and the extension has to be asked for anew.
    gl.canvas.addEventListener('webglcontextrestored', () => this.start());
  }

  private start(): void {
    this.extension = this.gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
    this.pending = null;
    this.open = false;
  }

  /** Milliseconds of the stretches measured so far, smoothed; undefined where nothing can be measured. */
  get milliseconds(): number | undefined {
    return this.smoothed;
  }

  begin(): void {
    const { gl, extension } = this;
    if (!extension) return;
    if (this.pending) this.collect(extension);
    if (this.pending) return; // the last answer is not there yet
    this.pending = gl.createQuery();
    if (!this.pending) return;
    gl.beginQuery(extension.TIME_ELAPSED_EXT, this.pending);
    this.open = true;
  }

  end(): void {
    if (!this.open || !this.extension) return;
    this.gl.endQuery(this.extension.TIME_ELAPSED_EXT);
    this.open = false;
  }

  private collect(extension: TimerExtension): void {
    const { gl, pending } = this;
    if (!pending || !gl.getQueryParameter(pending, gl.QUERY_RESULT_AVAILABLE)) return;
    if (!gl.getParameter(extension.GPU_DISJOINT_EXT)) {
      const ms = Number(gl.getQueryParameter(pending, gl.QUERY_RESULT)) / 1e6;
      this.smoothed = this.smoothed === undefined ? ms : this.smoothed + (ms - this.smoothed) * 0.1;
    }
    gl.deleteQuery(pending);
    this.pending = null;
  }
}
