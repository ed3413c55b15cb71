// Name, pages, and the switches that hold everywhere.

import type { JSX } from "preact";
import { aboutShown } from "../about/dialog";
import { adding } from "../intake/adding";
import { keysShown } from "../keyboard/shown";
import { ProtocolSwitch } from "../measures/protocol-switch";
import { sharing } from "../sharing/share";
import { page } from "../state/router";
import { nextTheme, theme, type Theme } from "../state/settings";
import { Icon, type IconName } from "../ui/icon";
import { PageLink } from "../navigation/page-link";
import { PAGES } from "./registry/pages";

/** Browsers leave a link where it is that is half in sight. */
function intoSight({ target }: FocusEvent): void {
  if (target instanceof Element) target.scrollIntoView({ block: "nearest", inline: "nearest" });
}

export function Header(): JSX.Element {
  return (
    <header class="bar">
      <h1 class="brand">
        Fit4CAD <span>Playground</span>
      </h1>
      {PAGES.length > 1 && (
        <nav aria-label="Pages" onFocusIn={intoSight}>
          {PAGES.filter(({ under }) => under === undefined).map(({ id, title }) => (
            <PageLink key={id} id={id} leads={PAGES.some((each) => each.id === page.value && each.under === id)}>
              {title}
            </PageLink>
          ))}
        </nav>
      )}
      <div class="bar-tools">
        <Tool icon="add" title="Add data" shortcut="O" primary onClick={() => (adding.value = true)} />
        <Tool icon="share" title="Share" shortcut="S" onClick={() => (sharing.value = true)} />
        <ProtocolSwitch />
      </div>
      <div class="bar-icons">
        <ThemeButton />
        <button
          type="button"
          class="icon"
          aria-label="Keyboard and help"
          title="Keyboard and help (?)"
          onClick={() => (keysShown.value = true)}
        >
          <Icon name="help" />
        </button>
        <button type="button" class="icon roomy" aria-label="About" title="About" onClick={() => (aboutShown.value = true)}>
          <Icon name="note" />
        </button>
      </div>
    </header>
  );
}

interface ToolProps {
  readonly icon: IconName;
  readonly title: string;
  readonly shortcut: string;
  readonly primary?: boolean;
  readonly onClick: () => void;
}

/** Where there is little room it is its icon alone, whose name is the label. */
function Tool({ icon, title, shortcut, primary = false, onClick }: ToolProps): JSX.Element {
  return (
    <button type="button" class={primary ? "primary" : undefined} aria-label={title} title={`${title} (${shortcut})`} onClick={onClick}>
      <Icon name={icon} />
      <span>{title}</span>
    </button>
  );
}

const THEMES: Readonly<Record<Theme, { icon: IconName; label: string }>> = {
  system: { icon: "half", label: "as the system has it" },
  light: { icon: "sun", label: "light" },
  dark: { icon: "moon", label: "dark" },
};

function ThemeButton(): JSX.Element {
  const { icon, label } = THEMES[theme.value];
  return (
    <button
      type="button"
      class="icon"
      aria-label={`Theme: ${label}. Change`}
      title={`Theme: ${label} (T)`}
      onClick={nextTheme}
    >
      <Icon name={icon} />
    </button>
  );
}
