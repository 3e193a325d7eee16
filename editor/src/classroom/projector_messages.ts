/// Messages of the projector, both ways (protocol §11).

import {
  boolean,
  type Decoded,
  decode,
  list,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
} from "../state/decode.ts"
import {readServiceMessage} from "../state/message_decoder.ts"
import type {Frame} from "../state/messages.ts"
import type {World} from "../worlds/world.ts"
import {world} from "./board_messages.ts"
import {type Refusal, refusals} from "./class_messages.ts"

export interface Projected {
  /// Another one whenever the teacher chooses another pupil.
  readonly number: number
  readonly shows: boolean
  /// `null` for a pupil who is not named.
  readonly nickname: string | null
  readonly online: boolean
  readonly running: boolean
  /// `null` without a program beside the room.
  readonly haskell: string | null
}

/// How pupils join.
export interface Invited {
  readonly code: string
  readonly addresses: readonly string[]
}

export interface ProjectorRequest {
  readonly op: "unlock"
  readonly key: string
}

export type ProjectorMessage =
  | ({readonly op: "projected"} & Projected)
  | ({readonly op: "invitation"} & Invited)
  | {readonly op: "room"; readonly world: World}
  | {readonly op: "frame"; readonly frame: Frame}
  | {readonly op: "refused"; readonly reason: Refusal}

const message = object<ProjectorMessage>(get => {
  const op = get("op", oneOf("projected", "invitation", "room", "refused"))
  if (op === "refused") return {op, reason: get("reason", oneOf(...refusals))}
  if (op === "invitation") return {op, code: get("code", string), addresses: get("addresses", list(string))}
  if (op === "room") return {op, world: get("world", world)}
  return {
    op,
    number: get("number", number),
    shows: get("shows", boolean),
    nickname: get("nickname", optional(string, null)),
    online: get("online", boolean),
    running: get("running", boolean),
    haskell: get("haskell", optional(string, null)),
  }
})

/// Frames are those of a page (protocol §4).
export function readProjectorMessage(text: string): Decoded<ProjectorMessage> {
  const read = readServiceMessage(text)
  if (read.kind === "ok" && read.value.op === "frame") return {kind: "ok", value: read.value}
  return decode(message, parseJson(text))
}
