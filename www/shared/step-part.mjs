// @ts-check
// A part from CAD that is the project's own: a plate of 80 × 50 × 12 mm with a bore and its countersink, a
// dimple, and a boss on a fillet. Each of the five families is there, and every bound is exact.

/** @typedef {readonly [number, number, number]} Place */

/** Bore: where, radius, and where its countersink begins and how wide it ends. */
const BORE = { x: 0, radius: 10, from: 8, wide: 14 };
/** Dimple: where, radius of its sphere, and how deep it goes. */
const DIMPLE = { x: -26, radius: 8, deep: 4 };
/** Boss: where, its radius, how high it stands, and the radius of the fillet at its foot. */
const BOSS = { x: 26, radius: 7, high: 12, fillet: 2 };
const [LONG, WIDE, THICK] = [80, 50, 12];

/** @type {Place} */
const UP = [0, 0, 1];
/** @type {Place} */
const DOWN = [0, 0, -1];

/** The part as the text of a STEP file (AP214, millimetres). */
export function partAsStep() {
  /** @type {string[]} */
  const lines = [];
  const add = (/** @type {string} */ entity) => `#${lines.push(`#${lines.length + 1}=${entity};`)}`;
  const real = (/** @type {number} */ value) => (Number.isInteger(value) ? `${value}.` : String(value));
  const triple = (/** @type {Place} */ at) => `(${at.map(real).join(",")})`;
  const point = (/** @type {Place} */ at) => add(`CARTESIAN_POINT('',${triple(at)})`);
  const direction = (/** @type {Place} */ of) => add(`DIRECTION('',${triple(of)})`);
  const frame = (/** @type {Place} */ at, /** @type {Place} */ axis) => {
    const across = /** @type {Place} */ (axis[0] === 0 ? [1, 0, 0] : [0, 1, 0]);
    return add(`AXIS2_PLACEMENT_3D('',${point(at)},${direction(axis)},${direction(across)})`);
  };
  const bound = (/** @type {string[]} */ uses) => add(`FACE_BOUND('',${add(`EDGE_LOOP('',(${uses.join(",")}))`)},.T.)`);
  const used = (/** @type {string} */ edge, /** @type {boolean} */ forward) => add(`ORIENTED_EDGE('',*,*,${edge},${forward ? ".T." : ".F."})`);
  const face = (/** @type {string} */ surface, /** @type {string[]} */ bounds, sameSense = true) =>
    add(`ADVANCED_FACE('',(${bounds.join(",")}),${surface},${sameSense ? ".T." : ".F."})`);
  const plane = (/** @type {Place} */ at, /** @type {Place} */ normal) => add(`PLANE('',${frame(at, normal)})`);

  /** A circle about an axis that stands up, against the clock as seen from above. */
  const circle = (/** @type {number} */ x, /** @type {number} */ z, /** @type {number} */ radius) => {
    const start = add(`VERTEX_POINT('',${point([x + radius, 0, z])})`);
    return add(`EDGE_CURVE('',${start},${start},${add(`CIRCLE('',${frame([x, 0, z], UP)},${real(radius)})`)},.T.)`);
  };
  const round = (/** @type {string} */ edge, /** @type {boolean} */ forward) => bound([used(edge, forward)]);

  const corners = [0, THICK].flatMap((z) =>
    [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([i = 0, j = 0]) => /** @type {Place} */ ([(i * LONG) / 2, (j * WIDE) / 2, z])),
  );
  const vertices = corners.map((at) => add(`VERTEX_POINT('',${point(at)})`));
  /** @type {Map<string, string>} */
  const edges = new Map();
  const between = (/** @type {number} */ from, /** @type {number} */ to) => {
    const [low, high] = from < to ? [from, to] : [to, from];
    const [start, end] = [corners[low] ?? UP, corners[high] ?? UP];
    const along = /** @type {Place} */ (/** @type {unknown} */ (end.map((value, axis) => value - (start[axis] ?? 0))));
    const length = Math.hypot(...along);
    const unit = /** @type {Place} */ (/** @type {unknown} */ (along.map((value) => value / length)));
    const key = `${low} ${high}`;
    const known = edges.get(key) ?? add(`EDGE_CURVE('',${vertices[low]},${vertices[high]},${add(`LINE('',${point(start)},${add(`VECTOR('',${direction(unit)},1.)`)})`)},.T.)`);
    edges.set(key, known);
    return used(known, from < to);
  };
  const polygon = (/** @type {readonly number[]} */ at) => bound(at.map((corner, place) => between(corner, at[(place + 1) % at.length] ?? 0)));

  const rim = Math.sqrt(DIMPLE.radius ** 2 - (DIMPLE.radius - DIMPLE.deep) ** 2);
  const foot = BOSS.radius + BOSS.fillet;
  const bore = [circle(BORE.x, 0, BORE.radius), circle(BORE.x, BORE.from, BORE.radius), circle(BORE.x, THICK, BORE.wide)];
  const dimple = circle(DIMPLE.x, THICK, rim);
  const boss = [circle(BOSS.x, THICK, foot), circle(BOSS.x, THICK + BOSS.fillet, BOSS.radius), circle(BOSS.x, THICK + BOSS.high, BOSS.radius)];
  const [below = "", middle = "", above = ""] = bore;
  const [ground = "", neck = "", top = ""] = boss;

  // Of a hole the material is outside, so the face looks towards the axis: against the normal of its surface.
  const tan = (BORE.wide - BORE.radius) / (THICK - BORE.from);
  const faces = [
    face(plane([0, 0, 0], DOWN), [polygon([0, 3, 2, 1]), round(below, true)]),
    face(plane([0, 0, THICK], UP), [polygon([4, 5, 6, 7]), round(above, false), round(dimple, false), round(ground, false)]),
    face(plane([0, -WIDE / 2, 0], [0, -1, 0]), [polygon([0, 1, 5, 4])]),
    face(plane([LONG / 2, 0, 0], [1, 0, 0]), [polygon([1, 2, 6, 5])]),
    face(plane([0, WIDE / 2, 0], [0, 1, 0]), [polygon([2, 3, 7, 6])]),
    face(plane([-LONG / 2, 0, 0], [-1, 0, 0]), [polygon([3, 0, 4, 7])]),
    face(add(`CYLINDRICAL_SURFACE('',${frame([BORE.x, 0, 0], UP)},${real(BORE.radius)})`), [round(below, false), round(middle, true)], false),
    face(add(`CONICAL_SURFACE('',${frame([BORE.x, 0, BORE.from], UP)},${real(BORE.radius)},${real(Math.atan(tan))})`), [round(middle, false), round(above, true)], false),
    face(add(`SPHERICAL_SURFACE('',${frame([DIMPLE.x, 0, THICK + DIMPLE.radius - DIMPLE.deep], UP)},${real(DIMPLE.radius)})`), [round(dimple, true)], false),
    face(add(`TOROIDAL_SURFACE('',${frame([BOSS.x, 0, THICK + BOSS.fillet], UP)},${real(foot)},${real(BOSS.fillet)})`), [round(ground, true), round(neck, false)], false),
    face(add(`CYLINDRICAL_SURFACE('',${frame([BOSS.x, 0, 0], UP)},${real(BOSS.radius)})`), [round(neck, true), round(top, false)]),
    face(plane([BOSS.x, 0, THICK + BOSS.high], UP), [round(top, true)]),
  ];
  const body = add(`MANIFOLD_SOLID_BREP('plate',${add(`CLOSED_SHELL('',(${faces.join(",")}))`)})`);
  const unit = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
  const angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  const context = add(`(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((${unit},${angle}))REPRESENTATION_CONTEXT('',''))`);
  add(`ADVANCED_BREP_SHAPE_REPRESENTATION('',(${body}),${context})`);
  const header = "HEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('plate','',(''),(''),'','Fit4CAD','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n";
  return `ISO-10303-21;\n${header}DATA;\n${lines.join("\n")}\nENDSEC;\nEND-ISO-10303-21;\n`;
}

/** The area of each face in the order of the file, in square millimetres. */
export function areasOfPart() {
  const { PI, hypot, sqrt } = Math;
  const rim = sqrt(DIMPLE.radius ** 2 - (DIMPLE.radius - DIMPLE.deep) ** 2);
  const foot = BOSS.radius + BOSS.fillet;
  // By Pappus: a quarter of a circle, its middle 2/π of the radius from its centre on either axis, once around.
  const fillet = 2 * PI * (foot - (2 / PI) * BOSS.fillet) * (PI / 2) * BOSS.fillet;
  return [
    LONG * WIDE - PI * BORE.radius ** 2,
    LONG * WIDE - PI * (BORE.wide ** 2 + rim ** 2 + foot ** 2),
    LONG * THICK,
    WIDE * THICK,
    LONG * THICK,
    WIDE * THICK,
    2 * PI * BORE.radius * BORE.from,
    PI * (BORE.radius + BORE.wide) * hypot(BORE.wide - BORE.radius, THICK - BORE.from),
    2 * PI * DIMPLE.radius * DIMPLE.deep,
    fillet,
    2 * PI * BOSS.radius * (BOSS.high - BOSS.fillet),
    PI * BOSS.radius ** 2,
  ];
}
