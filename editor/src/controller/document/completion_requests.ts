/// Completion requests to the compiler, of which a newer one cancels an older one; and the toolbox's blocks as snippets.
/// An answer that comes too late is kept for the next request about the same place.

import {codeOf, toolbox} from "@rosy/codegen"
import type {ServiceMessage} from "../../state/messages/messages.ts"
import type {Request} from "../../wire/page/page.generated.ts"
import type {Suggestion} from "../../wire/worker.generated.ts"

type Completed = ServiceMessage & {readonly op: "completed"}

export interface Completions {
  /// `null` when the compiler has not answered in time; `later` is called once when it has answered then.
  fitting(text: string, offset: number, later: () => void): Promise<{names: readonly Suggestion[]} | null>
  heard(message: Completed): void
}

/// Milliseconds after which completion does not wait any longer for the compiler's offers.
export const patience = 700

interface Place {
  readonly text: string
  readonly offset: number
  readonly later: () => void
}

export function openCompletions(send: (message: Request) => void): Completions {
  let asked = 0
  let waiting: ((answer: Completed | null) => void) | null = null
  // The newest request, from the end of the patience until its answer.
  let overdue: Place | null = null
  let late: (Place & {readonly answer: Completed}) | null = null
  return {
    fitting(text, offset, later) {
      waiting?.(null)
      overdue = null
      if (late !== null && late.text === text && late.offset === offset) return Promise.resolve(late.answer)
      late = null
      asked += 1
      const before = text.slice(0, offset)
      // protocol §1: lines and columns from 1, counted in characters.
      const line = before.split("\n").length
      const column = [...before.slice(before.lastIndexOf("\n") + 1)].length + 1
      send({op: "complete", id: asked, source: text, line, column})
      return new Promise(resolve => {
        const timer = setTimeout(() => {
          waiting?.(null)
          overdue = {text, offset, later}
        }, patience)
        waiting = answer => {
          clearTimeout(timer)
          waiting = null
          resolve(answer)
        }
      })
    },
    heard(message) {
      if (message.id !== asked) return
      waiting?.(message)
      if (overdue === null) return
      late = {...overdue, answer: message}
      overdue = null
      late.later()
    },
  }
}

export interface Snippet {
  readonly label: string
  readonly code: string
}

let made: readonly Snippet[] | undefined

/// All of them, each once; printed at the first request.
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
