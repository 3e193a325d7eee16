/// Client of one background job of the service on a socket of its own: a test in many rooms (protocol §4.1), rehearsals of a lesson (§9.1).

import {socketAddress} from "../browser/service_address.ts"
import type {Decoded} from "../wire/decode.ts"
import {encodeRequest} from "../wire/encode.ts"

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

/// Sends the request to a path below `api/` and passes on what the service answers; the function that it returns cancels the job.
export function startJob<Answer>(
  path: string,
  request: object,
  protocol: JobProtocol<Answer>,
  listener: JobListener<Answer>,
): () => void {
  let socket: WebSocket | null = null
  let over = false
  const connect = async () => {
    const address = await socketAddress(`api/${path}`, window.location)
    if (over) return
    if (address === null) return listener.lost()
    const own = new WebSocket(address)
    socket = own
    own.onopen = () => own.send(encodeRequest(request))
    own.onmessage = event => {
      if (over) return
      const read = protocol.read(String(event.data))
      if (read.kind === "mismatch") {
        console.warn(`Rosy's service sent something this page does not know: ${read.message}`)
        over = true
        own.close()
        return listener.lost()
      }
      over = protocol.isLast(read.value)
      listener.received(read.value)
    }
    own.onclose = () => {
      if (!over) listener.lost()
      over = true
    }
  }
  void connect()
  return () => {
    over = true
    socket?.close()
  }
}
