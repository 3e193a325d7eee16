/// Class mode on a pupil's page: the card and the bar, and what they do. Loaded when the service says that it has a class.

import {render} from "preact"
import type {Store} from "../../browser/store.ts"
import {lessonCommands, openLessonText} from "../../controller/lessons/lessons.ts"
import type {ProgramLoader} from "../../controller/programs/program_loader.ts"
import {isLessonFile} from "../../lesson_files/lesson_file.ts"
import {parseJson} from "../../wire/decode.ts"
import "../../styles/class.css"
import type {Handout} from "../../wire/classroom/pupil_messages.generated.ts"
import {ClassBar, type ClassCommands, ClassDialogs} from "./bar/class_bar.tsx"
import {ClassConnection} from "./class_connection.ts"
import {type ClassMemory, openClassMemory} from "./class_memory.ts"
import {commentKey} from "./class_state.ts"
import type {PageOfClass} from "./page_of_class.ts"
import {openPupilComments} from "./pupil_comments.ts"

export function openClassroom(page: PageOfClass): void {
  const memory = openClassMemory(page.storage)
  const commands = classCommands(page, new ClassConnection(page, memory), memory)
  const bar = document.getElementById("class-bar")
  if (bar === null) throw new Error("expected #class-bar on the page, found nothing")
  render(<ClassBar commands={commands} />, bar)
  const dialogs = document.createElement("div")
  document.body.append(dialogs)
  render(<ClassDialogs commands={commands} />, dialogs)
}

function classCommands(page: PageOfClass, connection: ClassConnection, memory: ClassMemory): ClassCommands {
  const {store, loader, programStore, code} = page
  const {state, isTeacher, memberships, sync, dispatch, send, sendAlways} = connection
  return {
    ...openPupilComments(page, state, send),
    ...connection.sharing.commands,
    state,
    code,
    isTeacher,
    join(typedCode, nickname) {
      dispatch({kind: "asked"})
      if (!sendAlways({op: "join", code: typedCode, nickname, language: document.documentElement.lang}))
        dispatch({kind: "link", link: "lost"})
    },
    resume(typedCode, typedWords) {
      dispatch({kind: "asked"})
      if (!sendAlways({op: "resume", code: typedCode, words: typedWords}))
        dispatch({kind: "link", link: "lost"})
    },
    showCard(card) {
      if (card === null && state.value.member === null) memory.skip(memberships.classId() ?? "")
      dispatch({kind: "card", card})
    },
    raiseHand(up) {
      dispatch({kind: "hand", up})
      send({op: "hand", up})
    },
    openHandout() {
      const {handout} = state.value
      if (handout === null) return
      memory.addHandout(handout.id)
      openHandout(store, loader, handout)
      dispatch({kind: "handout-closed"})
    },
    foldHandout: folded => dispatch({kind: "handout-folded", folded}),
    handIn(task) {
      sync.saveOpened("change")
      const message = {op: "hand-in", task, name: store.now.name, text: loader.projectText()} as const
      dispatch({kind: "hand-in", task, state: send(message) ? "asked" : "offline"})
    },
    closeComment(task) {
      dispatch({kind: "comments-read", comments: memory.addReadComment(commentKey(task))})
    },
    answerStudy: agrees => send({op: "answer-study", agrees}),
    leave() {
      sync.save("change")
      const programs = memberships.read()?.programs ?? {}
      if (sync.state() !== "saved") return
      const current = loader.storedId()
      if (current !== null && programs[current] !== undefined) loader.newProgram()
      for (const id of Object.keys(programs)) programStore.remove(id, Date.now())
      sendAlways({op: "forget"})
      memberships.write(null)
      memory.forgetComments()
      connection.progress.left()
      dispatch({kind: "left"})
    },
  }
}

/// Shows what the teacher sent. A room replaces the one around the open program.
function openHandout(store: Store, loader: ProgramLoader, {what, name, text}: Handout): void {
  if (what === "program") loader.openText(name, text)
  else if (what === "lesson" && isLessonFile(text)) openLessonText(store, loader, name, text)
  else if (what === "lesson") lessonCommands(store, loader).openLesson(text)
  else {
    const world = parseJson(text)
    if (typeof world === "string") store.dispatch({kind: "world-chosen", world})
    else store.dispatch({kind: "world-file-read", name, text})
  }
}
