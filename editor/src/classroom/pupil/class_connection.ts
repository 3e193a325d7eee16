/// Connection of a pupil's page with its class: the socket, what messages change on the page, and when programs are saved.

import {type Signal, signal} from "@preact/signals"
import {parseProject, saveProject} from "@rosy/codegen"
import type {Store} from "../../browser/store.ts"
import {freshName, freshPlace} from "../../controller/programs/autosave.ts"
import {isActive} from "../../state/runs/run_state.ts"
import type {Refusal} from "../../wire/classroom/message_fields.generated.ts"
import {
  type OwnTask,
  type PupilAnswer,
  type PupilRequest,
  pupilAnswer,
} from "../../wire/classroom/pupil_messages.generated.ts"
import {readerOf} from "../../wire/decode.ts"
import {words} from "../../words/index.ts"
import {type ClassSocket, openClassSocket} from "../messages/class_socket.ts"
import {type Memberships, openMemberships, teacherKey} from "../messages/membership.ts"
import {type ClassAdmission, openClassAdmission} from "./class_admission.ts"
import type {ClassMemory} from "./class_memory.ts"
import {type ClassProgress, openClassProgress} from "./class_progress.ts"
import {type ClassEvent, type ClassState, firstClassState, reduceClass} from "./class_state.ts"
import {type ClassSync, openClassSync} from "./class_sync.ts"
import {type ForeignPrograms, openForeignPrograms} from "./foreign_programs.ts"
import {type InterruptedLessons, openInterruptedLessons} from "./interrupted_lessons.ts"
import {openStatus, watchChanges} from "./page_observers.ts"
import type {PageOfClass} from "./page_of_class.ts"
import {openPupilSharing, type PupilSharing} from "./pupil_sharing.ts"

/// Milliseconds until a request that the service could not store or read is sent again.
const retryPause = 5000

/// Longest timer that browsers keep, in milliseconds (HTML, timer initialization: a signed 32-bit number).
const longestTimer = 2 ** 31 - 1

export class ClassConnection {
  readonly state: Signal<ClassState>
  readonly isTeacher: boolean
  readonly memberships: Memberships
  readonly sync: ClassSync
  readonly sharing: PupilSharing
  readonly progress: ClassProgress
  private readonly memory: ClassMemory
  private readonly socket: ClassSocket<PupilRequest>
  private readonly admission: ClassAdmission
  private readonly status: ReturnType<typeof openStatus>
  private readonly pause: ReturnType<typeof openPause>
  private readonly endTasks: ReturnType<typeof openTaskTimers>
  private readonly foreign: ForeignPrograms
  private readonly lessons: InterruptedLessons
  /// The service has let this connection in.
  private isIn = false
  /// A change waits for the pause after it.
  private isPending = false
  private isRetryDue = false

  constructor(page: PageOfClass, memory: ClassMemory) {
    const {store, storage} = page
    this.memory = memory
    this.isTeacher = storage.shared.getItem(teacherKey) !== null
    this.state = signal({...firstClassState, readComments: memory.readComments()})
    this.socket = openClassSocket("api/class", readerOf(pupilAnswer), {
      opened: () => this.dispatch({kind: "link", link: "open"}),
      lost: () => {
        this.shutOut()
        this.dispatch({kind: "link", link: "lost"})
      },
      received: message => this.heard(message),
    })
    this.memberships = openMemberships(storage.shared)
    this.admission = openClassAdmission(this.memberships, this.sendAlways, this.dispatch)
    this.sync = this.openSync(page)
    this.sharing = openPupilSharing(page, this.state, this.dispatch, this.send)
    this.status = openStatus(store, page.loader.storedId, this.send)
    this.progress = openClassProgress(store, storage.shared, this.send)
    this.pause = openPause(store)
    this.endTasks = openTaskTimers(task => this.dispatch({kind: "task-ended", task}))
    this.foreign = openForeignPrograms(page, this.memberships)
    this.lessons = openInterruptedLessons(page)
    this.watchProgram(store)
  }

  readonly dispatch = (event: ClassEvent): void => {
    this.state.value = reduceClass(this.state.value, event, this.memory.openedHandouts())
  }

  /// What the service would refuse before the page is let in is not sent.
  readonly send = (message: PupilRequest): boolean => {
    const {member, link} = this.state.value
    return member !== null && link === "open" && this.sendAlways(message)
  }

  /// Also before the page is let in; false when there is no connection.
  readonly sendAlways = (message: PupilRequest): boolean => this.socket.send(message)

