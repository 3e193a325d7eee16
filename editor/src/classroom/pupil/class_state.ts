/// State of class mode on a pupil's page: what the card, the class bar and the eyes-up message show. Pure.

import {hashOf} from "@rosy/codegen"
import type {Refusal} from "../../wire/classroom/message_fields.generated.ts"
import type {
  Handout,
  OwnComment,
  OwnStudy,
  OwnTask,
  PupilAnswer,
} from "../../wire/classroom/pupil_messages.generated.ts"
import type {Asked} from "../../wire/classroom/shared_messages.generated.ts"
import type {SyncState} from "./class_sync.ts"

export interface ClassState {
  readonly link: "connecting" | "open" | "lost"
  readonly member: {readonly nickname: string; readonly words: string} | null
  /// `join` asks for code and nickname, `words` shows the three words.
  readonly card: "join" | "words" | null
  /// A request of the card waits for its answer.
  readonly asked: boolean
  readonly refused: Refusal | null
  readonly saved: SyncState
  readonly hand: boolean
  readonly attention: string | null
  /// A program, a room or a lesson from the teacher that was not opened yet.
  readonly handout: Handout | null
  /// The pupil opens it later; a button shows it again.
  readonly isHandoutFolded: boolean
  /// The open task, and those for which the pupil handed in, oldest first.
  readonly tasks: readonly OwnTask[]
  /// The last press of "Hand in": it waits for its answer, or why the program was not handed in.
  readonly handIn: {readonly task: number; readonly state: HandInState} | null
  /// Comments that the pupil has closed, by `commentKey`.
  readonly readComments: readonly string[]
  /// The teacher's comments on places in the pupil's programs, oldest first.
  readonly blockComments: readonly OwnComment[]
  /// Editing together with the teacher.
  readonly sharing: Sharing | null
  /// The study in which the class takes part, and the pupil's answer.
  readonly study: {readonly contact: string; readonly takesPart: OwnStudy["takesPart"]} | null
}

export type Sharing =
  | ({readonly kind: "asked"} & Omit<Asked, "op">)
  /// `line` is the line of the teacher's cursor.
  | {readonly kind: "on"; readonly line: number | null}
  | {readonly kind: "ended"}
  /// The program that the teacher asked about is not in this browser.
  | {readonly kind: "gone"; readonly name: string}

export type HandInState = "asked" | "late" | "full" | "database" | "offline"

/// Names a comment; a changed comment on the same hand-in is another one.
export const commentKey = (task: OwnTask): string => `${task.id} ${hashOf(task.handedIn?.comment ?? "")}`

export const firstClassState: ClassState = {
  link: "connecting",
  member: null,
  card: null,
  asked: false,
  refused: null,
  saved: "saved",
  hand: false,
  attention: null,
  handout: null,
  isHandoutFolded: false,
  tasks: [],
  handIn: null,
  readComments: [],
  blockComments: [],
  sharing: null,
  study: null,
}

export type ClassEvent =
  | {readonly kind: "heard"; readonly message: PupilAnswer}
  | {readonly kind: "link"; readonly link: ClassState["link"]}
  | {readonly kind: "card"; readonly card: ClassState["card"]}
  | {readonly kind: "asked"}
  | {readonly kind: "saved"; readonly saved: ClassState["saved"]}
  | {readonly kind: "hand"; readonly up: boolean}
  | {readonly kind: "handout-closed"}
  | {readonly kind: "handout-folded"; readonly folded: boolean}
  | {readonly kind: "hand-in"; readonly task: number; readonly state: HandInState}
  | {readonly kind: "task-ended"; readonly task: number}
  | {readonly kind: "comments-read"; readonly comments: readonly string[]}
  | {readonly kind: "sharing"; readonly sharing: Sharing | null}
  | {readonly kind: "sharing-line"; readonly line: number | null}
  | {readonly kind: "left"}
  /// The service runs another class than before.
  | {readonly kind: "class-changed"}

