import { render } from "preact";
import { listen } from "./keyboard/shortcuts";
import { KEYS } from "./keyboard/keys";
import { openFirstSample } from "./samples/samples";
import { App } from "./shell/app";
import "../styles/index.css";

const root = document.getElementById("app");
if (root) {
  render(<App />, root);
  listen(KEYS);
  void openFirstSample();
}
