// The files of a model by what they hold.

import { ROLES } from "../generated/declared/roles.js";

/** @typedef {import("../generated/engine/engine.js").Role} Role */

/**
 * What a segmentation is written as: everything but the cloud, which it refers to.
 * @type {readonly Exclude<Role, "cloud">[]}
 */
export const SEGMENTATION = ROLES.flatMap(({ name }) => (name === "cloud" ? [] : [name]));
