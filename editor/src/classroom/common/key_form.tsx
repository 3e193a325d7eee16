/// Form for the teacher's key, in front of the board and of the projector.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import {words} from "../../words/index.ts"

interface Props {
  readonly title: string
  readonly isLost: boolean
  readonly refused: string | null
  readonly unlock: (key: string) => void
}

export function KeyForm({title, isLost, refused, unlock}: Props): VNode {
  const w = words.classroom.board
  const [key, setKey] = useState("")
  return (
    <main class="board-lock">
      <form
        class="class-form"
        onSubmit={event => {
          event.preventDefault()
          unlock(key)
        }}
      >
        <h1>{title}</h1>
        <p class="quiet">{w.lead}</p>
        <label class="field">
          <span>{w.key}</span>
          <input
            type="password"
            value={key}
            required
            maxLength={60}
            autocomplete="off"
            onInput={event => setKey(event.currentTarget.value)}
          />
        </label>
        {isLost ? (
          <p role="status">{w.lost}</p>
        ) : (
          refused !== null && (
            <p class="refused" role="alert">
              {refused}
            </p>
          )
        )}
        <button type="submit" class="primary">
          {w.open}
        </button>
      </form>
    </main>
  )
}
