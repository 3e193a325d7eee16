/// Messages of the teacher's board, both ways (protocol §11).

import type {PlaceInProgram} from "../state/block_comments.ts"
import {
  boolean,
  type Decoded,
  type Decoder,
  decode,
  list,
  Mismatch,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
} from "../state/decode.ts"
import type {Pose, World} from "../worlds/world.ts"
import {readWorld} from "../worlds/world_decoder.ts"
import {
  type LessonProgress,
  type OwnComment,
  ownComment,
  type Refusal,
  refusals,
  type Shared,
  type StoreFault,
  storeFaults,
} from "./class_messages.ts"
import {
  type Checking,
  type CheckRequest,
  type CheckResult,
  checking,
  checkResult,
  type NewCheckRequest,
  type RoomsOfResult,
  type RunInRoom,
  roomsOfResult,
  runInRoom,
} from "./hand_in_checks.ts"
import {
  type SharingBounds,
  type SharingMessage,
  type SharingRequest,
  sharingMessage,
  sharingOps,
} from "./shared_messages.ts"

/// Why a pupil may need help, the most urgent first.
export const needs = ["hand", "error", "idle"] as const

export type Need = (typeof needs)[number]

export interface PupilOnBoard {
  readonly id: number
  readonly nickname: string
  readonly words: string
  readonly online: boolean
  readonly running: boolean
  /// The program that was stored last, and the seconds since then.
  readonly program: string | null
  readonly changed: number | null
  readonly lesson: LessonProgress | null
  readonly needs: readonly Need[]
  /// Comments on places in the pupil's programs, and those that the pupil has dealt with.
  readonly comments: number
  readonly done: number
}

export interface Place extends Pose {
  readonly pupil: number
}

/// A pupil's newest hand-in for a task; `at` in seconds since 1970.
export interface HandedIn {
  readonly pupil: number
  readonly at: number
  readonly name: string
  readonly comment: string
  /// Pupils whose programs differ from it in comments, layout and names of their own only.
  readonly alike: readonly number[]
}

/// Times in seconds since 1970.
export interface BoardTask {
  readonly id: number
  readonly title: string
  readonly opened: number
  readonly deadline: number | null
  readonly open: boolean
  readonly handedIn: readonly HandedIn[]
  /// There was a check of all hand-ins.
  readonly checked: boolean
}

/// How the projector shows pupils: with their nicknames, and with their programs beside the room.
export interface ProjectorSight {
  readonly named: boolean
  readonly program: boolean
}

export type BoardMessage =
  | {readonly op: "share-waiting"; readonly pupil: number; readonly program: string}
  | SharingMessage
  | SharingBounds
  | ({readonly op: "projecting"; readonly pupil: number | null} & ProjectorSight)
  | {
      readonly op: "board"
      readonly code: string
      readonly addresses: readonly string[]
      readonly attention: string | null
    }
  /// Why nothing can be stored now; `null` when it can.
  | {readonly op: "store"; readonly fault: StoreFault | null}
  | {readonly op: "pupils"; readonly pupils: readonly PupilOnBoard[]}
  | {readonly op: "room"; readonly pupil: number; readonly world: World}
  | {readonly op: "places"; readonly places: readonly Place[]}
  | {
      readonly op: "program"
      readonly pupil: number
      readonly name: string
      readonly text: string | null
      /// Its identifier; `null` for a hand-in.
      readonly program: string | null
    }
  | {
      readonly op: "program-changed"
      readonly pupil: number
      readonly program: string
      readonly name: string
      readonly text: string
    }
  | {readonly op: "comments"; readonly pupil: number; readonly comments: readonly OwnComment[]}
  | {readonly op: "sent"; readonly pages: number; readonly later: number}
  | {readonly op: "refused"; readonly reason: Refusal}
  | {readonly op: "tasks"; readonly tasks: readonly BoardTask[]}
  | ({readonly op: "checking"} & Checking)
  | {
      readonly op: "result"
      readonly task: number
      readonly pupil: number
      readonly result: CheckResult | null
    }
  | ({readonly op: "rooms"} & RoomsOfResult)
  | ({readonly op: "run"} & RunInRoom)

