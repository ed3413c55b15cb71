// The Python package: built into wheels, and tested from one in a virtual environment of this checkout.

import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT, TOOLS } from "./paths.mjs";
import { Failed, Plain, ask, run, say } from "./run.mjs";
import { Skipped } from "./steps.mjs";

const OLDEST = [3, 9];
const MANIFEST = join(ROOT, "crate/python/Cargo.toml");
const WHEELS = join(ROOT, "target/wheels");
const VENV = join(TOOLS, "python");

/** What builds and tests; without it nothing is done. */
const NEEDED = ["maturin==1.16.0", "numpy", "pytest"];
/** What some results and tests are for; those tests skip where it is not to be had. */
const WELCOME = ["pandas", "pyarrow", "dask[distributed]", "tqdm", "matplotlib", "nbclient", "nbformat", "ipykernel", "h5py"];

/**
 * A command of a virtual environment.
 * @param {string} name
 * @param {string} venv
 */
function own(name, venv = VENV) {
  const [folder, ending] = process.platform === "win32" ? ["Scripts", ".exe"] : ["bin", ""];
  return join(venv, folder, name + ending);
}

/** The Python of the checkout's own environment, which has the wheel that was built last. */
export function pythonOf() {
  return own("python");
}

/** A Python that can make virtual environments, as the words that start it; undefined where there is none. */
function findPython() {
  const given = process.env.FIT4CAD_PYTHON;
  const candidates = given ? [[given]] : [["python3"], ["python"], ["py", "-3"]];
  const script = `import sys, venv, ensurepip; sys.exit(sys.version_info < (${OLDEST.join(", ")}))`;
  return candidates.find(([command = "", ...args]) => ask(command, [...args, "-c", script]) !== undefined);
}

/** Makes the environment, or brings it up to date. Throws `Skipped` where there is no Python, or no way to packages. */
async function prepare() {
  const stamp = createHash("sha256").update([...NEEDED, ...WELCOME].join(" ")).digest("hex");
  const mark = join(VENV, ".stamp");
  if (existsSync(mark) && readFileSync(mark, "utf8") === stamp && ask(own("python"), ["--version"]) !== undefined) return;
  const python = findPython();
  if (python === undefined) {
    throw new Skipped(`there is no Python of at least ${OLDEST.join(".")} with venv; FIT4CAD_PYTHON names one`);
  }
  say("making a virtual environment for Python in .tools/python (once, a minute)");
  rmSync(VENV, { recursive: true, force: true });
  const [command = "", ...args] = python;
  await run(command, [...args, "-m", "venv", VENV]);
  const install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--retries", "2"];
  try {
    await run(own("python"), [...install, ...NEEDED], { capture: true });
  } catch (error) {
    if (error instanceof Failed) throw new Skipped("the packages that build it could not be had from PyPI");
    throw error;
  }
  try {
    await run(own("python"), [...install, ...WELCOME], { capture: true });
    writeFileSync(mark, stamp);
  } catch (error) {
    if (!(error instanceof Failed)) throw error;
    say("some packages could not be had from PyPI: what needs them is not tested");
  }
}

/**
 * Builds a wheel and puts it into the environment; gives its path.
 * @param {"dev" | "wheel"} profile `dev` shares what the Rust tests have built; `wheel` is what is handed on
 */
export async function buildWheel(profile) {
  await prepare();
  const folder = join(WHEELS, profile);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const build = ["build", "--manifest-path", MANIFEST, "--locked", "--quiet", "--profile", profile, "--out", folder];
  await run(own("maturin"), [...build, "--interpreter", own("python")]);
  const [name] = readdirSync(folder).filter((file) => file.endsWith(".whl"));
  if (name === undefined) throw new Plain("maturin made no wheel");
  const wheel = join(folder, name);
  await run(own("python"), ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--force-reinstall", "--no-deps", wheel]);
  return wheel;
}

/** Tests the package as it is installed from a wheel. */
export async function testPython() {
  await buildWheel("dev");
  return pytest(own("python"), true);
}

/**
 * Tests a wheel as somebody has it who installs it: in a fresh environment, with what it asks for and no more.
 * @param {string} wheel
 */
export async function testWheel(wheel) {
  const clean = join(WHEELS, "clean");
  const python = own("python", clean);
  rmSync(clean, { recursive: true, force: true });
  await run(own("python"), ["-m", "venv", clean]);
  await run(python, ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", wheel, "pytest"]);
  return pytest(python, false);
}

/**
 * @param {string} python whose packages are tested
 * @param {boolean} capture whether what the tests say is given back, and not shown
 */
function pytest(python, capture) {
  // Outside the sources, so that what is imported is what the wheel put there.
  return run(python, ["-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider", join(ROOT, "crate/python/tests")], {
    capture,
    cwd: join(ROOT, "target"),
    env: { FIT4CAD_NODE: process.execPath, PYTHONDONTWRITEBYTECODE: "1" },
  });
}
