/// WebSocket of class mode: connects, reconnects after a loss, and passes decoded messages on.
///
/// A service that does not answer counts as lost: its computer sleeps, or its lid is closed, and the connection itself says nothing of that.

import {socketAddress} from "../../browser/service_address.ts"
import type {Decoded} from "../../wire/decode.ts"
import {encodeRequest} from "../../wire/encode.ts"

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

/// Milliseconds between two checks whether anything was received.
const checkPeriod = 3000

/// After so many checks in a row without a message the page sends a ping, and after so many the service counts as lost. Checks are counted instead of time, because a page that was
/// suspended itself makes one check afterwards.
const pingAfter = 2
const lostAfter = 4

const ping = '{"op":"ping"}'
const pong = '{"op":"pong"}'

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
    let silentChecks = 0
    const watchdog = setInterval(() => {
      silentChecks += 1
      if (silentChecks >= lostAfter) lose()
      else if (silentChecks >= pingAfter && own.readyState === WebSocket.OPEN) own.send(ping)
    }, checkPeriod)
    const lose = () => {
      clearInterval(watchdog)
      own.onopen = own.onmessage = own.onclose = null
      own.close()
      socket = null
      listener.lost()
      again()
    }
    own.onopen = () => {
      attempt = 0
      listener.opened()
    }
    own.onmessage = event => {
      silentChecks = 0
      const text = String(event.data)
      if (text === pong) return
      const message = read(text)
      if (message.kind === "ok") listener.received(message.value)
      else console.warn(`Rosy's service sent something this page does not know: ${message.message}`)
    }
    own.onclose = lose
  }
  void connect()
  return {
    send(message) {
      if (socket?.readyState !== WebSocket.OPEN) return false
      socket.send(encodeRequest(message))
      return true
    },
  }
}
