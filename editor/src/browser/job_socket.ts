/// Client of one background job of the service on a socket of its own: a test in many rooms (protocol §4.1), rehearsals of a lesson (§9.1).

import type {Decoded} from "../state/decode.ts"

export interface JobListener<Answer> {
  received(answer: Answer): void
  /// The socket closed before the last message, or said what this page does not know.
  lost(): void
}

/// How the answers of a job are read, and which of them is the last.
export interface JobProtocol<Answer> {
  read(text: string): Decoded<Answer>
  isLast(answer: Answer): boolean
}

/// Sends the request and passes on what the service answers; the function that it returns cancels the job.
export function startJob<Answer>(
  address: string,
  request: object,
  protocol: JobProtocol<Answer>,
  listener: JobListener<Answer>,
): () => void {
  const socket = new WebSocket(address)
  let over = false
  socket.onopen = () => socket.send(JSON.stringify(request))
  socket.onmessage = event => {
    if (over) return
    const read = protocol.read(String(event.data))
    if (read.kind === "mismatch") {
      console.warn(`Rosy's service sent something this page does not know: ${read.message}`)
      over = true
      socket.close()
      return listener.lost()
    }
    over = protocol.isLast(read.value)
    listener.received(read.value)
  }
  socket.onclose = () => {
    if (!over) listener.lost()
    over = true
  }
  return () => {
    over = true
    socket.close()
  }
}

/// The address of a page's jobs of a kind, as seen from `location`.
export function jobAddress(
  location: Location,
  job: "room-tests" | "lesson-rehearsals",
  session: string,
): string {
  const url = new URL(`api/${job}/${encodeURIComponent(session)}`, location.href)
  url.protocol = url.protocol === "https:" ? "wss:" : "ws:"
  url.search = ""
  url.hash = ""
  return url.href
}
