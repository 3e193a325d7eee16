/// Messages of a program that the teacher and a pupil edit together, of the pupil's page and of the board (protocol §11.1).

import type {PushedChanges, SharedCursor, SharedUpdates} from "../source/shared_text.ts"
import {type Decoder, list, number, object, oneOf, optional, string} from "../state/decode.ts"

/// Requests of both sides.
export type SharingRequest =
  | ({readonly op: "push"} & PushedChanges)
  | ({readonly op: "cursor"} & SharedCursor)
  | {readonly op: "end-sharing"}

/// Answers to both sides while they edit.
export type SharingMessage =
  | ({readonly op: "updates"} & SharedUpdates)
  | ({readonly op: "cursor"} & SharedCursor)

/// Answers to both sides that begin and end it. `project` and `text` are for the board only.
export type SharingBounds =
  | {readonly op: "shared"; readonly project: string | null; readonly text: string | null}
  | {readonly op: "sharing-over"; readonly why: "declined" | "ended"}

export const sharingOps = ["updates", "cursor", "shared", "sharing-over"] as const

/// CodeMirror reads them where they are applied.
const changes: Decoder<unknown> = value => value
const update = object<SharedUpdates["updates"][number]>(get => ({
  by: get("by", oneOf("teacher", "pupil")),
  changes: get("changes", changes),
}))

export const sharingMessage: Decoder<SharingMessage | SharingBounds> = (value, path) => {
  const op = object(get => get("op", oneOf(...sharingOps)))(value, path)
  return object<SharingMessage | SharingBounds>(get => {
    switch (op) {
      case "updates":
        return {op, version: get("version", number), updates: get("updates", list(update))}
      case "cursor":
        return {
          op,
          version: get("version", number),
          anchor: get("anchor", number),
          head: get("head", number),
        }
      case "shared":
        return {
          op,
          project: get("project", optional(string, null)),
          text: get("text", optional(string, null)),
        }
      case "sharing-over":
        return {op, why: get("why", oneOf("declined", "ended"))}
    }
  })(value, path)
}
