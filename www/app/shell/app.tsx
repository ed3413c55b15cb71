// The frame around every page.

import type { JSX } from "preact";
import { AboutDialog } from "../about/dialog";
import { ExplainPopover } from "../measures/explain";
import { AddDialog } from "../intake/add-dialog";
import { DropZone } from "../intake/dropzone";
import { KeyDialog } from "../keyboard/dialog";
import { PictureDialog } from "../picture/dialog";
import { ProtocolDialog } from "../measures/protocol-dialog";
import { SharedBanner } from "../sharing/banner-place";
import { ShareDialog } from "../sharing/dialog";
import { HOME, page } from "../state/router";
import { Lazy } from "../ui/lazy";
import { PageLink } from "../navigation/page-link";
import { Header } from "./header";
import { PAGES } from "./registry/pages";
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
      <PictureDialog />
      <KeyDialog />
      <AboutDialog />
      <ExplainPopover />
    </>
  );
}
