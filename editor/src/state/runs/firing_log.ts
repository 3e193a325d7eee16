/// Log of the firings of a run, for the latest firing of each function at any moment. Pure.

import type {FiringShown} from "../../wire/page/explanations.generated.ts"

/// Firings in pieces: only the last piece is copied when firings are added, and a look-up reads one piece.
interface Piece {
  /// The latest firing of each function before this piece.
  readonly before: ReadonlyMap<string, FiringShown>
  /// In the order of time.
  readonly firings: readonly FiringShown[]
}

export interface FiringLog {
  readonly pieces: readonly Piece[]
  /// Whether it begins with the run, so that a function without a firing in it has not run.
  readonly isWhole: boolean
}

export const emptyLog: FiringLog = {pieces: [], isWhole: true}

const pieceLength = 256
/// Pieces kept: 20,000 firings, as many as the service keeps. Then the oldest go.
const maxPieces = 79

export function addFirings(log: FiringLog, added: readonly FiringShown[]): FiringLog {
  if (added.length === 0) return log
  const last = log.pieces.at(-1)
  if (last !== undefined && last.firings.length < pieceLength) {
    const piece = {...last, firings: [...last.firings, ...added]}
    return {...log, pieces: [...log.pieces.slice(0, -1), piece]}
  }
  const before =
    last === undefined ? new Map<string, FiringShown>() : withFirings(last, Number.POSITIVE_INFINITY)
  const pieces = [...log.pieces.slice(-maxPieces + 1), {before, firings: added}]
  return {isWhole: log.isWhole && pieces.length > log.pieces.length, pieces}
}

/// The latest firing of each function at or before `time`, s.
export function latestFirings({pieces}: FiringLog, time: number): ReadonlyMap<string, FiringShown> {
  const piece = pieces.findLast(({firings}) => (firings[0]?.time ?? 0) <= time)
  return piece === undefined ? new Map() : withFirings(piece, time)
}

/// The firings at or before `time`, s.
export function firingsUntil({pieces, isWhole}: FiringLog, time: number): FiringLog {
  const kept = pieces.filter(({firings}) => (firings[0]?.time ?? 0) <= time)
  return {
    isWhole,
    pieces: kept.map(piece => ({...piece, firings: piece.firings.filter(f => f.time <= time)})),
  }
}

function withFirings({before, firings}: Piece, time: number): ReadonlyMap<string, FiringShown> {
  const latest = new Map(before)
  for (const firing of firings) {
    if (firing.time > time) break
    latest.set(firing.function, firing)
  }
  return latest
}
