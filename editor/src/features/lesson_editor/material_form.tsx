/// Form for the room, the program at the start and the solution of a draft, which are made on the page.

import type {VNode} from "preact"
import type {PageState} from "../../state/page_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import type {WorldFile} from "../../worlds/world.ts"
import {readWorld} from "../../worlds/world_decoder.ts"
import {writeWorld} from "../../worlds/world_encoder.ts"
import {useEditedDraft} from "./edited_draft.ts"

export function Materials(): VNode {
  return (
    <>
      <Room />
      <Program what="start" />
      <Program what="solution" />
    </>
  )
}

function Room(): VNode {
  const {store, lessonEditor} = useController()
  const {room, start} = useEditedDraft()
  const isShown = usePageState(s => isSameRoom(s.room.world, room))
  const w = words.lessonEditor
  return (
    <fieldset class="draft-material">
      <legend>{w.room}</legend>
      <p class="quiet">{isShown ? w.isShown : w.roomIsOther}</p>
      <div class="draft-buttons">
        {!isShown && (
          <>
            <button type="button" class="plain" onClick={lessonEditor.useRoom}>
              {w.useRoom}
            </button>
            <button type="button" class="plain" onClick={() => lessonEditor.show(start)}>
              {w.showStart}
            </button>
          </>
        )}
        {isShown && (
          <button type="button" class="plain" onClick={() => store.dispatch({kind: "world-editor-opened"})}>
            {w.changeRoom}
          </button>
        )}
      </div>
    </fieldset>
  )
}

/// Rooms are compared without their names: a lesson gives its room another one.
function isSameRoom(shown: PageState["room"]["world"], room: WorldFile): boolean {
  const read = readWorld(room)
  if (shown === null || read.kind === "fault") return false
  const plain = (world: typeof shown) => JSON.stringify(writeWorld({...world, name: "", title: ""}))
  return plain(shown) === plain(read.world)
}

function Program({what}: {readonly what: "start" | "solution"}): VNode {
  const {lessonEditor} = useController()
  const program = useEditedDraft()[what]
  const isShown = usePageState(s => s.document.program.text === program)
  const w = words.lessonEditor
  return (
    <fieldset class="draft-material">
      <legend>{w[what]}</legend>
      {what === "solution" && <p class="quiet">{w.solutionHint}</p>}
      <p class="quiet">{program === null ? w.noSolution : isShown ? w.isShown : w.isOther}</p>
      <div class="draft-buttons">
        {!isShown && (
          <button
            type="button"
            class="plain"
            aria-label={`${w[what]}: ${w.useStart}`}
            onClick={() => lessonEditor.useProgram(what)}
          >
            {w.useStart}
          </button>
        )}
        {!isShown && program !== null && (
          <button
            type="button"
            class="plain"
            aria-label={`${w[what]}: ${w.showStart}`}
            onClick={() => lessonEditor.show(program)}
          >
            {w.showStart}
          </button>
        )}
      </div>
    </fieldset>
  )
}
