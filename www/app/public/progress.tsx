// How far a download has come, with a way to stop it.

import type { JSX } from "preact";
import { bytes, integer } from "../ui/format";
import { download, stopDownload } from "./download";

/** Shown in two places; `id` tells them apart. */
export function DownloadProgress({ id }: { id: string }): JSX.Element | null {
  const now = download.value;
  if (!now) return null;
  const { what, unit, done, total, bytes: size } = now;
  return (
    <div class="work">
      <button type="button" onClick={stopDownload}>
        Stop the download
      </button>
      <progress id={id} {...(total === undefined ? {} : { max: total, value: Math.min(done, total) })} />
      <label for={id}>
        Downloading {what}: {unit === "files" && total !== undefined && `${integer(done)} of ${integer(total)} files, `}
        {bytes(size)}
      </label>
      {total !== undefined && (
        <span class="visually-hidden" role="status">
          {/* Every figure read out would drown everything else. */}
          Downloading, {25 * Math.floor((4 * Math.min(done, total)) / total)} % done
        </span>
      )}
    </div>
  );
}
