import { render } from "preact";
import { listen } from "./keyboard/shortcuts";
import { keepForOffline } from "./offline/register";
import { KEYS } from "./keyboard/keys";
import { openData } from "./public/address";
import { openFirstSample } from "./samples/samples";
import { heedAddress, openAddress } from "./sharing/share";
import { App } from "./shell/app";
import { Lazy } from "./ui/lazy";
import "../styles/index.css";

const embedded = new URLSearchParams(location.search).has("embed");
const loadEmbed = () => import("./shell/embed");

const root = document.getElementById("app");
if (root) {
  heedAddress();
  if (embedded) {
    render(<Lazy load={loadEmbed} title="the results" />, root);
    void openAddress();
  } else {
    render(<App />, root);
    listen(KEYS);
    void openAddress()
      .then((found) => (found ? undefined : openFirstSample()))
      // The sample is there to look at meanwhile, and makes room for what arrives.
      .then(openData);
  }
}

addEventListener("load", keepForOffline);
