// What `--help` teaches.

import { EXPORTS } from "../../www/generated/declared/exports.js";
import { FILE_KINDS } from "../../www/generated/declared/file-kinds.js";
import { FIGURES } from "../../www/generated/declared/figures.js";
import { FIGURE_SCALE } from "../../www/generated/declared/figure-scale.js";
import { FITTERS } from "../../www/generated/declared/fitters.js";
import { MEASURES } from "../../www/generated/declared/measures.js";
import { NORMALISATIONS } from "../../www/generated/declared/normalisations.js";
import { PROTOCOLS } from "../../www/generated/declared/protocols.js";
import { RECOGNITION } from "../../www/generated/declared/recognition.js";
import { PROTOCOL_DIFFERENCES } from "../../www/generated/declared/protocol-differences.js";
import { ROLES } from "../../www/generated/declared/roles.js";
import { SAMPLE_OPTIONS } from "../../www/generated/declared/sample-options.js";
import { STRATA } from "../../www/generated/declared/strata.js";
import { FORMATS } from "../../www/shared/formats/index.mjs";
import { MOST_DIGITS } from "../../www/shared/formats/wanted.mjs";
import { WEAR, wearWords } from "../../www/shared/results/wear.mjs";
import { CALLED, STEP_FORM } from "../../www/shared/step.mjs";
import { loadCad } from "./cad.mjs";
import { JOBS_HELP } from "./jobs.mjs";
import { setsOf } from "./standing/folder.mjs";
import { parameterHelp, rangeOf } from "./parameters.mjs";
import { terms } from "./terms.mjs";

const PROTOCOL_NAMES = PROTOCOLS.map(({ name }) => name).join("|");
const FITTER_NAMES = FITTERS.map(({ name }) => name).join("|");
const OF_FIELD = FIGURES.filter(({ group }) => group === "segmentation");
const OF_FIT = FIGURES.filter(({ group }) => group === "fit");
const ROLE_NAMES = ROLES.map(({ name }) => name).join(", ");

const fit4cad = () => `fit4cad: fit, score and make segmentations of CAD point clouds, as the Fit4CAD benchmark does

  fit4cad score PATH…       score submissions against the ground truth
  fit4cad fit PATH…         find the primitives of clouds, with method ${FITTERS.map(({ title }) => title).join(" or ")}
  fit4cad export PATH…      write segmentations as tables, labelled points and meshes
  fit4cad import PATH…      make models of STEP files: points on their faces, and the truth
  fit4cad check PATH…       find errors in a ground truth, and correct them
  fit4cad stats PATH…       count what a set of models holds
  fit4cad generate PART     make a model with known ground truth
  fit4cad generate --list   the parts it can make
  fit4cad degrade PATH…     make worse scans of models, the same for everyone by a seed
  fit4cad submit PATH…      check and score a submission to the standing table, and write its folder
  fit4cad verify FOLDER…    score again what a row of the standing table claims, digit by digit
  fit4cad COMMAND --help    what a command reads, prints and means
  fit4cad --version

score, fit, import, check and stats print a table; with --format json, or --json for short, they print all
they know, for programs, and {"error": …} where a call fails as a whole.

Try it on a model of your own making:
  fit4cad generate --list
  fit4cad generate flange --out demo
  fit4cad score demo --self

Exit code: 0 all well, 1 some input was unusable (the rest was scored), 2 called wrongly.
`;

/** What is to be shown of the benchmark's measures. */
const TABLE_HELP = /** @type {const} */ ([
  ["--means", "the mean of each method alone, no rows of single models"],
  ["--measures NAME,NAME…", "these measures alone as columns"],
  ["--digits N", `digits after the point, up to ${MOST_DIGITS}; LaTeX and Markdown write what all of them would show as 0 as a power of ten`],
  ["--bold", "the best figure of each model, and the best mean, in bold: for latex and markdown"],
  ["--published", "also the paper's two methods, scored from their published files by the same protocol, on the models that are its test models by name, points and true primitives"],
]);

