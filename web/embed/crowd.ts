/** Which of the elements of a page draw: browsers take WebGL contexts away from a page that has more than 16. */

/** So many at a time, and one more while another's picture is brought up to date. */
const mostAwake = 8;
/** An element this near to what is in view, in pixels, is made ready for it. */
const nearness = 160;

export interface Member {
  /** Whether the picture that it shows is of something that has changed since. */
  readonly stale: boolean;
  /** It came into view, or near it, or went away. */
  seen(inView: boolean): void;
  wake(): void;
  sleep(): void;
}

interface Place {
  member: Member;
  inView: boolean;
  /** When somebody last pointed at it or was in it. */
  used: number;
}

class Crowd {
  private readonly places = new Map<Element, Place>();
  private readonly observer = new IntersectionObserver((entries) => this.meet(entries), {
    rootMargin: `${nearness}px`,
  });
  private waiting = 0;
  private over: AbortController | null = null;

  add(element: Element, member: Member): void {
    if (!this.over) this.begin();
    this.places.set(element, { member, inView: false, used: 0 });
    this.observer.observe(element);
  }

  remove(element: Element): void {
    this.observer.unobserve(element);
    this.places.delete(element);
    if (this.places.size > 0) this.look();
    else {
      this.over?.abort();
      this.over = null;
    }
  }

  /** Who is being used is not put to sleep for others. */
  use(element: Element): void {
    const place = this.places.get(element);
    if (place) place.used = performance.now();
    this.look();
  }

  /** Soon. */
  look(): void {
    this.waiting ||= requestAnimationFrame(() => this.arrange());
  }

  private begin(): void {
    this.over = new AbortController();
    const { signal } = this.over;
    // A page out of sight has no frames to wait for.
    document.addEventListener('visibilitychange', () => this.arrange(), { signal });
    // Printers get pictures: what a context has drawn may be gone by then.
    window.addEventListener('beforeprint', () => this.rest(), { signal });
    window.addEventListener('afterprint', () => this.arrange(), { signal });
    const moved = () => {
      if (this.inView().length > mostAwake) this.look();
    };
    document.addEventListener('scroll', moved, { signal, passive: true, capture: true });
  }

  private meet(entries: readonly IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      const place = this.places.get(target);
      if (!place || place.inView === isIntersecting) continue;
      place.inView = isIntersecting;
      place.member.seen(isIntersecting);
    }
    this.look();
  }

  private inView(): readonly (readonly [Element, Place])[] {
    return document.visibilityState === 'hidden' ? [] : [...this.places].filter(([, { inView }]) => inView);
  }

  private rest(): void {
    for (const { member } of this.places.values()) member.sleep();
  }

  private arrange(): void {
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    const inView = this.inView();
    const last = Math.max(...inView.map(([, { used }]) => used));
    const order = inView
      .map(([element, place]) => ({
        member: place.member,
        away: place.used > 0 && place.used === last ? -1 : awayFromMiddle(element),
      }))
      .sort((one, other) => one.away - other.away)
      .map(({ member }) => member);
    const awake = new Set(order.slice(0, mostAwake));
    for (const { member } of this.places.values()) if (!awake.has(member)) member.sleep();
    for (const member of awake) member.wake();
    for (const member of order.slice(mostAwake)) {
      if (!member.stale) continue;
      member.wake();
      member.sleep();
    }
  }
}

function awayFromMiddle(element: Element): number {
  const { left, right, top, bottom } = element.getBoundingClientRect();
  return Math.hypot((left + right - innerWidth) / 2, (top + bottom - innerHeight) / 2);
}

/** The one of the document. */
export const crowd = new Crowd();
