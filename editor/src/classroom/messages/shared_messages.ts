/// Messages of a program that the teacher and a pupil edit together, of the pupil's page and of the board (protocol §11.1).

import type {
  Cursor,
  EndSharing,
  Over,
  Push,
  Shared,
  Updates,
} from "../../wire/classroom/shared_messages.generated.ts"

/// Requests of both sides.
export type SharingRequest = Push | Cursor | EndSharing

/// Answers to both sides while they edit.
export type SharingMessage = Updates | Cursor

/// Answers to both sides that begin and end it.
export type SharingBounds = Shared | Over
