/// The toolbox's blocks as pieces of Haskell, for the text.

import {codeOf, toolbox} from "@rosy/codegen"

export interface Snippet {
  readonly label: string
  readonly code: string
}

let made: readonly Snippet[] | undefined

/// All of them, each once; printed when somebody first asks.
export function snippets(): readonly Snippet[] {
  if (made === undefined) {
    const byCode = new Map<string, Snippet>()
    for (const item of toolbox("haskell").flatMap(category => category.items)) {
      const code = codeOf(item.block)?.text
      if (code?.includes(" ") && !byCode.has(code)) byCode.set(code, {label: item.label, code})
    }
    made = [...byCode.values()]
  }
  return made
}