const score = () => `fit4cad score PATH… [--protocol ${PROTOCOL_NAMES}] [--format FORMAT] [--means] [--measures NAME,NAME…]
                    [--digits N] [--bold] [--published] [--self] [--jobs N] [--as …]
fit4cad score PATH… [--protocol NAME,NAME…] [--measures NAME,NAME…] [--normalisation NAME]
                    [--epsilon N] [--by NAME,NAME…] [--format FORMAT] [--self] [--jobs N] [--as …]

Scores every submission found in the given files, folders and zips against the ground truth found
beside it. Files belong to one model by their names:

${terms(ROLES.map(({ name, meaning }) => [name === "cloud" ? "PC14.txt" : `PC14_${name}.txt`, meaning]), 33)}
A cloud may be of any of these kinds, told by its content; PC14.txt beside PC14.ply is the cloud:
${terms(FILE_KINDS.map(({ endings, title, meaning }) => [`.${endings[0]}`, `${title}${others(endings)}: ${meaning}`]), 10)}A folder whose name ends in a method's (pointCloud_primitives_HT) or is one (HT/) holds that
method's submission; files in other folders are the truth. One of the two surface files is enough.

${terms(PROTOCOLS.map(({ name, meaning }, place) => [`--protocol ${name}`, `${place === 0 ? "(default) " : ""}${meaning}`]), 26)}${formatHelp(26)}${terms(TABLE_HELP, 26)}  --self                  scores the truth against itself, as method "truth"
${terms([["--jobs N", JOBS_HELP]], 26)}  --as role=R,model=M,method=N,first=F:FILE
                          FILE is R (${ROLE_NAMES}) of model M, found by
                          method N (empty: the truth), whatever its name says, and its indices count
                          from F (0 or 1); each of the four may be left out, and the option may be
                          repeated

Measures, each the mean over primitives; n/a (null in JSON) where one cannot be had:
${terms(MEASURES.map(({ key, name, meaning, range, better }) => [key, `${name}, ${range}; ${better} is better. ${meaning}`]), 15)}${terms([["type errors", "predictions whose type differs from the truth's: they have no d1"]], 15)}
How the two protocols differ:
${PROTOCOL_DIFFERENCES.map(({ what, definition, published }) => `  ${what}\n${terms([["  definition", definition], ["  published", published]], 18)}`).join("")}
What the rest of the field reports, beside the benchmark's measures: several protocols with commas
between them, or all. A table of figures, then over several models mean, 95 % interval (bootstrap)
and quartiles, then method against method with Wilcoxon's test.
${terms(OF_FIELD.map(({ key, title, definition, rewards, trap, source }) => [`--protocol ${key}`, `${title}. ${definition} Rewards: ${lower(rewards)} Trap: ${lower(trap)} Read off ${source}.`]), 26)}
${terms([[`--protocol ${RECOGNITION.key}`, `${RECOGNITION.title}'s tables of single segments, also by --by. ${RECOGNITION.definition} Rewards: ${lower(RECOGNITION.rewards)} Trap: ${RECOGNITION.trap} Read off ${RECOGNITION.source}.`]], 26)}  --measures NAME,NAME…   figures of fit, or all; true and predicted primitives are matched one to one
${terms(OF_FIT.map(({ key, title, definition, trap, better }) => [`  ${key}`, `${title}; ${better} is better. ${definition} Trap: ${lower(trap)}`]), 26)}
  --normalisation NAME    what lengths are divided by
${terms(NORMALISATIONS.map(({ name, meaning }) => [`  ${name}`, `${name === FIGURE_SCALE.normalisation ? "(default) " : ""}${meaning}`]), 26)}  --epsilon N             ε of the coverages in that unit (default ${FIGURE_SCALE.epsilon})
  --by NAME,NAME…         also how the true primitives fare by what they are, and how the figures come out
                          by the conditions of their models; noise and share missing are those that
                          manifest.json of a set declares, where it is among the files
