/// Keyboard shortcuts of the block view, as Blockly has them registered.

import * as Blockly from "blockly/core"
import type {Keys} from "../../../state/shortcuts.ts"

/// Codes of keys that are neither letters nor digits, as browsers call these keys (UI Events, `keyCode`).
const named: Readonly<Record<number, string>> = {
  8: "Backspace",
  13: "Enter",
  27: "Escape",
  32: "Space",
  33: "PageUp",
  34: "PageDown",
  35: "End",
  36: "Home",
  37: "ArrowLeft",
  38: "ArrowUp",
  39: "ArrowRight",
  40: "ArrowDown",
  46: "Delete",
  93: "ContextMenu",
  187: "+",
  189: "-",
  191: "/",
}
const firstF = 112
const lastF = 123
/// The same keys on the number pad: 96 to 105 are its digits.
const numberPad: ReadonlySet<number> = new Set([
  ...Array.from({length: 10}, (_, digit) => 96 + digit),
  107,
  109,
])

/// Blockly writes `Shift+Control+90`.
function chordOf(code: string): string | undefined {
  const parts = code.split("+")
  const number = Number(parts.pop())
  if (numberPad.has(number) || parts.includes("Meta")) return undefined
  const key =
    named[number] ??
    (number >= firstF && number <= lastF
      ? `F${number - firstF + 1}`
      : String.fromCharCode(number).toLowerCase())
  // To a learner a `+` is a `+`, with Shift or without.
  const modifiers = ["Control", "Alt", "Shift"].filter(name => parts.includes(name) && key !== "+")
  return [...modifiers.map(name => (name === "Control" ? "Mod" : name)), key].join("-")
}

/// Chords by Blockly's name of what they do.
export function blockKeys(): Keys {
  const {registry} = Blockly.ShortcutRegistry
  const names = Object.keys(registry.getRegistry())
  const keys: Record<string, readonly string[]> = {}
  for (const name of names) {
    const chords = [...new Set(registry.getKeyCodesByShortcutName(name).map(chordOf))]
    // One name for two things: an arrow steps to the next place, with Ctrl it moves the block itself.
    const free = chords.filter(chord => name.startsWith("move_") && chord?.startsWith("Mod-"))
    keys[name] = chords.filter(chord => chord !== undefined && !free.includes(chord)) as string[]
    // Ten digits are one entry.
    if (name === "rosyNumber") keys[name] = ["0…9", "-"]
    if (free.length > 0) keys.moveFreely = [...(keys.moveFreely ?? []), ...(free as string[])]
  }
  // The search field handles these itself.
  keys.rosyPutNext = ["Enter", "Shift-Enter"]
  return keys
}
