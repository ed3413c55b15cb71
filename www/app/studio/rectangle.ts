// A rectangle over the view that keys move and size: the lasso without a pointer.

export type Corner = readonly [number, number];

/** Shares of the view: where its middle is, and how large it is. */
export interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export const MIDDLE: Rectangle = { x: 0.5, y: 0.5, width: 0.3, height: 0.3 };

const STEP = 0.02;
const SMALLEST = 0.02;

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The rectangle after a key; nothing where the key does not change it. Right and down make it larger with Shift, left and up smaller. */
export function afterKey(rectangle: Rectangle, key: string, shift: boolean): Rectangle | undefined {
  if (key === "Home") return MIDDLE;
  const [x, y] = ARROWS[key] ?? [0, 0];
  if (x === 0 && y === 0) return undefined;
  return shift
    ? { ...rectangle, width: within(rectangle.width + x * STEP, SMALLEST), height: within(rectangle.height + y * STEP, SMALLEST) }
    : { ...rectangle, x: within(rectangle.x + x * STEP, 0), y: within(rectangle.y + y * STEP, 0) };
}

function within(value: number, least: number): number {
  return Number(Math.min(1, Math.max(least, value)).toFixed(6));
}

/** Its corners in pixels of a view of this size. */
export function cornersOf({ x, y, width, height }: Rectangle, size: { readonly width: number; readonly height: number }): Corner[] {
  const [left, right] = [(x - width / 2) * size.width, (x + width / 2) * size.width];
  const [top, bottom] = [(y - height / 2) * size.height, (y + height / 2) * size.height];
  return [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ];
}

/** Where it is, for those who do not see it. */
export function wordsFor({ x, y, width, height }: Rectangle): string {
  const percent = (share: number) => Math.round(100 * share);
  return `Rectangle ${percent(width)} % wide and ${percent(height)} % high, its middle ${percent(x)} % from the left and ${percent(y)} % from the top`;
}
