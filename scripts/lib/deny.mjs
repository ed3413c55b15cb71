// What the crates come with: licences, sources, versions twice over, known faults. By cargo-deny, built
// for this checkout when first asked for.

import { TOOLS, tool } from "./paths.mjs";
import { Failed, ask, run, say } from "./run.mjs";

const VERSION = "0.20.2";
/** How cargo-deny says that it could not fetch the list of faults. */
const OUT_OF_REACH = /failed to fetch advisory database|failed to get 'FETCH_HEAD' metadata/;

export async function denyCrates() {
  await installDeny();
  await run(tool("cargo-deny"), ["check", "licenses", "bans", "sources"]);
  try {
    await run(tool("cargo-deny"), ["check", "advisories"], { capture: true });
  } catch (error) {
    if (!(error instanceof Failed && OUT_OF_REACH.test(error.output))) {
      throw error;
    }
    say("known faults were not looked up: their list (github.com/RustSec/advisory-db) is out of reach");
  }
}

async function installDeny() {
  if (ask(tool("cargo-deny"), ["--version"]) === `cargo-deny ${VERSION}`) {
    return;
  }
  // Unoptimised: it takes a third of the time to build, and a second to run.
  say(`building cargo-deny ${VERSION} into .tools (once, a few minutes)`);
  await run("cargo", [
    ...["install", "cargo-deny", "--locked", "--force", "--debug"],
    ...["--version", VERSION, "--root", TOOLS],
  ]);
}
