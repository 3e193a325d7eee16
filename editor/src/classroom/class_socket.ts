/// WebSocket of class mode: connects, reconnects after a loss, and passes decoded messages on.

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
  const address = new URL(path, window.location.href)
  address.protocol = address.protocol === "https:" ? "wss:" : "ws:"
  address.search = ""
  address.hash = ""
  const connect = () => {
    const own = new WebSocket(address.href)
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
      setTimeout(connect, waits[Math.min(attempt, waits.length - 1)])
      attempt += 1
    }
  }
  connect()
  return {
    send(message) {
      if (socket?.readyState !== WebSocket.OPEN) return false
      socket.send(JSON.stringify(message))
      return true
    },
  }
}
