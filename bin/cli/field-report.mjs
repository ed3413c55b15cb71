// What is asked of a model for the figures of the field; by any thread, so it is said in plain values.

/** @typedef {import("../engine/engine.js").Model} Model */
/** @typedef {import("../engine/engine.js").Condition} Condition */
/** @typedef {import("../engine/engine.js").Segment} Segment */
/** @typedef {import("../engine/engine.js").FieldReport & { conditions?: Condition[], segments?: Segment[] }} FieldReport */

/**
 * @typedef {object} FieldAsked
 * @property {import("../engine/engine.js").FigureScale} scale
 * @property {boolean} conditions whether the conditions of each model are measured, which takes time
 * @property {boolean} segments whether each segment is told by itself
 */

/**
 * @param {FieldAsked} asked
 * @returns {(model: Model, method: string | undefined) => FieldReport}
 */
export function fieldReportOf({ scale, conditions, segments }) {
  /** The last model's, for its other methods. @type {{ model: Model, conditions: Condition[] } | undefined} */
  let last;
  /** @param {Model} model */
  const conditionsOf = (model) => {
    if (last?.model !== model) last = { model, conditions: model.conditions() };
    return last.conditions;
  };
  return (model, method) => ({
    ...model.field(method, scale),
    ...(conditions ? { conditions: conditionsOf(model) } : {}),
    ...(segments ? { segments: model.segments(method, scale.normalisation) } : {}),
  });
}