${terms(STRATA.map(({ name, title, how }) => [`  ${name}`, `${title}. ${how}`]), 26)}
All formats but the table carry the engine's version, the protocol and the SHA-256 of each file read.

Results go to stdout. What is wrong with the input goes to stderr, with file, line and column; in
JSON it is part of the output. A broken entry does not keep the rest of a file from being scored.

Examples:
  fit4cad score Fit4CAD-main.zip
  fit4cad score dataset/test_set my_results/pointCloud_primitives_MINE --format csv > scores.csv
  fit4cad score . --protocol published --format json | jq '.[].mean.DSC'
  fit4cad score test_set answers --means --published --bold --format latex > table.tex
  fit4cad score . --protocol spfn,parsenet,pq --measures all --by size,type
  fit4cad score set answers --protocol shrec2022,spfn --by noise,missing --format latex

Exit code: 0 all scored, 1 some input unusable, 2 called wrongly.
`;

/**
 * A sentence as it goes on after a colon.
 * @param {string} sentence
 */
function lower(sentence) {
  return /^[A-Z][a-z]/.test(sentence) ? sentence.charAt(0).toLowerCase() + sentence.slice(1) : sentence;
}

const generate = () => `fit4cad generate PART ${SAMPLE_OPTIONS.map(({ name }) => `[--${name} N]`).join(" ")}
                      [--imperfect] [--name NAME] [--out DIR]
fit4cad generate --list

Makes a CAD-like part with its ground truth: the files of a Fit4CAD model. The same options always
give the same files. The diagonal is that of the part's bounding box.

  --list        the parts, with what each is good for
${terms(SAMPLE_OPTIONS.map((info) => [`--${info.name} N`, `${info.explanation} ${capitalised(rangeOf(info))}.`]), 16)}  --imperfect   also a submission that is wrong in common ways, so that there is something to score
  --name NAME   what the model is called (default: as its part)
  --out DIR     where the files go (default: the current folder); made if missing

Example:
  fit4cad generate flange --noise 0.001 --out demo && fit4cad score demo --self
`;

const fit = () => `fit4cad fit --method ${FITTER_NAMES} [--out DIR] [--format table|json] [--seed N] [--jobs N]
            [parameters] PATH…

Finds the primitives of every cloud in the given files, folders and zips: which points make up each,
and its surface. Only the clouds are read; truth and submissions beside them are not.

${terms(FITTERS.map(({ name, title, fullName, meaning }) => [`--method ${name}`, `${title}, ${fullName}. ${meaning}`]), 18)}  --out DIR       writes each model's primitives, parametric and implicit file, in the folders
                  DIR/pointCloud_primitives_HT and so on, where fit4cad score finds them
  --format table  (default) one row per model
  --format json   (--json) one entry per model: name, points, seconds of fitting (without reading),
                  type, points and mean fitting error of each primitive, and how many of each type; error,
                  where its files could not be written
  --seed N        of everything random (default 1); the same seed gives the same primitives
${terms([["--jobs N", JOBS_HELP]], 18)}  --single        instead of a method: the whole cloud is one primitive, or each segment that is given
                  with it (a column of labels, PC14_primitives.txt); says the type, the distances, the
                  best of another type and how many times as far the points are from that. With --out
                  also the answer columns of SHREC 2022, in DIR/shrec2022

Parameters, with the values allowed and the default:
${parameterHelp()}
Examples:
  fit4cad fit --method ht PC14.txt
  fit4cad fit --method pg --out found Fit4CAD-main.zip && fit4cad score Fit4CAD-main.zip found
  fit4cad fit --method ht --tolerance 0.001 --json scans | jq '.[].primitives | length'

