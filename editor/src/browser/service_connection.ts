/// WebSocket connection to the service. It connects, reconnects after a loss, and passes decoded messages on.

import {readServiceMessage} from "../state/messages/message_decoder.ts"
import type {ServiceMessage} from "../state/messages/messages.ts"
import type {Decoded} from "../wire/decode.ts"
import {encodeRequest} from "../wire/encode.ts"
import type {Request} from "../wire/page/page.generated.ts"

export interface ServiceConnection {
  /// Sends now, or drops the message when there is no connection: the state sends anew after `hello`.
  send(message: Request): void
  close(): void
}

export interface ConnectionListener {
  received(message: ServiceMessage): void
  lost(): void
  /// A message that does not follow the protocol; the rest of the conversation goes on.
  malformed(message: string): void
}

/// Waits between attempts to come back, in milliseconds; the last one repeats.
const waits = [250, 500, 1000, 2000, 4000]

/// `address` gives the address of the socket, before each attempt; `null` for none at the moment.
export function openConnection(
  address: () => Promise<string | null>,
  listener: ConnectionListener,
): ServiceConnection {
  let socket: WebSocket | null = null
  let attempt = 0
  let timer: ReturnType<typeof setTimeout> | undefined
  let closed = false

  const again = () => {
    timer = setTimeout(connect, waits[Math.min(attempt, waits.length - 1)])
    attempt += 1
  }
  const connect = async () => {
    const found = await address()
    if (closed) return
    if (found === null) return again()
    const own = new WebSocket(found)
    socket = own
    own.onmessage = event => {
      const read: Decoded<ServiceMessage> = readServiceMessage(String(event.data))
      if (read.kind === "mismatch") return listener.malformed(read.message)
      if (read.value.op === "hello") attempt = 0
      listener.received(read.value)
    }
    own.onclose = () => {
      if (closed || socket !== own) return
      listener.lost()
      again()
    }
  }
  void connect()

  return {
    send(message) {
      if (socket?.readyState === WebSocket.OPEN) socket.send(encodeRequest(message))
    },
    close() {
      closed = true
      clearTimeout(timer)
      socket?.close()
    },
  }
}
