/// Connection of the teacher's board: its socket, the teacher's key, what messages change, and the tabs and downloads that they fill.

import {downloadBlob} from "../../browser/local_files.ts"
import {pageOfClass, serviceAddress} from "../../browser/service_address.ts"
import {fragmentOf} from "../../browser/share_link.ts"
import {type BrowserStorage, tryToStore} from "../../storage/browser_storage.ts"
import type {BoardRequest, BoardTask, PupilShown} from "../../wire/classroom/board_messages.generated.ts"
import type {RunShown} from "../../wire/classroom/check_messages.generated.ts"
import type {Refusal} from "../../wire/classroom/message_fields.generated.ts"
import {words} from "../../words/index.ts"
import {type BoardMessage, readBoardMessage} from "../messages/board_messages.ts"
import {openClassSocket} from "../messages/class_socket.ts"
import {projectInRoom} from "../messages/hand_in_checks.ts"
import {teacherKey} from "../messages/membership.ts"
import {choiceHeard} from "../messages/projector_choice.ts"
import type {SharingBounds, SharingMessage} from "../messages/shared_messages.ts"
import {isRosterRefusal} from "./board_roster.tsx"
import {board, change, places, rooms, sharingListeners, withResult, withRoomsOfTask} from "./board_state.ts"

export interface BoardConnection {
  /// Whether there was a connection.
  readonly send: (request: BoardRequest) => boolean
  readonly unlock: (key: string) => void
  /// Whether there was something to download.
  readonly download: (task: BoardTask) => Promise<boolean>
  /// Downloads everything that the class stores; whether that was possible.
  readonly backUp: () => Promise<boolean>
  /// Downloads what a study of the class may use; whether that was possible.
  readonly exportStudy: () => Promise<boolean>
  /// Opens a pupil's program for a task in one of the rooms of its check, by the number of the room.
  readonly openRun: (task: number, pupil: number, room: number) => void
  /// Opens the page for the projector in a window of its own.
  readonly openProjector: () => void
}

/// Connects with the key of the address, or with the one that this tab had before.
export function openBoardConnection(storage: BrowserStorage): BoardConnection {
  const brought = new URLSearchParams(window.location.hash.slice(1)).get("key")
  // Out of the address, so that it is not on the projector.
  if (brought !== null) window.history.replaceState(null, "", window.location.pathname)
  const tabs = openRunTabs()
  let key = brought ?? storage.tab.getItem(teacherKey)
  const socket = openClassSocket<BoardRequest, BoardMessage>("api/board", readBoardMessage, {
    opened() {
      change({link: "open"})
      if (key !== null) socket.send({op: "unlock", key})
    },
    lost() {
      change({link: "lost"})
      hearSharing({op: "sharing-over", why: "ended"})
    },
    received(message) {
      if (message.op === "board") {
        tryToStore(storage.tab, teacherKey, key ?? "")
        tryToStore(storage.shared, teacherKey, "yes")
        change({
          class: message,
          attention: message.attention,
          refused: null,
          storeFault: null,
          door: {locked: false, removed: []},
          study: {contact: null, takingPart: 0},
          results: new Map(),
        })
      } else if (message.op === "refused") {
        if (message.reason === "key" || message.reason === "attempts") storage.tab.removeItem(teacherKey)
        showRefusal(message.reason)
      } else if (message.op === "door") change({door: {locked: message.locked, removed: message.removed}})
      else if (message.op === "study")
        change({study: {contact: message.contact, takingPart: message.takingPart}})
      else if (message.op === "pupils-added")
        change({added: {added: message.added, refused: message.refused}})
      else if (message.op === "store") change({storeFault: message.fault})
      else if (message.op === "suspended") change({suspended: message})
      else if (message.op === "pupils") showPupils(message.pupils, message.mostIdle)
      else if (message.op === "room") rooms.value = new Map([...rooms.value, [message.pupil, message.world]])
      else if (message.op === "places")
        places.value = new Map([
          ...places.value,
          ...message.places.map(place => [place.pupil, place] as const),
        ])
      else if (message.op === "tasks") change({tasks: message.tasks, taskRefused: null})
      else if (message.op === "lessons") change({lessons: message.lessons})
      else if (message.op === "projecting") {
        const {choice, request} = choiceHeard(board.value, message)
        change(choice)
        if (request !== null) socket.send(request)
      } else if (message.op === "comments") change({comments: message.comments})
      else if (message.op === "sent") change({said: sentence(message)})
      else if (message.op === "checking") change({checking: message})
      else if (message.op === "result") change({results: withResult(board.value.results, message)})
      else if (message.op === "rooms") change({results: withRoomsOfTask(board.value.results, message)})
      else if (message.op === "run") void tabs.fill(message)
      else if (message.op === "program-changed") {
        const {shown} = board.value
        if (shown !== null && shown.pupil === message.pupil && shown.program === message.program)
          change({shown: {...shown, name: message.name, newer: message.text}})
      } else if (message.op === "share-waiting") change({sharing: "asked", sharingRefused: null})
      else if (
        message.op === "shared" ||
        message.op === "sharing-over" ||
        message.op === "updates" ||
        message.op === "cursor"
      )
        hearSharing(message)
      else void show(message)
    },
  })
  const send = (request: BoardRequest) => {
    if (request.op === "check-all" || request.op === "check-new") change({checkRefused: null})
    if (rosterRequests.includes(request.op)) change({added: null, rosterRefused: null})
    const isSent = socket.send(request)
    if (!isSent) change({link: "lost"})
    return isSent
  }
  const unlock = (typed: string) => {
    key = typed.trim()
    send({op: "unlock", key})
  }
  const openRun = (task: number, pupil: number, room: number) => {
    tabs.open(pupil, room)
    send({op: "open-run", task, pupil, room})
  }
  // Always the same window: a second press brings it to the front.
  const openProjector = () => {
    const projector = pageOfClass("./projector.html", window.location)
    projector.hash = `key=${key ?? ""}`
    window.open(projector, "rosy-projector")
  }
  return {send, unlock, ...downloads(() => key ?? ""), openRun, openProjector}
}

