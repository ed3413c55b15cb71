// What `--help` teaches.

import { parameterHelp } from "./parameters.mjs";

const fit4cad = () => `fit4cad: fit, score and make segmentations of CAD point clouds, as the Fit4CAD benchmark does

  fit4cad score PATH…       score submissions against the ground truth
  fit4cad fit PATH…         find the primitives of clouds, with method HT or PG
  fit4cad check PATH…       find errors in a ground truth, and correct them
  fit4cad stats PATH…       count what a set of models holds
  fit4cad generate PART     make a model with known ground truth
  fit4cad generate --list   the parts it can make
  fit4cad COMMAND --help    what a command reads, prints and means
  fit4cad --version

score, fit, check and stats print a table; with --format json, or --json for short, they print all
they know, for programs.

Try it on a model of your own making:
  fit4cad generate --list
  fit4cad generate flange --out demo
  fit4cad score demo --self

Exit code: 0 all well, 1 some input was unusable (the rest was scored), 2 called wrongly.
`;

const score = () => `fit4cad score PATH… [--protocol definition|published] [--format FORMAT] [--self] [--as …]

Scores every submission found in the given files, folders and zips against the ground truth found
beside it. Files belong to one model by their names:

  PC14.txt                       the cloud
  PC14_primitives.txt            which points make up each primitive
  PC14_parametric.txt            each primitive's surface, parametric form
  PC14_implicit.txt              each primitive's surface, implicit form

A folder whose name ends in a method's (pointCloud_primitives_HT) or is one (HT/) holds that
method's submission; files in other folders are the truth. One of the two surface files is enough.

  --protocol definition   (default) the formulas of the Fit4CAD paper, computed exactly
  --protocol published    what the authors' scripts compute, to set a score beside the paper's
                          tables. Note: those scripts swap prediction and truth, so the columns
                          PPV and TPR hold each other's values, and so do TNR and NPV. True
                          negatives are counted among the points listed by the truth only, and
                          the mean of d1 counts missing primitives as perfect.
  --format table          (default) one aligned row per model and method
  --format json           (--json) everything, with one entry per primitive and the diagnostics
  --format csv            one row per model and method, for a spreadsheet
  --format latex          a booktabs table like the paper's
  --format markdown       a table for a README or a discussion
  --self                  scores the truth against itself, as method "truth"
  --as role=R,model=M,method=N:FILE
                          FILE is R (cloud, primitives, parametric, implicit) of model M, found by
                          method N (empty: the truth), whatever its name says; each of the three
                          may be left out, and the option may be repeated

Measures, each the mean over primitives; n/a (null in JSON) where one cannot be had:
  DSC PPV TPR TNR NPV ACC  agreement of the point sets: Dice, precision, recall, specificity,
                           negative predictive value, accuracy; 1 is best
  MFE dHaus                mean and largest distance of a predicted primitive's points to its
                           predicted surface, over the diagonal of their bounding box; 0 is best
  d1                       distance of the predicted and the true implicit coefficients; 0 is best
  type errors              predictions whose type differs from the truth's: they have no d1

All formats but the table carry the engine's version, the protocol and the SHA-256 of each file read.

Results go to stdout. What is wrong with the input goes to stderr, with file, line and column; in
JSON it is part of the output. A broken entry does not keep the rest of a file from being scored.

Examples:
  fit4cad score Fit4CAD-main.zip
  fit4cad score dataset/test_set my_results/pointCloud_primitives_MINE --format csv > scores.csv
  fit4cad score . --protocol published --format json | jq '.[].mean.DSC'

Exit code: 0 all scored, 1 some input unusable, 2 called wrongly.
`;

const generate = () => `fit4cad generate PART [--seed N] [--spacing S] [--noise σ] [--outliers f] [--missing f] [--imperfect]
                      [--name NAME] [--out DIR]
fit4cad generate --list

Makes a CAD-like part with its ground truth: the four files of a Fit4CAD model. The same options
always give the same files. S and σ are shares of the diagonal of the part's bounding box.

  --list        the parts, with what each is good for
  --seed N      of everything random (default 1)
  --spacing S   distance between neighbouring points (default that of the benchmark's clouds)
  --noise σ     standard deviation of the noise added to each coordinate
  --outliers f  points of no primitive for each point of the part, 0 to 1
  --missing f   share of the points cut away in balls and half-spaces, 0 to 0.95
  --imperfect   also a submission that is wrong in common ways, so that there is something to score
  --name NAME   what the model is called (default: as its part)
  --out DIR     where the files go (default: the current folder); made if missing

Example:
  fit4cad generate flange --noise 0.001 --out demo && fit4cad score demo --self
`;

async function fit() {
  return `fit4cad fit --method ht|pg [--out DIR] [--format table|json] [--seed N] [parameters] PATH…

Finds the primitives of every cloud in the given files, folders and zips: which points make up each,
and its surface. Only the clouds (PC14.txt) are read; truth and submissions beside them are not.

  --method ht     HT: votes in the space of a surface's parameters, a Hough transform
  --method pg     PG: growing from neighbourhoods
  --out DIR       writes each model's primitives, parametric and implicit file, in the folders
                  DIR/pointCloud_primitives_HT and so on, where fit4cad score finds them
  --format table  (default) one row per model
  --format json   (--json) one entry per model: name, points, seconds of fitting (without reading),
                  and type, points and mean fitting error of each primitive
  --seed N        of everything random (default 1); the same seed gives the same primitives

Parameters, with the values allowed and the default:
${await parameterHelp()}
Examples:
  fit4cad fit --method ht PC14.txt
  fit4cad fit --method pg --out found Fit4CAD-main.zip && fit4cad score Fit4CAD-main.zip found
  fit4cad fit --method ht --tolerance 0.001 --json scans | jq '.[].primitives | length'

Exit code: 0 all fitted, 1 some input unusable, 2 called wrongly.
`;
}

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

export const HELP = { fit4cad, score, fit, check, stats, generate };
