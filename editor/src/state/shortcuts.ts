/// Keyboard shortcuts: the notation of key chords, and matching of key presses.
///
/// A chord is written as CodeMirror writes it: `Mod-Shift-z`, where Mod is Cmd on a Mac and Ctrl elsewhere. Keys have the browser's names (`KeyboardEvent.key`); letters
/// are lower case.

/// Chords by what they do.
export type Keys<Name extends string = string> = Readonly<Record<Name, readonly string[]>>

export interface KeyLine {
  readonly does: string
  readonly chords: readonly string[]
}

export interface KeySection {
  readonly title: string
  readonly lines: readonly KeyLine[]
}

/// What is read of a key press.
export type KeyPress = Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey" | "shiftKey">

/// The keys of a chord, in the order in which they are pressed.
export function keysOf(chord: string): readonly string[] {
  return chord.split(/-(?!$)/)
}

const isSign = (key: string) => key.length === 1 && key.toLowerCase() === key.toUpperCase()

export function isChord(press: KeyPress, chord: string): boolean {
  const keys = keysOf(chord)
  const key = keys[keys.length - 1] ?? ""
  const wants = (name: string) => keys.slice(0, -1).includes(name)
  const pressed = press.key === " " ? "Space" : press.key
  return (
    pressed.toLowerCase() === key.toLowerCase() &&
    (press.ctrlKey || press.metaKey) === (wants("Mod") || wants("Ctrl")) &&
    press.altKey === wants("Alt") &&
    // Whether a sign needs Shift is for the keyboard to say.
    (isSign(key) || press.shiftKey === wants("Shift"))
  )
}

/// The lines of a section in the order of their words. Those that say the same are one.
export function keyLines(does: Readonly<Record<string, string>>, keys: Keys): readonly KeyLine[] {
  const lines = new Map<string, readonly string[]>()
  for (const [name, words] of Object.entries(does)) {
    const chords = [...(lines.get(words) ?? []), ...(keys[name] ?? [])]
    if (chords.length > 0) lines.set(words, [...new Set(chords)])
  }
  return [...lines].map(([words, chords]) => ({does: words, chords}))
}