const rosterRequests: readonly BoardRequest["op"][] = [
  "add-pupils",
  "rename-pupil",
  "remove-pupils",
  "restore-pupil",
  "merge-pupils",
]

function showRefusal(reason: Refusal): void {
  const w = words.classroom.board
  if (reason === "key" || reason === "attempts")
    change({refused: words.classroom.refused[reason], class: null})
  else if (reason === "deadline" || reason === "tasks" || reason === "disk" || reason === "database")
    change({taskRefused: w.refused[reason]})
  else if (reason === "comments") change({commentRefused: w.refused.comments})
  else if (isRosterRefusal(reason)) change({rosterRefused: w.roster.refused[reason]})
  else if (reason === "busy" || reason === "away") change({sharingRefused: w.refused[reason]})
  else if (reason === "rooms") change({checkRefused: w.check.refused})
}

/// Who is not in the class any more is not selected.
function showPupils(pupils: readonly PupilShown[], mostIdle: boolean): void {
  const {selected} = board.value
  change({pupils, mostIdle, selected: new Set(pupils.map(({id}) => id).filter(id => selected.has(id)))})
}

function hearSharing(message: SharingMessage | SharingBounds): void {
  const {sharing} = board.value
  if (message.op === "shared") change({sharing: "on", sharingLine: null})
  else if (message.op === "sharing-over" && (sharing === "asked" || sharing === "on"))
    change({sharing: message.why})
  for (const heard of sharingListeners) heard(message)
}

/// Tabs for pupils' programs in rooms of a check. A browser lets a page open one only while a click is served, so it is empty until the program arrives.
function openRunTabs() {
  const waiting = new Map<string, Window | null>()
  const keyOf = (pupil: number, room: number) => `${pupil} ${room}`
  return {
    open(pupil: number, room: number) {
      const key = keyOf(pupil, room)
      waiting.get(key)?.close()
      waiting.set(key, window.open("", "_blank"))
    },
    async fill({pupil, room, name, text, world, seed}: RunShown) {
      const key = keyOf(pupil, room)
      const tab = waiting.get(key)
      waiting.delete(key)
      if (text === null) return tab?.close()
      const nickname = board.value.pupils.find(one => one.id === pupil)?.nickname ?? ""
      const project = projectInRoom(text, words.classroom.board.programOf(nickname, name), world)
      const address = new URL(`./?seed=${seed}&run${await fragmentOf(project)}`, window.location.href)
      tab?.location.replace(address.href)
    },
  }
}

/// ZIP files that the service makes, with the teacher's key; whether there was one.
function downloads(keyNow: () => string): Pick<BoardConnection, "download" | "backUp" | "exportStudy"> {
  const today = () => new Date().toISOString().slice(0, 10)
  return {
    download: task => downloadZip(`api/hand-ins/${task.id}`, `${task.title}.zip`, keyNow()),
    backUp: () => downloadZip("api/class-backup", `rosy-class-${today()}.zip`, keyNow()),
    exportStudy: () => downloadZip("api/class-study", `rosy-study-${today()}.zip`, keyNow()),
  }
}

async function downloadZip(path: string, name: string, key: string): Promise<boolean> {
  try {
    const address = await serviceAddress(path, window.location)
    if (address === null) return false
    const answer = await fetch(address, {headers: {"X-Rosy-Key": key}})
    if (!answer.ok) return false
    downloadBlob(name, await answer.blob())
    return true
  } catch (fault) {
    // The service is away.
    if (fault instanceof TypeError) return false
    throw fault
  }
}

/// Whom something was sent to.
function sentence({pages, later}: BoardMessage & {readonly op: "sent"}): string {
  const w = words.classroom.board
  return later === 0 ? w.sent(pages) : `${w.sent(pages)} ${w.sentLater(later)}`
}

async function show(message: BoardMessage & {readonly op: "program"}): Promise<void> {
  const pupil = board.value.pupils.find(one => one.id === message.pupil)
  if (message.text === null || pupil === undefined) return
  const address = `./?embed=board${await fragmentOf(message.text)}`
  const {nickname, id} = pupil
  change({
    shown: {pupil: id, nickname, name: message.name, address, program: message.program, newer: null},
    commentRefused: null,
    sharing: null,
    sharingRefused: null,
  })
}
