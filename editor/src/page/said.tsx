/// Sentences that hold pieces of code.

import type {VNode} from "preact"

/// A sentence with its code in code (between backticks) and the name of the function it is about in bold.
export function Said({text, strong}: {text: string; strong: string | null}): VNode {
  return (
    <>
      {text.split(/(`[^`]+`)/).map(part => {
        const code = part.startsWith("`") && part.endsWith("`") && part.length > 2 ? part.slice(1, -1) : null
        if (code === null) return part
        return code === strong ? <b key={part}>{code}</b> : <code key={part}>{code}</code>
      })}
    </>
  )
}
