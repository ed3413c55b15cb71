import { render } from "preact";
import { listenForDrops } from "./intake/dropzone";
import { listen } from "./keyboard/shortcuts";
import { keepForOfflineLater } from "./offline/register";
import { KEYS } from "./keyboard/keys";
import { heedAddress } from "./sharing/share";
import { App } from "./shell/app";
import { openFirst, openNamed } from "./shell/opening";
import { PAGES } from "./shell/registry";
import { page } from "./shell/router";
import { fetchAhead, Lazy } from "./ui/lazy";
import "../styles/index.css";

const embedded = new URLSearchParams(location.search).has("embed");
const loadEmbed = () => import("./shell/embed");

const root = document.getElementById("app");
if (root) {
  heedAddress();
  if (embedded) {
    render(<Lazy load={loadEmbed} title="the results" />, root);
    void openNamed();
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