  private openSync({store, loader, programStore}: PageOfClass): ClassSync {
    /// Stores the open program as if it were changed: without an entry, or with one that has another text now, it gets a new one.
    const storeAnew = () => {
      store.dispatch({kind: "renamed", name: store.now.name})
      loader.store()
    }
    return openClassSync(
      this.memberships,
      programStore,
      {
        id: loader.storedId,
        store: loader.store,
        show: (id, text) => loader.openText(words.yourProgram, text, {id}),
        claim: storeAnew,
        becomeTwo: storeAnew,
      },
      {name: freshName, place: freshPlace, renamed},
      this.send,
      () => this.showSaved(),
    )
  }

  private watchProgram(store: Store): void {
    watchChanges(
      store,
      () => this.state.value.member !== null,
      () => {
        this.isPending = true
        this.showSaved()
      },
      reason => {
        this.isPending = false
        this.sync.save(reason)
      },
    )
  }

  private showSaved(): void {
    this.dispatch({kind: "saved", saved: this.isPending ? "saving" : this.sync.state()})
  }

  private shutOut(): void {
    this.isIn = false
    this.sync.lost()
    this.sharing.lost()
  }

  private heard(message: PupilAnswer): void {
    if (message.op === "class") {
      this.meetClass(message.id)
      return
    }
    this.updateMembership(message)
    if (message.op === "refused" && keepsOut(message.reason) && !this.isIn && this.admission.refused()) {
      this.sync.lost()
      return
    }
    if (message.op === "entered") this.isIn = true
    if (message.op === "refused" && message.reason === "removed") this.shutOut()
    if (message.op === "unsaved" || (message.op === "refused" && message.reason !== "request"))
      this.retryLater()
    const wasUp = this.state.value.hand
    this.sharing.heard(message)
    this.dispatch({kind: "heard", message})
    if (message.op === "entered") this.enter(message, wasUp)
    else if (
      message.op === "program" ||
      message.op === "saved" ||
      message.op === "conflict" ||
      message.op === "unsaved"
    )
      this.sync.heard(message)
    if (message.op === "tasks") this.endTasks(message.tasks)
    // A page that works on without the class is not asked again at each connection.
    if (this.state.value.refused === "removed" && this.memory.hasSkipped(this.memberships.classId() ?? ""))
      this.dispatch({kind: "card", card: null})
    if (message.op === "attention" || message.op === "entered" || message.op === "refused")
      this.pause(this.state.value.attention !== null)
  }

  private meetClass(id: string): void {
    const before = this.memberships.classId()
    const isOther = before !== null && before !== id
    const wasMember = isOther && this.memberships.read() !== null
    if (isOther) {
      this.sync.left()
      if (wasMember) this.lessons.interrupt(before)
      this.dispatch({kind: "class-changed"})
    }
    this.memberships.setClass(id)
    this.progress.meets(id)
    this.foreign.meetClass(isOther, wasMember)
    if (!this.admission.enter() && !this.isTeacher && !this.memory.hasSkipped(id))
      this.dispatch({kind: "card", card: "join"})
  }

  private updateMembership(message: PupilAnswer): void {
    const {memberships} = this
    if (message.op === "entered" && message.token !== null)
      memberships.write({token: message.token, nickname: message.nickname, programs: {}})
    if (message.op === "refused" && message.reason === "token") memberships.write(null)
    if (message.op !== "renamed" && message.op !== "entered") return
    const member = memberships.read()
    if (member !== null) memberships.write({...member, nickname: message.nickname})
  }

  /// `wasUp`: the hand was raised before, perhaps while there was no connection.
  private enter(message: PupilAnswer & {readonly op: "entered"}, wasUp: boolean): void {
    const classId = this.memberships.classId() ?? ""
    const isReplaced = this.foreign.takeReplaced()
    this.sync.entered(message.programs, message.token !== null || isReplaced)
    this.progress.entered(message, classId)
    this.lessons.goOn(classId)
    if (wasUp && !message.hand) this.sendAlways({op: "hand", up: this.state.value.hand})
    this.status.repeat()
  }

  private retryLater(): void {
    if (this.isRetryDue) return
    this.isRetryDue = true
    setTimeout(() => {
      this.isRetryDue = false
      if (this.isIn) this.sync.retry()
    }, retryPause)
  }
}

/// The service could not let the page in, and will later.
const keepsOut = (reason: Refusal): boolean =>
  reason === "attempts" || reason === "disk" || reason === "database"

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
