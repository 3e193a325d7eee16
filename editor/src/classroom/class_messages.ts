/// Messages of a pupil's page in class mode, both ways (protocol §11).

import type {BlockComment, PlaceInProgram} from "../state/block_comments.ts"
import {
  boolean,
  type Decoded,
  type Decoder,
  decode,
  list,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
} from "../state/decode.ts"
import {
  type SharingBounds,
  type SharingMessage,
  type SharingRequest,
  sharingMessage,
  sharingOps,
} from "./shared_messages.ts"

export const refusals = [
  "code",
  "words",
  "token",
  "key",
  "attempts",
  "taken",
  "full",
  "request",
  "deadline",
  "tasks",
  "disk",
  "rooms",
  "comments",
  "busy",
  "away",
  "database",
  "nickname-empty",
  "nickname-long",
  "nickname-letters",
] as const
export type Refusal = (typeof refusals)[number]

export type SaveReason = "change" | "run"

/// Why the class could not store anything: the disk is full or broken, or the database does not answer.
export const storeFaults = ["disk", "database"] as const
export type StoreFault = (typeof storeFaults)[number]
/// Why it could not store a program: `full` when the pupil's share of the disk is.
export type SaveFault = "full" | StoreFault

/// A program of the pupil as the service has it.
export interface ProgramEntry {
  readonly id: string
  readonly name: string
  readonly version: number
  /// Seconds since 1970.
  readonly at: number
}

export interface LessonProgress {
  readonly name: string
  readonly done: number
  readonly steps: number
}

export interface PageStatus {
  readonly errors: boolean
  readonly running: boolean
  readonly lesson: LessonProgress | null
}

/// A task as the pupil sees it. Times in seconds since 1970.
export interface OwnTask {
  readonly id: number
  readonly title: string
  readonly open: boolean
  readonly deadline: number | null
  /// Seconds until the deadline, when the message was sent; clocks of devices differ.
  readonly left: number | null
  readonly handedIn: {readonly at: number; readonly name: string; readonly comment: string} | null
}

export const sharedKinds = ["program", "room", "lesson"] as const
export type Shared = (typeof sharedKinds)[number]

/// What a teacher sent: `text` is a project file, a world as JSON (or the name of one of the gallery as a JSON string), or the name of a lesson.
export interface Handout {
  readonly id: string
  readonly what: Shared
  readonly name: string
  readonly text: string
}

/// The teacher's comment on a place in a program; `at` in seconds since 1970.
export interface OwnComment extends BlockComment {
  readonly program: string
  readonly at: number
  readonly done: boolean
}

export type PupilMessage =
  | {readonly op: "join"; readonly code: string; readonly nickname: string; readonly language: string}
  | {readonly op: "resume"; readonly code: string; readonly words: string}
  | {readonly op: "enter"; readonly token: string}
  | {readonly op: "forget"}
  | {readonly op: "here"; readonly session: string}
  | {
      readonly op: "save"
      readonly program: string
      readonly name: string
      readonly text: string
      readonly reason: SaveReason
      readonly base: number
      readonly mark: string
      readonly unacknowledged: readonly string[]
    }
  | {readonly op: "read"; readonly program: string}
  | ({readonly op: "status"} & PageStatus)
  | {readonly op: "hand"; readonly up: boolean}
  | {readonly op: "hand-in"; readonly task: number; readonly name: string; readonly text: string}
  | {readonly op: "comment-done"; readonly comment: number; readonly done: boolean}
  | {readonly op: "share"; readonly number: number; readonly project: string; readonly text: string}
  | {readonly op: "decline"; readonly number: number}
  | SharingRequest

/// The teacher asks to edit a program together with the pupil.
export interface SharingQuestion {
  readonly number: number
  readonly program: string
  readonly name: string
}

