// The frame around every page.

import type { JSX } from "preact";
import { ExplainPopover } from "../measures/explain";
import { AddDialog } from "../intake/add-dialog";
import { DropZone } from "../intake/dropzone";
import { KEYS } from "../keyboard/keys";
import { KeySheet } from "../keyboard/sheet";
import { ProtocolDialog } from "../measures/protocol-dialog";
import { SharedBanner } from "../sharing/banner";
import { ShareDialog } from "../sharing/dialog";
import { Lazy } from "../ui/lazy";
import { Header } from "./header";
import { PAGES } from "./registry";
import { PageLink } from "./page-link";
import { HOME, page } from "./router";
import { StatusBar } from "./statusbar";

export function App(): JSX.Element {
  const current = PAGES.find(({ id }) => id === page.value);
  return (
    <>
      <a
        class="skip"
        href="#content"
        onClick={(event) => {
          // The fragment is taken: links keep results there.
          event.preventDefault();
          document.getElementById("content")?.focus();
        }}
      >
        Skip to content
      </a>
      <Header />
      <SharedBanner />
      <main id="content" tabIndex={-1}>
        {current ? (
          <Lazy key={current.id} load={current.load} title={current.title} />
        ) : (
          <p class="empty">
            There is no page “{page.value}” here. <PageLink id={HOME}>Back to the scores</PageLink>
          </p>
        )}
      </main>
      <StatusBar />
      <DropZone />
      <AddDialog />
      <ShareDialog />
      <ProtocolDialog />
      <KeySheet groups={KEYS} />
      <ExplainPopover />
    </>
  );
}
