/// Sentences that hold pieces of code.

import type {VNode} from "preact"

/// A sentence with its code in code (between backticks or ‘quotes’), and the name of the function it is about in bold.
export function Said({text, strong}: {text: string; strong: string | null}): VNode {
  return (
    <>
      {text.split(/(`[^`]+`|‘[^’]+’)/).map((part, i) => {
        const code = /^(?:`[^`]+`|‘[^’]+’)$/.test(part) ? part.slice(1, -1) : null
        if (code !== null) return code === strong ? <b key={part}>{code}</b> : <code key={part}>{code}</code>
        // Sentences about a run begin with the name of the function.
        if (i === 0 && strong !== null && part.startsWith(`${strong} `))
          return (
            <>
              <b>{strong}</b>
              {part.slice(strong.length)}
            </>
          )
        return part
      })}
    </>
  )
}
