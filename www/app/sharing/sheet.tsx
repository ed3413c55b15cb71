// Everything that leaves the page, by the reader's own hand.

import type { JSX } from "preact";
import { CommandSection } from "../export/command-section";
import { SubmissionSection } from "../export/submission-section";
import { TablesSection } from "../export/tables-section";
import { scoredRows } from "../state/models";
import { LinkSection } from "./link-section";

export default function ShareSheet(): JSX.Element {
  if (scoredRows.value.length === 0) {
    return <p class="empty">There are no results yet to share or save. Add a ground truth and a submission first.</p>;
  }
  return (
    <>
      <LinkSection />
      <TablesSection />
      <SubmissionSection />
      <CommandSection />
    </>
  );
}
