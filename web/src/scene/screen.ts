import { WebGLRenderer } from 'three';

/** The canvas of a stage: awake it has a WebGL context; asleep it holds none and shows the picture that it fell asleep with. */
export class Screen {
  renderer: WebGLRenderer | null = null;

  constructor(
    private canvas: HTMLCanvasElement,
    private readonly hooks: { lost: () => void; restored: () => void },
  ) {}

  get stage(): HTMLElement {
    return this.canvas.parentElement as HTMLElement;
  }

  /** @throws where there is no WebGL */
  wake(): void {
    // A canvas whose context was given back gets no other.
    const canvas = this.canvas.cloneNode() as HTMLCanvasElement;
    const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    renderer.setClearColor(0, 0);
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      if (this.renderer === renderer) this.hooks.lost();
    });
    canvas.addEventListener('webglcontextrestored', () => {
      if (this.renderer !== renderer) return;
      // Chromium gives back a canvas that is black where it should be transparent, until its size changes.
      renderer.setSize(1, 1, false);
      this.hooks.restored();
    });
    this.renderer = renderer;
    this.replace(canvas);
  }

  /** Puts the picture in the place of what draws it, which goes with end(). @param draw what there is to see now */
  keepPicture(draw: () => void): void {
    const { width, height } = this.canvas;
    const picture = this.canvas.cloneNode() as HTMLCanvasElement;
    Object.assign(picture, { width, height });
    if (width > 0 && height > 0) {
      draw();
      picture.getContext('2d')?.drawImage(this.canvas, 0, 0);
    }
    this.replace(picture);
  }

  /** Gives the context back. */
  end(): void {
    const { renderer } = this;
    this.renderer = null;
    renderer?.dispose();
    // It may be lost already.
    if (!renderer?.getContext().isContextLost()) renderer?.forceContextLoss();
  }

  /** To that of the stage. */
  resize(): void {
    const { clientWidth, clientHeight } = this.stage;
    this.renderer?.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer?.setSize(clientWidth, clientHeight, false);
  }

  /** What is held on the graphics card, in numbers. */
  get held(): { geometries: number; textures: number; programs: number } {
    if (!this.renderer) return { geometries: 0, textures: 0, programs: 0 };
    const { memory, programs } = this.renderer.info;
    return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
  }

  private replace(canvas: HTMLCanvasElement): void {
    this.canvas.replaceWith(canvas);
    this.canvas = canvas;
  }
}
