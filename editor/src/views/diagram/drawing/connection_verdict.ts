/// What is said of the end that a dragged connection is over. Each end is asked for once in a drag, and after the frame that shows the line there: to try an edit
/// out takes longer than a frame.

import type {ConnectionEnd} from "../network/connections.ts"

export interface Verdict {
  readonly fits: boolean
  readonly text: string
}

/// An end, and the element that shows it.
export interface Grip {
  readonly element: Element
  readonly end: ConnectionEnd
}

/// Returns what the pointer is told to be over. `later` does something when the next frame has been drawn.
export function openVerdicts(
  note: Pick<HTMLElement, "textContent" | "classList">,
  ask: (to: ConnectionEnd) => Verdict,
  later: (act: () => void) => void = afterFrame,
): (next: Grip | null) => void {
  const known = new Map<string, Verdict>()
  let target: Grip | null = null
  const show = ({element}: Grip, {fits, text}: Verdict) => {
    element.classList.add(fits ? "fits" : "misfits")
    note.textContent = text
    note.classList.toggle("misfits", !fits)
  }
  return next => {
    if (next?.element === target?.element) return
    target?.element.classList.remove("fits", "misfits")
    target = next
    note.textContent = ""
    if (next === null) return
    const key = `${next.end.kind} ${next.end.type}`
    const before = known.get(key)
    if (before !== undefined) return show(next, before)
    later(() => {
      // What the pointer has left by then is not asked for.
      if (target !== next) return
      const verdict = ask(next.end)
      known.set(key, verdict)
      show(next, verdict)
    })
  }
}

/// Does something when the browser has drawn the next frame.
function afterFrame(act: () => void): void {
  requestAnimationFrame(() => setTimeout(act))
}
