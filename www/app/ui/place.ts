// Where a popover stands: under its anchor, or above where there is no room, and inside the window.

const MARGIN = 8;

export function placeBeside(element: HTMLElement, anchor: HTMLElement): void {
  const from = anchor.getBoundingClientRect();
  const size = element.getBoundingClientRect();
  const left = Math.min(from.left, innerWidth - size.width - MARGIN);
  const below = from.bottom + MARGIN;
  const top = below + size.height + MARGIN <= innerHeight ? below : from.top - size.height - MARGIN;
  element.style.left = `${Math.max(MARGIN, left)}px`;
  element.style.top = `${Math.max(MARGIN, top)}px`;
}
