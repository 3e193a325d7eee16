/// The teacher's comments on a pupil's page: shows those of the open program at their places, and brings a place into sight.

import {computed, type Signal} from "@preact/signals"
import {locatePlace} from "../../program/block_comments.ts"
import {innermostBlock} from "../../program/program.ts"
import type {OwnComment, PupilRequest} from "../../wire/classroom/pupil_messages.generated.ts"
import type {ClassCommands} from "./bar/class_bar.tsx"
import type {ClassState} from "./class_state.ts"
import type {PageOfClass} from "./page_of_class.ts"

type CommentCommands = Pick<ClassCommands, "open" | "nameOf" | "showComment" | "openProgram" | "setDone">

export function openPupilComments(
  {store, loader, programStore, reveal}: PageOfClass,
  state: Signal<ClassState>,
  send: (message: PupilRequest) => boolean,
): CommentCommands {
  let shownComments: readonly OwnComment[] = []
  let shownId: string | null = null
  /// Shows the comments of the open program, when they are others than before.
  const update = () => {
    const {blockComments} = state.value
    const id = loader.storedId()
    if (blockComments === shownComments && id === shownId) return
    shownComments = blockComments
    shownId = id
    const comments = blockComments.filter(comment => comment.program === id && !comment.done)
    if (comments.length === 0 && store.now.blockComments.length === 0) return
    store.dispatch({kind: "block-comments", comments})
  }
  // After the event: showing comments dispatches an event of its own.
  store.onEvent(() => queueMicrotask(update))
  state.subscribe(update)
  const document = computed(() => store.drawn.value.document)
  return {
    open: {
      get value() {
        return {program: document.value.program, id: loader.storedId()}
      },
    },
    nameOf: program => programStore.programs().find(({id}) => id === program)?.name ?? null,
    showComment({place}) {
      const {program} = store.now.document
      const range = locatePlace(program, place)
      if (range !== null) reveal({range, block: innermostBlock(program.spans, range)})
    },
    openProgram(program) {
      const text = programStore.read(program)
      if (text !== null)
        loader.openText(programStore.programs().find(({id}) => id === program)?.name ?? "", text, {
          id: program,
        })
    },
    setDone(comment, done) {
      send({op: "comment-done", comment: comment.id, done})
    },
  }
}
