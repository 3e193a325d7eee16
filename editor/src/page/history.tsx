/// Undo and redo.

import type {VNode} from "preact"
import {RedoIcon, UndoIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {words} from "./words.ts"

export function History(): VNode {
  const desk = useDesk()
  const can = usePage(s => s.can)
  return (
    <span class="pair">
      <button
        type="button"
        class="plain icon"
        title={words.undo}
        aria-label={words.undo}
        disabled={!can.undo}
        onClick={() => desk.undo()}
      >
        <UndoIcon />
      </button>
      <button
        type="button"
        class="plain icon"
        title={words.redo}
        aria-label={words.redo}
        disabled={!can.redo}
        onClick={() => desk.redo()}
      >
        <RedoIcon />
      </button>
    </span>
  )
}
