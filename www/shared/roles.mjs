// The files of a model by what they hold.

import { ROLES } from "../generated/declared/roles.js";

/** @typedef {import("../generated/engine/engine.js").Role} Role */

/** @typedef {Exclude<Role, "types">} WrittenRole what a model is written as */

/** @type {readonly WrittenRole[]} */
export const WRITTEN = ROLES.flatMap(({ name, written }) => (written ? [/** @type {WrittenRole} */ (name)] : []));

/**
 * What a segmentation is written as: everything but the cloud, which it refers to.
 * @type {readonly Exclude<WrittenRole, "cloud">[]}
 */
export const SEGMENTATION = WRITTEN.flatMap((name) => (name === "cloud" ? [] : [name]));
