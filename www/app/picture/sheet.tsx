// Size, background and legend of a picture, with a preview of it.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { download } from "../export/download";
import { withText } from "../export/png";
import { provenanceOf } from "../export/provenance";
import { currentView, picturing } from "../stage/current";
import { colourMode, sides } from "../stage/display";
import { reports } from "../stage/reports";
import { notify } from "../state/notices";
import { scene } from "../state/scene";
import { selectedModel, selectedPrimitive } from "../state/selection";
import { remembered } from "../state/settings";
import { compose, type Background, type Subject, type Wish } from "./compose";

/** A larger side than this is beyond what some graphics cards and browsers make. */
const LARGEST = 8192;
const LEAST = 160;
/** Sixty-four bits a pixel while it is made. */
const MOST_PIXELS = 34e6;
/** As wide as the sheet, in pixels of the page. */
const PREVIEW_WIDTH = 790;

const BACKGROUNDS: readonly { readonly id: Background; readonly title: string }[] = [
  { id: "white", title: "White" },
  { id: "transparent", title: "Transparent" },
  { id: "dark", title: "Dark" },
];

const background = remembered<Background>("picture-background", "white", BACKGROUNDS.map(({ id }) => id));
const legend = remembered("picture-legend", "on", ["on", "off"] as const);

export default function PictureSheet(): JSX.Element {
  const canvas = currentView.value?.canvas;
  const width = useSignal(Math.min(LARGEST, 2 * (canvas?.clientWidth ?? 640)));
  const height = useSignal(Math.min(LARGEST, 2 * (canvas?.clientHeight ?? 400)));
  const busy = useSignal(false);
  const tooLarge = width.value * height.value > MOST_PIXELS;
  const wish: Wish = { width: width.value, height: height.value, background: background.value, legend: legend.value === "on" };
  const subject = subjectNow();
  if (!subject) return <p class="empty">There are no points in view.</p>;

  const save = async () => {
    const view = currentView.peek();
    if (!view) return;
    busy.value = true;
    try {
      const [file, provenance] = await Promise.all([compose(view, subject, wish), provenanceOf([subject.model])]);
      download(`${subject.model}-${subject.mode}.png`, await withText(file, "fit4cad", JSON.stringify(provenance)));
      picturing.value = false;
    } catch (error) {
      notify(`The picture could not be made: ${error instanceof Error ? error.message : String(error)}`, "error");
    } finally {
      busy.value = false;
    }
  };

  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        void save();
      }}
    >
      <Preview subject={subject} wish={wish} />
      <div class="row">
        <Side label="Width" value={width} />
        <Side label="Height" value={height} />
        <span class="hint">pixels</span>
        {[1, 2, 4].map((factor) => (
          <button
            key={factor}
            type="button"
            onClick={() => {
              width.value = Math.min(LARGEST, factor * (canvas?.clientWidth ?? 640));
              height.value = Math.min(LARGEST, factor * (canvas?.clientHeight ?? 400));
            }}
          >
            {factor === 1 ? "As on screen" : `× ${factor}`}
          </button>
        ))}
      </div>
      <div class="row">
        <fieldset class="switch">
          <legend class="visually-hidden">Background</legend>
          {BACKGROUNDS.map(({ id, title }) => (
            <label key={id}>
              <input type="radio" name="picture-background" checked={id === background.value} onChange={() => (background.value = id)} />
              <span>{title}</span>
            </label>
          ))}
        </fieldset>
        <label class="check">
          <input
            type="checkbox"
            checked={legend.value === "on"}
            onChange={(event) => (legend.value = event.currentTarget.checked ? "on" : "off")}
          />
          With legend
        </label>
      </div>
      {tooLarge && (
        <p class="mark error" role="alert">
          That is more than {MOST_PIXELS / 1e6} million pixels. Choose a smaller size.
        </p>
      )}
      <button type="submit" class="primary" disabled={busy.value || tooLarge}>
        Save PNG
      </button>
    </form>
  );
}

function subjectNow(): Subject | undefined {
  const state = scene.value;
  const model = selectedModel.value;
  if (state.kind !== "ready" || model === undefined || !currentView.value) return undefined;
  return {
    model,
    mode: colourMode.value,
    sides: sides.value,
    scene: state.scene,
    reports: reports.value,
    selected: selectedPrimitive.value,
  };
}

function Side({ label, value }: { label: string; value: { value: number } }): JSX.Element {
  return (
    <label>
      {label}{" "}
      <input
        type="number"
        inputMode="numeric"
        required
        min={LEAST}
        max={LARGEST}
        step={1}
        value={value.value}
        onInput={({ currentTarget }) => {
          if (currentTarget.validity.valid) value.value = currentTarget.valueAsNumber;
        }}
      />
    </label>
  );
}

/** The same picture, as wide as the sheet. */
function Preview({ subject, wish }: { subject: Subject; wish: Wish }): JSX.Element {
  const address = useSignal("");
  const { width, height, background, legend } = wish;
  useEffect(() => {
    const view = currentView.peek();
    if (!view) return;
    let wanted = true;
    compose(view, subject, wish, Math.min(1, (PREVIEW_WIDTH * devicePixelRatio) / Math.max(width, height))).then(
      (file) => {
        if (!wanted) return;
        URL.revokeObjectURL(address.peek());
        address.value = URL.createObjectURL(file);
      },
      () => undefined,
    );
    return () => {
      wanted = false;
    };
  }, [width, height, background, legend, subject.scene]);
  useEffect(() => () => URL.revokeObjectURL(address.peek()), []);
  return (
    <div class="preview" data-background={background}>
      {address.value && <img src={address.value} alt={`Preview: ${subject.model}`} />}
    </div>
  );
}
