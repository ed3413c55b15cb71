// Name, pages, and the switches that hold everywhere.

import type { JSX } from "preact";
import { adding } from "../intake/add-dialog";
import { keysShown } from "../keyboard/sheet";
import { ProtocolSwitch } from "../measures/protocol-switch";
import { sharing } from "../sharing/share";
import { theme, type Theme } from "../state/settings";
import { Icon, type IconName } from "../ui/icon";
import { PageLink } from "./page-link";
import { PAGES } from "./registry";
import { page } from "./router";

export function Header(): JSX.Element {
  return (
    <header class="bar">
      <h1 class="brand">
        Fit4CAD <span>Playground</span>
      </h1>
      {PAGES.length > 1 && (
        <nav aria-label="Pages">
          {PAGES.filter(({ under }) => under === undefined).map(({ id, title }) => (
            <PageLink key={id} id={id} leads={PAGES.some((each) => each.id === page.value && each.under === id)}>
              {title}
            </PageLink>
          ))}
        </nav>
      )}
      <div class="bar-tools">
        <button type="button" class="primary" onClick={() => (adding.value = true)}>
          <Icon name="add" />
          Add data
        </button>
        <button type="button" onClick={() => (sharing.value = true)}>
          <Icon name="share" />
          Share
        </button>
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
      </div>
    </header>
  );
}

const THEMES: Readonly<Record<Theme, { next: Theme; icon: IconName; label: string }>> = {
  system: { next: "light", icon: "half", label: "as the system has it" },
  light: { next: "dark", icon: "sun", label: "light" },
  dark: { next: "system", icon: "moon", label: "dark" },
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

export function nextTheme(): void {
  theme.value = THEMES[theme.value].next;
}
