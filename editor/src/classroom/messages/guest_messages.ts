/// Messages between the teacher's board and the page with a pupil's program inside of it, which the board frames. Both are pages of the same service.

import type {BlockComment, PlaceInProgram} from "../../program/block_comments.ts"
import type {SharingMessage, SharingRequest} from "./shared_messages.ts"

/// A place that the teacher chose in the program: its line, and its text to be quoted.
export interface ChosenPlace {
  readonly place: PlaceInProgram
  readonly line: number
  readonly quote: string
}

/// The line of a comment in the program as it is shown; `null` when its place is gone.
export interface CommentLine {
  readonly comment: number
  readonly line: number | null
}

export type GuestMessage =
  /// The program is open.
  | {readonly kind: "ready"}
  | {readonly kind: "chosen"; readonly chosen: ChosenPlace | null}
  | {readonly kind: "located"; readonly lines: readonly CommentLine[]}
  /// Whether the copy is as the pupil has saved it; not after a change by the teacher.
  | {readonly kind: "follows"; readonly follows: boolean}
  /// While the program is edited together: what the service has to know, and the line of the pupil's cursor.
  | {readonly kind: "sharing"; readonly message: SharingRequest}
  | {readonly kind: "line"; readonly line: number | null}

export type HostMessage =
  | {readonly kind: "comments"; readonly comments: readonly BlockComment[]}
  /// The pupil, of this name, allows to edit the program together, as it is now.
  | {readonly kind: "share"; readonly nickname: string; readonly project: string; readonly text: string}
  | {readonly kind: "shared"; readonly message: SharingMessage}
  | {readonly kind: "end-sharing"}
  /// The pupil has saved this project file.
  | {readonly kind: "newer"; readonly project: string}

/// Sends to a window if it shows a page of this service; the browser drops the message otherwise.
export function post(to: Window, message: GuestMessage | HostMessage): void {
  to.postMessage({rosy: message}, window.location.origin)
}

/// Calls `heard` with the messages that come from a window, if it shows a page of this service. The result stops that.
export function listen<Message>(from: () => Window | null, heard: (message: Message) => void): () => void {
  const receive = (event: MessageEvent<unknown>) => {
    if (event.origin !== window.location.origin || event.source !== from()) return
    const {data} = event
    // A page of the same service, loaded with this one, sends what the types say.
    if (typeof data === "object" && data !== null && "rosy" in data) heard(data.rosy as Message)
  }
  window.addEventListener("message", receive)
  return () => window.removeEventListener("message", receive)
}
