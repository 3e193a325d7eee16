/// One test in many rooms on a socket of its own (protocol §4.1).

import {type Answer, readAnswer} from "./room_test.ts"

export interface TestListener {
  received(answer: Answer): void
  /// The socket closed before the last message, or said what this page does not know.
  lost(): void
}

/// Sends the request and passes on what the service answers; the function that it returns cancels the test.
export function startTest(address: string, request: object, listener: TestListener): () => void {
  const socket = new WebSocket(address)
  let over = false
  socket.onopen = () => socket.send(JSON.stringify(request))
  socket.onmessage = event => {
    if (over) return
    const read = readAnswer(String(event.data))
    if (read.kind === "mismatch") {
      console.warn(`Rosy's service sent something this page does not know: ${read.message}`)
      over = true
      socket.close()
      return listener.lost()
    }
    over = read.value.op === "report" || read.value.op === "failed"
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

/// The address of a page's tests, as seen from `location`.
export function testAddress(location: Location, session: string): string {
  const url = new URL(`api/room-tests/${encodeURIComponent(session)}`, location.href)
  url.protocol = url.protocol === "https:" ? "wss:" : "ws:"
  url.search = ""
  url.hash = ""
  return url.href
}
