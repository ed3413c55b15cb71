// Everything that leaves the page, by the reader's own hand.

import type { JSX } from "preact";

import { CommandSection } from "../export/command-section";
import { FormsSection, segmentationsOf } from "../export/forms-section";
import { SubmissionSection } from "../export/submission-section";
import { TablesSection } from "../export/tables-section";
import { modelById, scoredRows } from "../state/models";
import { selectedModel } from "../state/selection";
import { LinkSection } from "./link-section";

export default function ShareSheet(): JSX.Element {
  if (scoredRows.value.length === 0) {
    if (segmentationsOf(modelById(selectedModel.value)).length > 0) {
      return (
        <>
          <p>There is no score to share yet: that takes a ground truth and a submission. What is there can be saved.</p>
          <FormsSection />
          <SubmissionSection />
        </>
      );
    }
    return (
      <p class="empty">
        There are no results yet to share or save. Fit the cloud, or add a ground truth or a submission first.
      </p>
    );
  }
  return (
    <>
      <LinkSection />
      <TablesSection />
      <SubmissionSection />
      <FormsSection />
      <CommandSection />
    </>
  );
}
