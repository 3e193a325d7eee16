/// Class mode on a pupil's page: connects the class socket, the synchronization, and the card and bar. Loaded when the service says that it has a class.

import {signal} from "@preact/signals"
import {parseProject, saveProject} from "@rosy/codegen"
import {render} from "preact"
import type {Store} from "../../browser/store.ts"
import {lessonCommands, openLessonText} from "../../controller/lessons/lessons.ts"
import {freshName, freshPlace} from "../../controller/programs/autosave.ts"
import type {ProgramLoader} from "../../controller/programs/program_loader.ts"
import {isLessonFile} from "../../lesson_files/lesson_file.ts"
import {isDone} from "../../state/lesson_state.ts"
import type {PageState} from "../../state/page_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import {tryToStore} from "../../storage/browser_storage.ts"
import {parseJson, readerOf} from "../../wire/decode.ts"
import {words} from "../../words/index.ts"
import "../../styles/class.css"
import type {Refusal} from "../../wire/classroom/message_fields.generated.ts"
import {
  type Handout,
  type OwnTask,
  type PupilAnswer,
  type PupilRequest,
  pupilAnswer,
  type Reason,
  type Status,
} from "../../wire/classroom/pupil_messages.generated.ts"
import {openClassSocket} from "../messages/class_socket.ts"
import {openMemberships, teacherKey} from "../messages/membership.ts"
import {openClassAdmission} from "./class_admission.ts"
import {ClassBar, type ClassDesk, ClassDialogs} from "./class_bar.tsx"
import {openClassProgress} from "./class_progress.ts"
import {type ClassEvent, type ClassState, commentKey, firstClassState, reduceClass} from "./class_state.ts"
import {openClassSync} from "./class_sync.ts"
import type {PageOfClass} from "./page_of_class.ts"
import {openPupilComments} from "./pupil_comments.ts"
import {openPupilSharing} from "./pupil_sharing.ts"

/// Milliseconds between a change and its being sent to the service.
const savePause = 2000

/// Milliseconds until a request that the service could not store or read is sent again.
const retryPause = 5000

const skippedKey = "rosy.class.skipped"
const handoutKey = "rosy.class.handout"
const commentsKey = "rosy.class.comments"

/// Comments that a browser remembers as read; older ones may be shown again.
const mostReadComments = 50

/// Longest timer that browsers keep, in milliseconds (HTML, timer initialization: a signed 32-bit number).
const longestTimer = 2 ** 31 - 1

