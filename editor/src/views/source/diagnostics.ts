/// Diagnostics of the Haskell pane: problems as underlines with their fixes.

import {type Diagnostic, forEachDiagnostic} from "@codemirror/lint"
import type {EditorState} from "@codemirror/state"
import type {Finding} from "../../program/program.ts"

/// The diagnostics of findings in a text of this length. `apply` is called with the numbers of a finding and of its chosen fix.
export function diagnosticsOf(
  findings: readonly Finding[],
  length: number,
  apply: (finding: number, fix: number) => void,
): readonly Diagnostic[] {
  return findings.flatMap((f, i): Diagnostic[] => {
    if (f.range === null || f.range.start > length) return []
    const to = Math.min(f.range.end, length)
    return [
      {
        from: Math.min(f.range.start, to),
        to,
        severity: f.severity === "note" ? "info" : f.severity,
        message: `${f.message} ${f.hint}`.trim().replaceAll("`", ""),
        actions: f.fixes.map(({title}, n) => ({name: title, apply: () => apply(i, n)})),
      },
    ]
  })
}

/// The content of a diagnostic without its place.
export function saidBy({severity, message, actions = []}: Diagnostic): string {
  return [severity, message, ...actions.map(action => action.name)].join("\n")
}

/// Whether the shown diagnostics, moved along with the text, are at the places of these.
export function standThere(state: EditorState, wanted: readonly Diagnostic[]): boolean {
  const at = (d: Diagnostic, from: number, to: number) => `${from} ${to} ${saidBy(d)}`
  const there = new Set<string>()
  forEachDiagnostic(state, (d, from, to) => there.add(at(d, from, to)))
  return wanted.every(d => there.has(at(d, d.from, d.to)))
}
