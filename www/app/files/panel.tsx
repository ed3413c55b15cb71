// Which file plays which part in which model, and correcting it by hand.

import type { JSX } from "preact";
import { computed, signal } from "@preact/signals";
import { ROLES } from "../../generated/declared/roles.js";
import type { Override, Role } from "../engine/contract";
import { clear, remove } from "../state/contents";
import { brought, ignored, override, overrides, unplaced } from "../state/inbox";
import { keeping } from "../state/kept";
import { modelById, models } from "../state/models";
import { selectedModel } from "../state/selection";
import * as format from "../ui/format";
import { Seen, type Place } from "../ui/seen";

interface FileRow {
  readonly path: string;
  readonly model: string;
  readonly role: Role | undefined;
  readonly method: string | undefined;
  readonly size: number;
  readonly reason?: string;
  /** Made here, hence nothing to correct. */
  readonly made: boolean;
}

/** Whether the files of every model are listed, not of the selected one alone. */
const everyModel = signal(false);

const rows = computed<readonly FileRow[]>(() => {
  const shown = everyModel.value ? models.value : models.value.filter(({ id }) => id === selectedModel.value);
  const placed = shown.flatMap(({ id, source }) =>
    source.files.map(
      ({ path, role, method, data }): FileRow => ({
        path,
        model: id,
        role,
        method,
        size: data.size,
        made: !brought.value.has(path),
      }),
    ),
  );
  const rest = unplaced.value.map(
    ({ path, reason }): FileRow => ({
      path,
      model: "",
      role: undefined,
      method: undefined,
      size: brought.value.get(path)?.data.size ?? 0,
      reason,
      made: !brought.value.has(path),
    }),
  );
  return [...rest.slice(0, UNPLACED_AT_MOST), ...placed];
});

/** More of those that belong nowhere would not be read, and would slow the page. */
const UNPLACED_AT_MOST = 500;

export default function FilesPanel(): JSX.Element {
  const entry = modelById(selectedModel.value);
  const more = unplaced.value.length - UNPLACED_AT_MOST;
  return (
    <div class="files">
      <div class="panel-tools">
        <p>
          {unplaced.value.length > 0 ? `${format.plural(unplaced.value.length, "file")} not placed` : "Every file belongs to a model"}
          {ignored.value > 0 && `, ${format.plural(ignored.value, "litter file")} ignored`}
          <Kept />
        </p>
        {models.value.length > 1 && (
          <label class="check">
            <input type="checkbox" checked={everyModel.value} onChange={(event) => (everyModel.value = event.currentTarget.checked)} />
            All {format.plural(models.value.length, "model")}
          </label>
        )}
        {entry && (
          <button type="button" onClick={() => remove(entry.id)}>
            Remove {entry.id}
          </button>
        )}
        <button type="button" onClick={clear}>
          Remove everything
        </button>
      </div>
      {rows.value.length === 0 ? (
        <p class="empty">No files.</p>
      ) : (
        <table>
          <caption>{caption(entry?.id)}</caption>
          <thead>
            <tr>
              <th scope="col">File</th>
              <th scope="col">Model</th>
              <th scope="col">Is</th>
              <th scope="col">Method (empty: truth), indices</th>
              <th scope="col" class="numeric">
                Size
              </th>
              <th scope="col">Correction</th>
            </tr>
          </thead>
          <Seen as="tbody" items={rows.value} columns={COLUMNS} draw={(row, place) => <Row key={`${row.model} ${row.path}`} row={row} place={place} />} />
        </table>
      )}
      {more > 0 && <p class="empty">… and {format.plural(more, "file")} more that belong to no model.</p>}
    </div>
  );
}

/** File, model, what it is, method, size, correction. */
const COLUMNS = 6;

function caption(model: string | undefined): string {
  if (everyModel.value && models.value.length > 1) return "Files of every model, after those that belong to none";
  return model === undefined ? "Files" : `Files of ${model}, and those that belong to no model`;
}

/** Whether all this is there again after the page is left. */
function Kept(): JSX.Element | null {
  const state = keeping.value;
  if (state.kind === "off") return null;
  const words = state.kind === "refused" ? state.why : `Kept in this browser until you remove it: ${format.bytes(state.bytes)}.`;
  return <small class="kept">{words}</small>;
}

function Row({ row, place }: { row: FileRow; place: Place }): JSX.Element {
  const { path, model, role, method, size, reason, made } = row;
  const corrected = overrides.value[path];
  const change = (part: Override) => override(path, { ...corrected, ...part });
  return (
    <tr {...place} class={reason ? "unplaced" : undefined}>
      <th scope="row">
        <code>{path}</code>
        {reason && <p class="hint">{reason}</p>}
      </th>
      <td>
        {made ? (
          model
        ) : (
          <input
            type="text"
            aria-label={`Model of ${path}`}
            value={corrected?.model ?? model}
            onChange={(event) => change({ model: event.currentTarget.value.trim() })}
          />
        )}
      </td>
      <td>
        {made ? (
          role
        ) : (
          <select
            aria-label={`What ${path} is`}
            value={role ?? ""}
            onChange={(event) => change({ role: event.currentTarget.value as Role })}
          >
            {role === undefined && <option value="">unknown</option>}
            {ROLES.map(({ name }) => (
              <option key={name} value={name}>
                {name}
              </option>
            ))}
          </select>
        )}
      </td>
      <td>
        {made ? (
          (method ?? "truth")
        ) : (
          <input
            type="text"
            aria-label={`Method of ${path}`}
            value={method ?? ""}
            onChange={(event) => change({ method: event.currentTarget.value.trim() })}
          />
        )}
        {!made && role === "primitives" && (
          <label class="counts-from">
            from{" "}
            <select
              aria-label={`What the indices of ${path} count from`}
              value={String(corrected?.first ?? 1)}
              onChange={(event) => change({ first: Number(event.currentTarget.value) })}
            >
              <option>1</option>
              <option>0</option>
            </select>
          </label>
        )}
      </td>
      <td class="numeric">{format.bytes(size)}</td>
      <td>
        {corrected && (
          <button type="button" class="link" onClick={() => override(path, {})}>
            Undo
          </button>
        )}
      </td>
    </tr>
  );
}
