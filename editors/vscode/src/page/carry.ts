// The state of a page, which its next version takes over: by the elements that a reader uses.

/** Returns an element of a page. */
function part<Kind extends Element>(page: Document, id: string): Kind | null {
  return page.getElementById(id) as Kind | null;
}

/** Moves a slider as a reader does. */
function move(slider: HTMLInputElement, value: number): void {
  slider.value = String(value);
  slider.dispatchEvent(new Event("input"));
}

function isPlaying(page: Document): boolean {
  return part(page, "play")?.hasAttribute("data-playing") ?? false;
}

/** Takes the position along the range; another number of rows keeps the share of the range. */
function carryPosition(from: Document, to: Document): void {
  const [old, slider] = [from, to].map((page) => part<HTMLInputElement>(page, "position"));
  if (!old || !slider) return;
  const playing = isPlaying(from);
  const share = Number(old.value) / Math.max(1, Number(old.max));
  move(slider, Math.round(share * Number(slider.max)));
  if (playing !== isPlaying(to)) part<HTMLElement>(to, "play")?.click();
}

function carryChoice(from: Document, to: Document, id: string): void {
  const [old, select] = [from, to].map((page) => part<HTMLSelectElement>(page, id));
  if (!old || !select || ![...select.options].some(({ value }) => value === old.value)) return;
  select.value = old.value;
  select.dispatchEvent(new Event("change"));
}

/** Gives a page the colours of the editor, or those that the reader chose. */
function carryTheme(from: Document | undefined, to: Document, dark: boolean): void {
  const wanted = from?.documentElement.dataset["theme"] ?? (dark ? "dark" : "light");
  const shown = to.defaultView?.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  if (wanted !== shown) part<HTMLElement>(to, "theme")?.click();
}

/** Gives a new version of a page the state of the version before. */
export function carryOver(from: Window | null, to: Window | null, dark: boolean): void {
  if (to === null) return;
  carryTheme(from?.document, to.document, dark);
  if (from === null) return;
  carryChoice(from.document, to.document, "speed");
  carryPosition(from.document, to.document);
  to.scrollTo(from.scrollX, from.scrollY);
}
