/// Recording of a run: its frames in order, for seeking and for charts. Pure.

import type {Frame} from "../messages/messages.ts"

/// Frames in pieces: only the last piece is copied when a frame is added.
export interface Recording {
  readonly pieces: readonly (readonly Frame[])[]
  readonly length: number
}

export const emptyRecording: Recording = {pieces: [], length: 0}

const pieceLength = 256
/// Pieces kept: 20 minutes at 50 frames a second. Then the oldest go.
const maxPieces = 235

/// A frame at the same time as the last one takes its place: the clock stands, or there is no run, and hands move the robot.
export function record(recording: Recording, frame: Frame): Recording {
  const {pieces} = recording
  const last = pieces.at(-1)
  if (last !== undefined && last.at(-1)?.time === frame.time)
    return {...recording, pieces: [...pieces.slice(0, -1), [...last.slice(0, -1), frame]]}
  if (last !== undefined && last.length < pieceLength)
    return {pieces: [...pieces.slice(0, -1), [...last, frame]], length: recording.length + 1}
  const kept = pieces.slice(-maxPieces + 1)
  const length = kept.reduce((n, piece) => n + piece.length, 0)
  return {pieces: [...kept, [frame]], length: length + 1}
}

/// The times of the first and the last frame, in seconds; `null` when there is none.
export function spanOfTime(recording: Recording): {readonly from: number; readonly to: number} | null {
  const first = recording.pieces[0]?.[0]
  const last = recording.pieces.at(-1)?.at(-1)
  return first === undefined || last === undefined ? null : {from: first.time, to: last.time}
}

/// The last frame at or before `time`; the first when there is none before.
export function frameAt(recording: Recording, time: number): Frame | null {
  const {pieces} = recording
  let low = 0
  let high = pieces.length - 1
  while (low < high) {
    const middle = Math.ceil((low + high) / 2)
    if ((pieces[middle]?.[0]?.time ?? 0) <= time) low = middle
    else high = middle - 1
  }
  const piece = pieces[low]
  if (piece === undefined) return null
  let at = piece.findIndex(f => f.time > time)
  if (at < 0) at = piece.length
  return piece[Math.max(0, at - 1)] ?? null
}

/// The frames at or before `time`.
export function recordedUntil(recording: Recording, time: number): Recording {
  const pieces = recording.pieces
    .filter(piece => (piece[0]?.time ?? 0) <= time)
    .map(piece => ((piece.at(-1)?.time ?? 0) <= time ? piece : piece.filter(f => f.time <= time)))
  return {pieces, length: pieces.reduce((n, piece) => n + piece.length, 0)}
}

/// Every frame from `from` to `to` seconds.
export function* framesBetween(recording: Recording, from: number, to: number): Generator<Frame> {
  for (const piece of recording.pieces) {
    if ((piece.at(-1)?.time ?? 0) < from) continue
    if ((piece[0]?.time ?? 0) > to) return
    for (const frame of piece) if (frame.time >= from && frame.time <= to) yield frame
  }
}
