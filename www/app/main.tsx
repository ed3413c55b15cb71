import { render } from "preact";
import { listenForDrops } from "./intake/dropzone";
import { listen } from "./keyboard/shortcuts";
import { keepForOfflineLater } from "./offline/register";
import { followScores } from "./scores/means";
import { heedAddress } from "./sharing/share";
import { App } from "./shell/app";
import { openFirst, openNamed } from "./shell/opening";
import { KEYS } from "./shell/keys";
import { PAGES } from "./shell/registry/pages";
import { sortBrought } from "./state/inbox";
import { heedHistory, page } from "./state/router";
import { openSelected } from "./state/scene";
import { scoreWaiting } from "./state/scoring";
import { keepSelection } from "./state/selection";
import { applyTheme, keepSettings } from "./state/settings";
import { fetchAhead, Lazy } from "./ui/lazy";
import "../styles/index.css";

/** What goes on as long as the page is open. */
const RUNNING = [
  applyTheme,
  keepSettings,
  heedHistory,
  heedAddress,
  sortBrought,
  keepSelection,
  scoreWaiting,
  followScores,
  openSelected,
];

const embedded = new URLSearchParams(location.search).get("embed");
// Each on its own: the bundler notes for a call what style sheets come with it.
const loadEmbed = () => import("./shell/embed");
const loadEmbeddedResults = () => import("./results/embed");

const root = document.getElementById("app");
if (root) {
  for (const start of RUNNING) start();
  if (embedded !== null) {
    render(<Lazy load={embedded === "results" ? loadEmbeddedResults : loadEmbed} title="the results" />, root);
    if (embedded !== "results") void openNamed();
  } else {
    listenForDrops();
    const first = PAGES.find(({ id }) => id === page.value);
    if (first) fetchAhead(first.load);
    render(<App />, root);
    listen(KEYS);
    openFirst(PAGES);
  }
}

addEventListener("load", keepForOfflineLater);
