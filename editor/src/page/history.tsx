/// Undo and redo.

import type {VNode} from "preact"
import {words} from "../words/index.ts"
import {RedoIcon, UndoIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"

export function History(): VNode {
  const desk = useDesk()
  const canUndo = usePage(s => s.history.past.length > 0)
  const canRedo = usePage(s => s.history.future.length > 0)
  return (
    <span class="pair">
      <button
        type="button"
        class="plain icon"
        title={words.undo}
        aria-label={words.undo}
        disabled={!canUndo}
        onClick={() => desk.undo()}
      >
        <UndoIcon />
      </button>
      <button
        type="button"
        class="plain icon"
        title={words.redo}
        aria-label={words.redo}
        disabled={!canRedo}
        onClick={() => desk.redo()}
      >
        <RedoIcon />
      </button>
    </span>
  )
}