Exit code: 0 all fitted, 1 some input unusable, 2 called wrongly.
`;

const exportFiles = () => `fit4cad export PATH… --to FORM[,FORM…] [--method NAME] [--out DIR] [--as …]

Writes the truth and every submission found in the given files, folders and zips in other forms, with
or without a truth beside them: DIR/PC14_HT.ply and so on.

${terms([...[...EXPORTS, STEP_FORM].map(({ name, title, meaning }) => /** @type {const} */ ([`--to ${name}`, `${title}. ${meaning}`])), ["--to fit4cad", "The benchmark's own four files, in the folders of the public test set."]], 18)}  --method NAME   only of that method; truth for the ground truth
  --out DIR       where the files go (default: the current folder); made if missing
  --as …          as for fit4cad score

Examples:
  fit4cad export labelled.ply --to csv,glb
  fit4cad fit --method ht --out found scan.xyz && fit4cad export scan.xyz found --to ply,csv --out found

Exit code: 0 all written, 1 some input unusable, 2 called wrongly.
`;

const importParts = async () => `fit4cad import PATH… [--points N | --spacing MM] [options] [--out DIR] [--test SHARE] [--format table|json]

Makes a Fit4CAD model of every STEP file (AP203, AP214, AP242; ${CALLED}, also packed by
gzip) in the given files, folders and zips: points that lie exactly on its faces, in millimetres, and
the truth of which face each is of, in the benchmark's four files. A file that cannot be read does not
keep the others from being made; what is left out of a part is told.

${terms((await loadCad()).importOptions().map(({ name, value, explanation }) => [`--${name}${value.kind === "number" ? " N" : value.kind === "choice" ? ` ${value.words[0] ?? ""}` : ""}`, explanation]), 18)}${terms(WEAR.map((info) => [`--${info.name} N`, `${info.explanation} ${capitalised(rangeOf(info))}.`]), 18)}  --bodies N,N    only these bodies, by their numbers from 1 in the order of the file (default: all);
                  a number too many lists those there are
  --out DIR       where the files go (default: the current folder); made if missing
  --test SHARE    splits the models into DIR/training_set and DIR/test_set, by their names and the seed
  --format table  (default) one row per model
  --format json   (--json) for each model its source and files with their SHA-256, points, primitives of
                  each type, and what became of every face

Of more than one model, or with --test, DIR/manifest.json says how the set was made, with the SHA-256
of every source and result.

Examples:
  fit4cad import bracket.step --points 20000 --out bracket && fit4cad score bracket --self
  fit4cad import parts --spread random --noise 0.001 --test 0.2 --out set

Exit code: 0 all imported, 1 some input unusable, 2 called wrongly.
`;

const check = () => `fit4cad check PATH… [--format table|json] [--write DIR]

Checks every ground truth found in the given files, folders and zips: its files, and the points,
the parametric and the implicit form of each primitive against each other.

  --format table  (default) one row per finding
  --format json   (--json) for each model its findings, and the measurements of every primitive
  --write DIR     writes the surface files that need it with wrong vectors replaced by the exact
                  conversion of the form that fits; all other vectors keep every digit

Distances are shares of the diagonal of the box around a primitive's points. A finding is:
  parametric distance     the form is off the points: more than 0.1 % a warning, 1 % an error
  implicit distance
  surface distance        both forms agree, and are off the points
  stray point             a few points are off the surface on which all others lie
  agreement               the forms differ, though neither is off the points
  family                  a vector is no surface of its type (unequal radii, a quartic no torus)
  first-order distance    |f|/|∇f| of the implicit form misleads: a point lies at an apex
  type, vector, index, duplicate, numbering, point, syntax, file
                          what reading the files showed, with file, line and column

Findings go to stdout, what keeps files from being read to stderr.

Examples:
  fit4cad check training_set.zip
  fit4cad check dataset/training_set --format json | jq '.[] | select(.findings != [])'
  fit4cad check training_set.zip --write corrected

