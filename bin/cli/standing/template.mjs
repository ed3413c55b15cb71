// The `method.toml` of a new row, to be filled in.

import { KINDS } from "../../../www/shared/results/kinds.mjs";
import { PLATFORMS } from "../../../www/shared/results/method.mjs";

/**
 * @param {string} called the method in the names of its answers' folders
 */
export function template(called) {
  return `# What the row is of; results/README.md says what each key means. What is empty has to be filled in.
name = ${JSON.stringify(called.slice(0, 60))}
year = ${new Date().getUTCFullYear()}
# One of ${KINDS.map(({ name }) => name).join(", ")}.
kind = ""
# In words; "nothing" for what learns nothing.
trained_on = ""
added = ${new Date().toISOString().slice(0, 10)}

[[authors]]
given = ""
family = ""

# [paper]
# title = ""
# journal = ""
# doi = ""

[time]
# One of ${PLATFORMS.join(", ")}.
platform = ""
machine = ""

# Where the answers are had: a zip that stays where it is, with its SHA-256.
[answers]
called = ${JSON.stringify(called.slice(0, 60))}
licence = ""
archive = "https://"
sha256 = ""
`;
}
