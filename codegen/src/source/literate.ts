/// Literate Haskell (Haskell 2010 report §10.4): code behind bird tracks, or between lines `\begin{code}` and `\end{code}`; all else is prose. Text in, text out.
/// Where the report allows more than GHC's `unlit`, this follows GHC.

import {expandTabs} from "./tab_expansion.ts"

type Line =
  /// Without its track.
  | {readonly kind: "bird"; readonly text: string}
  | {readonly kind: "latex"; readonly text: string}
  | {readonly kind: "prose"; readonly text: string}
  | {readonly kind: "delimiter"}

/// By the name of a file.
export const isLiterate = (name: string): boolean => /\.lhs$/i.test(name)

/// The program of a literate text, with its prose as comments, line for line; `null` where it has no code. Columns of code are counted from its leftmost line.
export function literateToHaskell(text: string): string | null {
  const lines = classified(text.split(/\r\n?|\n/))
  if (!lines.some(({kind}) => kind === "bird" || kind === "latex")) return null
  const indentation = {bird: leastIndentation(lines, "bird"), latex: leastIndentation(lines, "latex")}
  return lines
    .map(line => {
      if (line.kind === "bird" || line.kind === "latex") return line.text.slice(indentation[line.kind])
      return line.kind === "delimiter" || line.text.trim() === "" ? "" : `-- ${line.text.trim()}`
    })
    .join("\n")
}

function classified(lines: readonly string[]): readonly Line[] {
  let inCode = false
  return lines.map((line): Line => {
    if (inCode) {
      if (line.trimEnd() !== "\\end{code}") return {kind: "latex", text: expandTabs(line)}
      inCode = false
      return {kind: "delimiter"}
    }
    if (line.trimEnd() === "\\begin{code}") {
      inCode = true
      return {kind: "delimiter"}
    }
    // A track counts as a space, also for tab stops.
    if (line.startsWith(">")) return {kind: "bird", text: expandTabs(` ${line.slice(1)}`)}
    return {kind: "prose", text: line}
  })
}

function leastIndentation(lines: readonly Line[], kind: "bird" | "latex"): number {
  const indentations = lines.flatMap(line =>
    line.kind === kind && line.text.trim() !== "" ? [line.text.search(/\S/)] : [],
  )
  return Math.min(...indentations)
}