/// `receivedHandouts` are those that this browser has shown before.
export function reduceClass(
  state: ClassState,
  event: ClassEvent,
  receivedHandouts: readonly string[] = [],
): ClassState {
  switch (event.kind) {
    case "heard":
      return heard(state, event.message, receivedHandouts)
    case "link":
      return {
        ...state,
        link: event.link,
        asked: false,
        handIn: lostHandIn(state, event.link),
        // Who has no connection works on; the message comes again with the connection.
        attention: event.link === "lost" ? null : state.attention,
        sharing: event.link === "lost" ? endedSharing(state.sharing) : state.sharing,
      }
    case "card":
      return {...state, card: event.card, refused: null}
    case "asked":
      return {...state, asked: true, refused: null}
    case "saved":
      return {...state, saved: event.saved}
    case "hand":
      return {...state, hand: event.up}
    case "handout-closed":
      return {...state, handout: null, isHandoutFolded: false}
    case "handout-folded":
      return {...state, isHandoutFolded: event.folded}
    case "hand-in":
      return {...state, handIn: {task: event.task, state: event.state}}
    case "task-ended":
      return {...state, tasks: ended(state.tasks, event.task)}
    case "comments-read":
      return {...state, readComments: event.comments}
    case "sharing":
      return {...state, sharing: event.sharing}
    case "sharing-line":
      return state.sharing?.kind === "on" ? {...state, sharing: {kind: "on", line: event.line}} : state
    case "left":
      return {...firstClassState, link: state.link, card: "join"}
    case "class-changed":
      return {...firstClassState, link: state.link}
  }
}

/// A question is withdrawn, or editing together has ended.
function endedSharing(sharing: Sharing | null): Sharing | null {
  if (sharing?.kind === "on") return {kind: "ended"}
  return sharing?.kind === "asked" ? null : sharing
}

/// A hand-in whose answer was lost with the connection.
function lostHandIn({handIn}: ClassState, link: ClassState["link"]): ClassState["handIn"] {
  return link === "lost" && handIn?.state === "asked" ? {...handIn, state: "offline"} : handIn
}

/// A task whose deadline has passed is shown on if the pupil handed in.
function ended(tasks: readonly OwnTask[], id: number): readonly OwnTask[] {
  return tasks
    .map(task => (task.id === id ? {...task, open: false} : task))
    .filter(task => task.open || task.handedIn !== null)
}

/// The tasks that the bar shows: the open one, and those with a comment that the pupil has not closed.
export function shownTasks({tasks, readComments}: ClassState): readonly OwnTask[] {
  const newest = tasks.at(-1)
  return tasks.filter(task => task.open || task === newest || isUnread(task, readComments))
}

export function isUnread(task: OwnTask, readComments: readonly string[]): boolean {
  return task.handedIn !== null && task.handedIn.comment !== "" && !readComments.includes(commentKey(task))
}

function heard(state: ClassState, message: PupilAnswer, receivedHandouts: readonly string[]): ClassState {
  switch (message.op) {
    case "entered": {
      const {nickname, words, hand, token} = message
      const card = token === null ? null : "words"
      // A hand that was raised while there was no connection stays up.
      return {
        ...state,
        member: {nickname, words},
        hand: hand || (state.hand && state.member !== null),
        asked: false,
        refused: null,
        card,
        attention: null,
        // It comes again while the study goes on.
        study: null,
      }
    }
    case "refused":
      if (message.reason === "request") return state
      if (message.reason === "removed")
        return {...firstClassState, link: state.link, card: "join", refused: "removed"}
      // A browser that the class does not know any more asks for the code.
      if (message.reason === "token") return {...state, member: null, card: "join", asked: false}
      return {...state, refused: message.reason, asked: false}
    case "asked-to-share": {
      const {number, program, name} = message
      return {...state, sharing: {kind: "asked", number, program, name}}
    }
    case "sharing-over":
      return {...state, sharing: endedSharing(state.sharing)}
    case "attention":
      return {...state, attention: message.message}
    case "handout":
      if (receivedHandouts.includes(message.id)) return state
      // After a reconnection it comes again.
      return {
        ...state,
        handout: message,
        isHandoutFolded: state.isHandoutFolded && state.handout?.id === message.id,
      }
    case "lowered":
      return {...state, hand: false}
    case "renamed":
      return state.member === null ? state : {...state, member: {...state.member, nickname: message.nickname}}
    case "tasks":
      return {...state, tasks: message.tasks, handIn: state.handIn?.state === "asked" ? null : state.handIn}
    case "not-handed-in":
      return {...state, handIn: {task: message.task, state: message.reason}}
    case "comments":
      return {...state, blockComments: message.comments}
    case "study": {
      const {contact, takesPart} = message
      return {...state, study: contact === null ? null : {contact, takesPart}}
    }
    case "class":
    case "program":
    case "saved":
    case "conflict":
    case "unsaved":
    case "shared":
    case "updates":
    case "cursor":
      return state
  }
}
