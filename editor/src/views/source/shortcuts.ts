/// Keyboard shortcuts of the Haskell pane: Rosy's own, and a selection of CodeMirror's.

import {completionKeymap, startCompletion} from "@codemirror/autocomplete"
import {defaultKeymap, moveLineDown, moveLineUp, toggleComment} from "@codemirror/commands"
import {lintKeymap, nextDiagnostic} from "@codemirror/lint"
import {openSearchPanel, searchKeymap} from "@codemirror/search"
import type {Command, KeyBinding} from "@codemirror/view"
import type {Keys} from "../../state/shortcuts.ts"

export const ownKeys = {
  mend: "Mod-.",
  rename: "F2",
  format: "Shift-Alt-f",
  why: "Shift-Alt-w",
  more: "Ctrl-Shift-ArrowUp",
  less: "Ctrl-Shift-ArrowDown",
} as const

const chordsOf = (bindings: readonly KeyBinding[], run: Command) =>
  bindings.flatMap(binding => (binding.run === run ? (binding.key ?? []) : []))

export const textKeys: Keys = {
  complete: chordsOf(completionKeymap, startCompletion),
  mend: [ownKeys.mend],
  nextProblem: chordsOf(lintKeymap, nextDiagnostic),
  rename: [ownKeys.rename],
  format: [ownKeys.format],
  why: [ownKeys.why],
  number: [ownKeys.more, ownKeys.less],
  find: chordsOf(searchKeymap, openSearchPanel),
  comment: chordsOf(defaultKeymap, toggleComment),
  lineUp: chordsOf(defaultKeymap, moveLineUp),
  lineDown: chordsOf(defaultKeymap, moveLineDown),
  indent: ["Tab"],
  leave: ["Escape"],
}