Exit code: 0 nothing worse than a note, 1 warnings, errors or unusable input, 2 called wrongly.
`;

const stats = () => `fit4cad stats PATH… [--format table|json|csv]

Counts the models found in the given files, folders and zips: points, true primitives by type, and
the share of points that no primitive lists.

  --format table  (default) a row per model, their spread, and the paper's bar chart of types
  --format json   (--json) the models and the set
  --format csv    one row per model, for a spreadsheet

Example:
  fit4cad stats training_set.zip

Exit code: 0 all counted, 1 some input unusable, 2 called wrongly.
`;

const degrade = () => `fit4cad degrade PATH… ${[...WEAR].map(({ name }) => `[--${name} N]`).join(" ")} [--seed N] [--out DIR]
fit4cad degrade PATH… --set NAME [--out DIR]

Makes worse scans of the models found in the given files, folders and zips, with their truth on the
points that are left. The same model, options and seed give the same files everywhere.

${terms(WEAR.map((info) => [`--${info.name} N`, `${info.explanation} ${capitalised(rangeOf(info))}.`]), 16)}${terms([["--seed N", "Of everything random (default 1)."]], 16)}${terms(setsOf().sets.flatMap(({ id, degraded, title }) => (degraded ? [[`--set ${id}`, `${title}: ${wearWords(degraded)}`]] : [])), 26)}  --out DIR     where the files go, laid out as the public test set (default: the current folder)

Example:
  fit4cad degrade dataset/test_set --noise 0.002 --seed 7 --out noisy
`;

const submit = () => `fit4cad submit PATH… --set NAME --to results/METHOD [--method NAME] [--times FILE] [--format table|json]

Checks a submission to the standing table as the table will, step by step, scores it by every protocol
and writes its folder for a pull request: scores.json, and a method.toml to be filled in where there is
none. Other sets that the folder has already are kept. The files given hold clouds, truth and answers;
answers lie in folders named after the method. Every model of the set has to be answered.

${terms(setsOf().sets.map(({ id, title }) => [`--set ${id}`, title]), 26)}  --to results/METHOD     the folder; its name is the row's address, in small letters, digits and hyphens
  --method NAME           whose answers are meant, where there are several
  --times FILE            seconds by model: what fit4cad fit --json printed, or a list of the same shape

Example:
  fit4cad submit dataset/test_set my_answers --set test-10 --to results/my-method

Exit code: 0 written and whole, 1 something is missing or wrong, 2 called wrongly.
`;

const verify = () => `fit4cad verify results/METHOD… --data PATH [--answers PATH] [--set NAME] [--format table|json]

Scores again what folders of the standing table claim and compares every digit. Files are known by
their SHA-256, whatever they are called; models of degraded sets and answers of this playground's own
fitters are made here. A mismatch names the model, what is claimed and what was found.

  --data PATH     the public data: a folder or zip; may be repeated
  --answers PATH  the answers, where they are neither in the public data nor made here; may be repeated
  --set NAME      only this set; may be repeated

Example:
  fit4cad verify results/fit4cad-ht --data Fit4CAD-main.zip

Exit code: 0 every digit the same, 1 not, 2 called wrongly.
`;

/** The formats of results, from a column on. @param {number} column */
function formatHelp(column) {
  const entries = Object.entries(FORMATS).map(([name, { what }], place) => {
    const short = place === 0 ? "(default) " : name === "json" ? "(--json) " : "";
    return /** @type {const} */ ([`--format ${name}`, short + what]);
  });
  return terms(entries, column);
}

/** The endings after the first. @param {readonly string[]} endings */
function others([, ...more]) {
  return more.length === 0 ? "" : ` (also ${more.map((ending) => `.${ending}`).join(" ")})`;
}

/** @param {string} text */
function capitalised(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

export const HELP = { fit4cad, score, fit, export: exportFiles, import: importParts, check, stats, generate, degrade, submit, verify };