export function openClassroom(page: PageOfClass): void {
  const {store, loader, shelf, storage, code} = page
  const isTeacher = storage.shared.getItem(teacherKey) !== null
  const readComments = (): readonly string[] => (storage.shared.getItem(commentsKey) ?? "").split("\n")
  const state = signal<ClassState>({...firstClassState, readComments: readComments()})
  const receivedHandouts = () => (storage.shared.getItem(handoutKey) ?? "").split(" ")
  const dispatch = (event: ClassEvent) => {
    state.value = reduceClass(state.value, event, receivedHandouts())
  }
  /// The service has let this connection in.
  let isIn = false
  /// A change waits for the pause after it.
  let isPending = false
  const showSaved = () => dispatch({kind: "saved", saved: isPending ? "saving" : sync.state()})
  const socket = openClassSocket<PupilRequest, PupilAnswer>("api/class", readerOf(pupilAnswer), {
    opened() {
      dispatch({kind: "link", link: "open"})
    },
    lost() {
      isIn = false
      sync.lost()
      sharing.lost()
      dispatch({kind: "link", link: "lost"})
    },
    received: heard,
  })
  const memberships = openMemberships(storage.shared)
  const admission = openClassAdmission(memberships, socket.send, dispatch)
  /// What the service would refuse before the page is let in is not sent.
  const send = (message: PupilRequest): boolean =>
    state.value.member !== null && state.value.link === "open" && socket.send(message)
  /// Stores the open program as if it were changed: without an entry, or with one that has another text now, it gets a new one.
  const storeAnew = () => {
    store.dispatch({kind: "renamed", name: store.now.name})
    loader.store()
  }
  const sync = openClassSync(
    memberships,
    shelf,
    {
      id: loader.storedId,
      store: loader.store,
      show: (id, text) => loader.openText(words.yourProgram, text, {id}),
      claim: storeAnew,
      becomeTwo: storeAnew,
    },
    {name: freshName, place: freshPlace, renamed},
    send,
    showSaved,
  )
  let isRetryDue = false
  const retryLater = () => {
    if (isRetryDue) return
    isRetryDue = true
    setTimeout(() => {
      isRetryDue = false
      if (isIn) sync.retry()
    }, retryPause)
  }
  const sharing = openPupilSharing(page, state, dispatch, send)
  const status = openStatus(store, send)
  const progress = openClassProgress(store, storage.shared, send)
  const pause = openPause(store)
  const endTasks = openTaskTimers(task => dispatch({kind: "task-ended", task}))

  /// Whether the page was in another class, or showed a program of one, which gives way to a new one. The pupil's newest program follows when
  /// the class lets the page in.
  let isReplaced = false
  /// The entry of the program that was compared with the class last.
  let compared: string | null = null
  shelf.hide(memberships.isForeign)
  const hideForeign = () => {
    const id = loader.storedId()
    if (id === compared) return
    compared = id
    if (id === null || !memberships.isForeign(id)) return
    isReplaced = true
    loader.newProgram()
    store.dispatch({kind: "lesson", event: {kind: "closed"}})
  }
  store.onEvent(() => queueMicrotask(hideForeign))
  const meetClass = (id: string) => {
    const before = memberships.classId()
    if (before !== null && before !== id) {
      sync.left()
      isReplaced = true
      dispatch({kind: "class-changed"})
    }
    memberships.setClass(id)
    progress.meets(id)
    compared = null
    hideForeign()
    if (!admission.enter() && !isTeacher && storage.tab.getItem(skippedKey) !== id)
      dispatch({kind: "card", card: "join"})
  }

  function heard(message: PupilAnswer): void {
    if (message.op === "class") {
      meetClass(message.id)
      return
    }
    if (message.op === "entered" && message.token !== null)
      memberships.write({token: message.token, nickname: message.nickname, programs: {}})
    if (message.op === "refused" && message.reason === "token") memberships.write(null)
    if (message.op === "refused" && keepsOut(message.reason) && !isIn && admission.refused()) {
      sync.lost()
      return
    }
    if (message.op === "entered") isIn = true
    if (message.op === "refused" && message.reason === "removed") {
      isIn = false
      sync.lost()
      sharing.lost()
    }
    if (message.op === "renamed" || message.op === "entered") {
      const member = memberships.read()
      if (member !== null) memberships.write({...member, nickname: message.nickname})
    }
    if (message.op === "unsaved" || (message.op === "refused" && message.reason !== "request")) retryLater()
    const wasUp = state.value.hand
    sharing.heard(message)
    dispatch({kind: "heard", message})
    if (message.op === "entered") {
      sync.entered(message.programs, message.token !== null || isReplaced)
      isReplaced = false
      progress.entered(message, memberships.classId() ?? "")
      if (wasUp && !message.hand) socket.send({op: "hand", up: state.value.hand})
      status.repeat()
    } else if (
      message.op === "program" ||
      message.op === "saved" ||
      message.op === "conflict" ||
      message.op === "unsaved"
    )
      sync.heard(message)
    if (message.op === "tasks") endTasks(message.tasks)
    // A page that works on without the class is not asked again at each connection.
    if (
      state.value.refused === "removed" &&
      storage.tab.getItem(skippedKey) === (memberships.classId() ?? "")
    )
      dispatch({kind: "card", card: null})
    if (message.op === "attention" || message.op === "entered" || message.op === "refused")
      pause(state.value.attention !== null)
  }
  watchChanges(
    store,
    () => state.value.member !== null,
    () => {
      isPending = true
      showSaved()
    },
    reason => {
      isPending = false
      sync.save(reason)
    },
  )

  const desk: ClassDesk = {
    ...openPupilComments(page, state, send),
    ...sharing.commands,
    state,
    code,
    isTeacher,
    join(typedCode, nickname) {
      dispatch({kind: "asked"})
      if (!socket.send({op: "join", code: typedCode, nickname, language: document.documentElement.lang}))
        dispatch({kind: "link", link: "lost"})
    },
    resume(typedCode, typedWords) {
      dispatch({kind: "asked"})
      if (!socket.send({op: "resume", code: typedCode, words: typedWords}))
        dispatch({kind: "link", link: "lost"})
    },
    showCard(card) {
      if (card === null && state.value.member === null)
        tryToStore(storage.tab, skippedKey, memberships.classId() ?? "")
      dispatch({kind: "card", card})
    },
    raiseHand(up) {
      dispatch({kind: "hand", up})
      send({op: "hand", up})
    },
    openHandout() {
      const {handout} = state.value
      if (handout === null) return
      tryToStore(storage.shared, handoutKey, `${receivedHandouts().slice(-20).join(" ")} ${handout.id}`)
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
      const read = [...readComments().slice(-mostReadComments), commentKey(task)]
      tryToStore(storage.shared, commentsKey, read.join("\n"))
      dispatch({kind: "comments-read", comments: read})
    },
    leave() {
      sync.save("change")
      const programs = memberships.read()?.programs ?? {}
      if (sync.state() !== "saved") return
      const current = loader.storedId()
      if (current !== null && programs[current] !== undefined) loader.newProgram()
      for (const id of Object.keys(programs)) shelf.remove(id, Date.now())
      socket.send({op: "forget"})
      memberships.write(null)
      storage.shared.removeItem(commentsKey)
      progress.left()
      dispatch({kind: "left"})
    },
  }
  const bar = document.getElementById("class-bar")
  if (bar === null) throw new Error("expected #class-bar on the page, found nothing")
  render(<ClassBar desk={desk} />, bar)
  const dialogs = document.createElement("div")
  document.body.append(dialogs)
  render(<ClassDialogs desk={desk} />, dialogs)
}