export type BoardRequest =
  | {readonly op: "ask-to-share"; readonly pupil: number; readonly program: string}
  | SharingRequest
  | {readonly op: "unlock"; readonly key: string}
  | {readonly op: "open"; readonly pupil: number; readonly program: string | null}
  | {readonly op: "attention"; readonly message: string | null}
  | {readonly op: "lower"; readonly pupil: number}
  /// `pupils` is `null` for all.
  | {
      readonly op: "send"
      readonly what: Shared
      readonly name: string
      readonly text: string
      readonly pupils: readonly number[] | null
    }
  | {readonly op: "open-task"; readonly title: string; readonly deadline: number | null}
  | {readonly op: "close-task"; readonly task: number}
  | {readonly op: "open-hand-in"; readonly task: number; readonly pupil: number}
  | {readonly op: "comment"; readonly task: number; readonly pupil: number; readonly text: string}
  | {
      readonly op: "add-comment"
      readonly pupil: number
      readonly program: string
      readonly text: string
      readonly place: PlaceInProgram
    }
  | {readonly op: "remove-comment"; readonly comment: number}
  | ({readonly op: "project"; readonly pupil: number | null} & ProjectorSight)
  | CheckRequest
  | NewCheckRequest
  | {readonly op: "cancel-check"}
  | {readonly op: "show-results"; readonly task: number}
  | {readonly op: "show-rooms"; readonly task: number; readonly pupil: number}
  | {readonly op: "open-run"; readonly task: number; readonly pupil: number; readonly room: number}

const lesson = object<LessonProgress>(get => ({
  name: get("name", string),
  done: get("done", number),
  steps: get("steps", number),
}))
const pupil = object<PupilOnBoard>(get => ({
  id: get("id", number),
  nickname: get("nickname", string),
  words: get("words", string),
  online: get("online", boolean),
  running: get("running", boolean),
  program: get("program", optional(string, null)),
  changed: get("changed", optional(number, null)),
  lesson: get("lesson", optional(lesson, null)),
  needs: get("needs", list(oneOf(...needs))),
  comments: get("comments", number),
  done: get("done", number),
}))
const handedIn = object<HandedIn>(get => ({
  pupil: get("pupil", number),
  at: get("at", number),
  name: get("name", string),
  comment: get("comment", string),
  alike: get("alike", list(number)),
}))
const task = object<BoardTask>(get => ({
  id: get("id", number),
  title: get("title", string),
  opened: get("opened", number),
  deadline: get("deadline", optional(number, null)),
  open: get("open", boolean),
  handedIn: get("handed_in", list(handedIn)),
  checked: get("checked", boolean),
}))
export const world: Decoder<World> = (value, path) => {
  const read = readWorld(value)
  if (read.kind === "fault") throw new Mismatch(path, "a room")
  return read.world
}
const place: Decoder<Place> = (value, path) => {
  const [id, x, y, theta] = list(number)(value, path)
  if (id === undefined || x === undefined || y === undefined || theta === undefined)
    throw new Mismatch(path, "a pupil and a pose")
  return {pupil: id, x, y, theta}
}

const boardMessage: Decoder<BoardMessage> = (value, path) => {
  const op = object(get =>
    get(
      "op",
      oneOf(
        "board",
        "store",
        "pupils",
        "room",
        "places",
        "program",
        "projecting",
        "comments",
        "sent",
        "refused",
        "tasks",
        "checking",
        "result",
        "rooms",
        "run",
        "share-waiting",
        "program-changed",
        ...sharingOps,
      ),
    ),
  )(value, path)
  if (op === "checking") return {op, ...checking(value, path)}
  if (op === "updates" || op === "cursor" || op === "shared" || op === "sharing-over")
    return sharingMessage(value, path)
  if (op === "rooms") return {op, ...roomsOfResult(value, path)}
  if (op === "run") return {op, ...runInRoom(value, path)}
  return object<BoardMessage>(get => {
    switch (op) {
      case "store":
        return {op, fault: get("fault", optional(oneOf(...storeFaults), null))}
      case "board":
        return {
          op,
          code: get("code", string),
          addresses: get("addresses", list(string)),
          attention: get("attention", optional(string, null)),
        }
      case "program-changed":
        return {
          op,
          pupil: get("pupil", number),
          program: get("program", string),
          name: get("name", string),
          text: get("text", string),
        }
      case "share-waiting":
        return {op, pupil: get("pupil", number), program: get("program", string)}
      case "pupils":
        return {op, pupils: get("pupils", list(pupil))}
      case "room":
        return {op, pupil: get("pupil", number), world: get("world", world)}
      case "places":
        return {op, places: get("places", list(place))}
      case "program":
        return {
          op,
          pupil: get("pupil", number),
          name: get("name", string),
          text: get("text", optional(string, null)),
          program: get("program", optional(string, null)),
        }
      case "projecting":
        return {
          op,
          pupil: get("pupil", optional(number, null)),
          named: get("named", boolean),
          program: get("program", boolean),
        }
      case "comments":
        return {op, pupil: get("pupil", number), comments: get("comments", list(ownComment))}
      case "sent":
        return {op, pages: get("pages", number), later: get("later", number)}
      case "refused":
        return {op, reason: get("reason", oneOf(...refusals))}
      case "tasks":
        return {op, tasks: get("tasks", list(task))}
      case "result":
        return {
          op,
          task: get("task", number),
          pupil: get("pupil", number),
          result: get("result", optional(checkResult, null)),
        }
    }
  })(value, path)
}

export function readBoardMessage(text: string): Decoded<BoardMessage> {
  return decode(boardMessage, parseJson(text))
}
