/// Questions to the compiler about what can stand at a place, and its answers. A newer question replaces an older one, which is then nobody's.

import type {Fitting, PageMessage, ServiceMessage} from "../state/messages.ts"

type Completed = ServiceMessage & {readonly op: "completed"}

export interface Completions {
  fitting(text: string, offset: number): Promise<{names: readonly Fitting[]} | null>
  heard(message: Completed): void
}

/// Milliseconds after which somebody who writes does not wait any longer for what the compiler offers.
const patience = 700

export function openCompletions(send: (message: PageMessage) => void): Completions {
  let asked = 0
  let waiting: ((answer: Completed | null) => void) | null = null
  return {
    fitting(text, offset) {
      waiting?.(null)
      asked += 1
      const before = text.slice(0, offset)
      // protocol §1: lines and columns from 1, counted in characters.
      const line = before.split("\n").length
      const column = [...before.slice(before.lastIndexOf("\n") + 1)].length + 1
      send({op: "complete", id: asked, source: text, line, column})
      return new Promise(resolve => {
        const timer = setTimeout(() => waiting?.(null), patience)
        waiting = answer => {
          clearTimeout(timer)
          waiting = null
          resolve(answer)
        }
      })
    },
    heard(message) {
      if (message.id === asked) waiting?.(message)
    },
  }
}
