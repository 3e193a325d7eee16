/// Colours of the room, read from the page's CSS tokens.

import {maxRunCompanions} from "../../wire/page/runs.generated.ts"

export interface Palette {
  readonly floor: string
  readonly grid: string
  readonly wall: string
  readonly solid: string
  readonly goal: string
  readonly avoid: string
  readonly box: string
  readonly hole: string
  readonly ink: string
  readonly paper: string
  readonly trail: string
  readonly preview: string
  /// A run that is compared with the shown one.
  readonly compared: string
  /// The trail's levels, from slow to fast or from long ago to now.
  readonly ramp: readonly string[]
  readonly around: string
  readonly hit: string
  readonly body: string
  readonly ring: string
  readonly mark: string
  readonly leds: readonly [string, string, string, string]
  /// The bodies of the other robots in the room.
  readonly companions: readonly string[]
  /// The colours of the pen, by the numbers of `PenColor`.
  readonly inks: readonly string[]
  readonly font: string
}

/// protocol/robots, `PenColor`.
const penColors = ["black", "red", "orange", "yellow", "green", "blue", "purple"] as const

export function readPalette(element: Element): Palette {
  const style = getComputedStyle(element)
  return paletteOf(name => style.getPropertyValue(name).trim())
}

/// `token` gives the value of a CSS token by its name.
export function paletteOf(token: (name: string) => string): Palette {
  return {
    floor: token("--floor"),
    grid: token("--floor-line"),
    wall: token("--wall"),
    solid: token("--solid"),
    goal: token("--ok"),
    avoid: token("--bad"),
    box: token("--box"),
    hole: token("--hole"),
    ink: token("--ink"),
    paper: token("--paper"),
    trail: token("--rosy"),
    preview: token("--preview"),
    compared: token("--compared"),
    ramp: [1, 2, 3, 4, 5].map(level => token(`--trail-${level}`)),
    around: token("--sunken"),
    hit: token("--hit"),
    body: token("--robot"),
    ring: token("--robot-ring"),
    mark: token("--robot-mark"),
    leds: [token("--led-black"), token("--led-green"), token("--led-orange"), token("--led-red")],
    companions: Array.from({length: maxRunCompanions}, (_, i) => token(`--robot-${i + 2}`)),
    inks: penColors.map(color => token(`--pen-${color}`)),
    font: token("--ui"),
  }
}