/// The service could not let the page in, and will later.
const keepsOut = (reason: Refusal): boolean =>
  reason === "attempts" || reason === "disk" || reason === "database"

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

/// Calls `touched` at each change of the program and `save` some time after it, and at every run.
function watchChanges(
  store: Store,
  isMember: () => boolean,
  touched: () => void,
  save: (reason: Reason) => void,
): void {
  let seen = {document: store.now.document.program, name: store.now.name, world: store.now.worldName}
  let runs = store.now.runs
  let timer: ReturnType<typeof setTimeout> | undefined
  const saveNow = (reason: Reason) => {
    clearTimeout(timer)
    timer = undefined
    if (isMember()) save(reason)
  }
  store.onEvent(({document, name, worldName, runs: newest}) => {
    if (newest !== runs) {
      runs = newest
      // After the event: saving dispatches events of its own.
      queueMicrotask(() => saveNow("run"))
    }
    if (document.program === seen.document && name === seen.name && worldName === seen.world) return
    seen = {document: document.program, name, world: worldName}
    if (isMember()) touched()
    timer ??= setTimeout(() => saveNow("change"), savePause)
  })
  const flush = () => timer !== undefined && saveNow("change")
  window.addEventListener("pagehide", flush)
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && flush())
}

/// Tells the board what the page shows, whenever it changes.
function openStatus(store: Store, send: (message: PupilRequest) => boolean) {
  let told = ""
  let session: string | null = null
  const tell = (state: PageState) => {
    if (state.session !== session && state.session !== null && send({op: "here", session: state.session}))
      session = state.session
    const now = statusOf(state)
    const text = JSON.stringify(now)
    if (text !== told && send({op: "status", ...now})) told = text
  }
  store.onFrame(tell)
  return {
    repeat() {
      told = ""
      session = null
      tell(store.now)
    },
  }
}

function statusOf(state: PageState): Omit<Status, "op"> {
  const {open} = state.lessons
  const isError = (finding: {readonly severity: string}) => finding.severity === "error"
  return {
    errors: state.findings.compiler.some(isError) || state.findings.run.some(isError),
    running: isActive(state.run),
    lesson:
      open === null
        ? null
        : {
            name: open.lesson.title,
            done: open.lesson.steps.filter(step => isDone(state.lessons, step)).length,
            steps: open.lesson.steps.length,
          },
  }
}

/// Ends tasks on the page at their deadlines.
function openTaskTimers(end: (task: number) => void): (tasks: readonly OwnTask[]) => void {
  let timers: ReturnType<typeof setTimeout>[] = []
  return tasks => {
    timers.forEach(clearTimeout)
    timers = tasks.flatMap(({id, open, left}) =>
      open && left !== null && left * 1000 <= longestTimer ? [setTimeout(() => end(id), left * 1000)] : [],
    )
  }
}

/// Stops the clock of a simulated run while the class looks up, and lets it go on afterwards. A real robot is stopped.
function openPause(store: Store): (paused: boolean) => void {
  let isOurs = false
  return paused => {
    const {run, clock, robots} = store.now
    if (paused && isActive(run)) {
      if (robots.held !== null) store.dispatch({kind: "stop-pressed"})
      else if (clock === "going") {
        store.dispatch({kind: "pause-pressed"})
        isOurs = true
      }
    } else if (!paused && isOurs) {
      isOurs = false
      if (isActive(run) && clock === "standing") store.dispatch({kind: "resume-pressed"})
    }
  }
}

/// A project file with another name; a file that cannot be read stays as it is.
function renamed(text: string, name: string): string {
  const parsed = parseProject(text)
  return parsed.ok ? saveProject({...parsed.project, name}) : text
}