export type ClassMessage =
  | ({readonly op: "asked-to-share"} & SharingQuestion)
  | SharingMessage
  | SharingBounds
  | {
      readonly op: "entered"
      readonly pupil: number
      readonly nickname: string
      readonly words: string
      readonly token: string | null
      readonly hand: boolean
      readonly programs: readonly ProgramEntry[]
    }
  | {readonly op: "refused"; readonly reason: Refusal}
  | {
      readonly op: "program"
      readonly program: string
      readonly version: number
      readonly name: string
      readonly text: string
    }
  | {readonly op: "saved"; readonly program: string; readonly mark: string; readonly version: number}
  | {
      readonly op: "conflict"
      readonly program: string
      readonly mark: string
      readonly version: number
      readonly name: string
      readonly text: string
    }
  | {readonly op: "unsaved"; readonly program: string; readonly mark: string; readonly reason: SaveFault}
  | {readonly op: "attention"; readonly message: string | null}
  | ({readonly op: "handout"} & Handout)
  | {readonly op: "lowered"}
  | {readonly op: "tasks"; readonly tasks: readonly OwnTask[]}
  | {readonly op: "not-handed-in"; readonly task: number; readonly reason: "late" | "full" | "database"}
  | {readonly op: "comments"; readonly comments: readonly OwnComment[]}

const entry = object<ProgramEntry>(get => ({
  id: get("id", string),
  name: get("name", string),
  version: get("version", number),
  at: get("at", number),
}))

const handedIn = object<NonNullable<OwnTask["handedIn"]>>(get => ({
  at: get("at", number),
  name: get("name", string),
  comment: get("comment", string),
}))
const ownTask = object<OwnTask>(get => ({
  id: get("id", number),
  title: get("title", string),
  open: get("open", boolean),
  deadline: get("deadline", optional(number, null)),
  left: get("left", optional(number, null)),
  handedIn: get("handed_in", optional(handedIn, null)),
}))

const place = object<PlaceInProgram>(get => ({
  definition: get("definition", optional(string, null)),
  piece: get("piece", string),
  start: get("start", number),
  end: get("end", number),
}))
export const ownComment = object<OwnComment>(get => ({
  id: get("id", number),
  program: get("program", string),
  at: get("at", number),
  text: get("text", string),
  place: get("place", place),
  done: get("done", boolean),
}))

const classMessage: Decoder<ClassMessage> = (value, path) => {
  const op = object(get =>
    get(
      "op",
      oneOf(
        "entered",
        "refused",
        "program",
        "saved",
        "conflict",
        "unsaved",
        "attention",
        "handout",
        "lowered",
        "tasks",
        "not-handed-in",
        "comments",
        "asked-to-share",
        ...sharingOps,
      ),
    ),
  )(value, path)
  if (op === "updates" || op === "cursor" || op === "shared" || op === "sharing-over")
    return sharingMessage(value, path)
  return object<ClassMessage>(get => {
    switch (op) {
      case "asked-to-share":
        return {op, number: get("number", number), program: get("program", string), name: get("name", string)}
      case "entered":
        return {
          op,
          pupil: get("pupil", number),
          nickname: get("nickname", string),
          words: get("words", string),
          token: get("token", optional(string, null)),
          hand: get("hand", boolean),
          programs: get("programs", list(entry)),
        }
      case "refused":
        return {op, reason: get("reason", oneOf(...refusals))}
      case "program":
        return {
          op,
          program: get("program", string),
          version: get("version", number),
          name: get("name", string),
          text: get("text", string),
        }
      case "saved":
        return {
          op,
          program: get("program", string),
          mark: get("mark", string),
          version: get("version", number),
        }
      case "conflict":
        return {
          op,
          program: get("program", string),
          mark: get("mark", string),
          version: get("version", number),
          name: get("name", string),
          text: get("text", string),
        }
      case "unsaved":
        return {
          op,
          program: get("program", string),
          mark: get("mark", string),
          reason: get("reason", oneOf("full", ...storeFaults)),
        }
      case "attention":
        return {op, message: get("message", optional(string, null))}
      case "handout":
        return {
          op,
          id: get("id", string),
          what: get("what", oneOf(...sharedKinds)),
          name: get("name", string),
          text: get("text", string),
        }
      case "lowered":
        return {op}
      case "tasks":
        return {op, tasks: get("tasks", list(ownTask))}
      case "not-handed-in":
        return {op, task: get("task", number), reason: get("reason", oneOf("late", "full", "database"))}
      case "comments":
        return {op, comments: get("comments", list(ownComment))}
    }
  })(value, path)
}

export function readClassMessage(text: string): Decoded<ClassMessage> {
  return decode(classMessage, parseJson(text))
}
