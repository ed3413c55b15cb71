"""Colours of segments. Those of `www/shared/palette.mjs`; a test holds the two against each other."""

UNSEGMENTED = "#8b9097"

SEGMENT_COLOURS = (
    "#2f6fc4", "#f0d269", "#c31e00", "#69c3ff", "#d28778", "#872d69", "#8787ff", "#a55a78",
    "#b4b400", "#00f0f0", "#2d4ba5", "#ffa5a5", "#879600", "#b478c3", "#a51e3c", "#c36969",
    "#875af0", "#695a96", "#69a5f0", "#d296c3", "#e15a96", "#96c369", "#5a874b", "#b41e87",
    "#d2c32d", "#0096a5", "#1e4bd2", "#00e1c3", "#7878e1", "#b4e196", "#96a53c", "#96780f",
)
