// The blocks of a part, each with its numbers.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { SHAPES } from "../../generated/declared/shapes.js";
import { capitalised } from "../ui/format";
import { blockOf, inserted, moved, removed, replaced, reshaped, withAxis } from "./blocks";
import { MAX_BLOCKS, type Block } from "./case";
import { NumberField } from "./number-field";
import { edit } from "./state";

const AXES = ["x", "y", "z"] as const;

export function BlockList({ blocks }: { blocks: readonly Block[] }): JSX.Element {
  const open = useSignal<number | undefined>(undefined);
  const shape = useSignal("cuboid");
  const set = (next: readonly Block[], name: string, merge?: string) => edit({ base: { kind: "blocks", blocks: next } }, name, merge);

  return (
    <>
      <ol class="blocks">
        {blocks.map((block, place) => (
          <li key={place}>
            <BlockItem
              block={block}
              place={place}
              open={open.value === place}
              onToggle={() => (open.value = open.value === place ? undefined : place)}
              onChange={(next, what) => set(replaced(blocks, place, next), `Change block ${place + 1}`, `block ${place} ${what}`)}
            />
            {open.value === place && (
              <div class="row">
                <button
                  type="button"
                  disabled={place === 0}
                  onClick={() => {
                    open.value = place - 1;
                    set(moved(blocks, place, -1), `Move block ${place + 1} up`);
                  }}
                >
                  Earlier
                </button>
                <button
                  type="button"
                  disabled={place === blocks.length - 1}
                  onClick={() => {
                    open.value = place + 1;
                    set(moved(blocks, place, 1), `Move block ${place + 1} down`);
                  }}
                >
                  Later
                </button>
                <button
                  type="button"
                  disabled={blocks.length >= MAX_BLOCKS}
                  onClick={() => {
                    open.value = place + 1;
                    set(inserted(blocks, place + 1, block), `Copy block ${place + 1}`);
                  }}
                >
                  Copy
                </button>
                <button
                  type="button"
                  disabled={blocks.length === 1}
                  onClick={() => {
                    open.value = undefined;
                    set(removed(blocks, place), `Remove block ${place + 1}`);
                  }}
                >
                  Remove
                </button>
              </div>
            )}
          </li>
        ))}
      </ol>
      <div class="row">
        <select aria-label="Shape of the new block" value={shape.value} onChange={(event) => (shape.value = event.currentTarget.value)}>
          {SHAPES.map(({ name, title }) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
        <button
          type="button"
          disabled={blocks.length >= MAX_BLOCKS}
          onClick={() => {
            const info = SHAPES.find(({ name }) => name === shape.value);
            if (!info) return;
            open.value = blocks.length;
            set([...blocks, blockOf(info)], `Add a ${info.title.toLowerCase()}`);
          }}
        >
          Add block
        </button>
      </div>
    </>
  );
}

interface ItemProps {
  readonly block: Block;
  readonly place: number;
  readonly open: boolean;
  readonly onToggle: () => void;
  readonly onChange: (next: Block, what: string) => void;
}

function BlockItem({ block, place, open, onToggle, onChange }: ItemProps): JSX.Element {
  const info = SHAPES.find(({ name }) => name === block.shape);
  const of = `block ${place + 1}`;
  return (
    <>
      <button type="button" class="block-name" aria-expanded={open} onClick={onToggle}>
        <span>
          {block.operation === "add" ? "+" : "−"} {info?.title ?? block.shape}
        </span>
        <span class="hint">{summary(block)}</span>
      </button>
      {open && (
        <div class="studio-fields">
          <label>
            <span>Does</span>
            <select
              aria-label={`What ${of} does`}
              value={block.operation}
              onChange={(event) => onChange({ ...block, operation: event.currentTarget.value === "cut" ? "cut" : "add" }, "operation")}
            >
              <option value="add">add</option>
              <option value="cut">cut away</option>
            </select>
          </label>
          <label class="two">
            <span>Shape</span>
            <select
              aria-label={`Shape of ${of}`}
              value={block.shape}
              onChange={(event) => {
                const next = SHAPES.find(({ name }) => name === event.currentTarget.value);
                if (next) onChange(reshaped(block, info, next), "shape");
              }}
            >
              {SHAPES.map(({ name, title }) => (
                <option key={name} value={name}>
                  {title}
                </option>
              ))}
            </select>
          </label>
          {(info?.sizes ?? []).map((name, at) => (
            <NumberField
              key={name}
              label={capitalised(name)}
              name={`${name} of ${of}`}
              value={block.sizes[at] ?? 0}
              min={0}
              onValue={(value) => onChange({ ...block, sizes: replaced(block.sizes, at, value) }, name)}
            />
          ))}
          <Vectors block={block} of={of} which="position" title="Position" onChange={onChange} />
          <Vectors block={block} of={of} which="rotation" title="Turned about" onChange={onChange} />
        </div>
      )}
    </>
  );
}

interface VectorProps {
  readonly block: Block;
  readonly of: string;
  readonly which: "position" | "rotation";
  readonly title: string;
  readonly onChange: ItemProps["onChange"];
}

function Vectors({ block, of, which, title, onChange }: VectorProps): JSX.Element {
  return (
    <div class="studio-fields triple">
      {AXES.map((axis, at) => (
        <NumberField
          key={axis}
          label={at === 0 ? `${title} ${axis}` : axis}
          name={`${which} ${axis} of ${of}`}
          value={block[which][at] ?? 0}
          step={which === "rotation" ? 15 : 1}
          hint={which === "rotation" ? "Degrees, about x, then y, then z" : undefined}
          onValue={(value) => onChange({ ...block, [which]: withAxis(block[which], at, value) }, `${which} ${axis}`)}
        />
      ))}
    </div>
  );
}

function summary({ sizes, position, rotation }: Block): string {
  const turned = rotation.some((angle) => angle !== 0) ? `, turned ${rotation.join(" ")}°` : "";
  return `${sizes.join(" × ")} at ${position.join(" ")}${turned}`;
}
