/// WebSocket of class mode: connects, reconnects after a loss, and passes decoded messages on.

import {socketAddress} from "../browser/service_address.ts"
import type {Decoded} from "../state/decode.ts"

export interface ClassSocket<Request> {
  /// Sends now; false when there is no connection.
  send(message: Request): boolean
}

export interface ClassSocketListener<Answer> {
  opened(): void
  received(message: Answer): void
  lost(): void
}

/// Waits between attempts to connect again, in milliseconds; the last one repeats.
const waits = [250, 500, 1000, 2000, 4000]

export function openClassSocket<Request, Answer>(
  path: string,
  read: (text: string) => Decoded<Answer>,
  listener: ClassSocketListener<Answer>,
): ClassSocket<Request> {
  let socket: WebSocket | null = null
  let attempt = 0
  const again = () => {
    setTimeout(connect, waits[Math.min(attempt, waits.length - 1)])
    attempt += 1
  }
  const connect = async () => {
    const address = await socketAddress(path, window.location)
    if (address === null) return again()
    const own = new WebSocket(address)
    socket = own
    own.onopen = () => {
      attempt = 0
      listener.opened()
    }
    own.onmessage = event => {
      const message = read(String(event.data))
      if (message.kind === "ok") listener.received(message.value)
      else console.warn(`Rosy's service sent something this page does not know: ${message.message}`)
    }
    own.onclose = () => {
      listener.lost()
      again()
    }
  }
  void connect()
  return {
    send(message) {
      if (socket?.readyState !== WebSocket.OPEN) return false
      socket.send(JSON.stringify(message))
      return true
    },
  }
}
