/// What the renderer must know about a connection and cannot ask Blockly: its family, which decides outline and
/// colour, and for a socket the word that stands in it while it is empty.
///
/// Filled when a block is built and again after type inference; read while drawing.

import type {Family} from "@rosy/codegen"
import type * as Blockly from "blockly/core"

export interface Look {
  readonly family: Family
  /// One or two words, for a socket.
  readonly hint: string
  /// A socket that must be filled before the program can run.
  readonly hole: boolean
}

const looks = new WeakMap<Blockly.Connection, Look>()

const plain: Look = {family: "own", hint: "", hole: false}

export function lookOf(connection: Blockly.Connection): Look {
  return looks.get(connection) ?? plain
}

/// Whether anything changed, so that only those blocks are drawn again whose look did.
export function setLook(connection: Blockly.Connection, look: Look): boolean {
  const old = looks.get(connection)
  if (old !== undefined && old.family === look.family && old.hint === look.hint && old.hole === look.hole)
    return false
  looks.set(connection, look)
  return true
}
