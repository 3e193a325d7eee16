/// Random connections in foreign programs that the drop checker accepts: does GHC accept the program then?
///
/// In: programs, a number of connections, a seed. Out: the connections that were made, and those after which GHC refuses the program. Only
/// programs count that GHC accepts before and in which inference finds no problem. What is put into a socket is a literal, a name in scope,
/// or a copy of another expression of the program; a connection that leaves an empty socket or a problem is none.

import {blockView} from "../src/blocks/block_registry.ts"
import {checker, namesInScope, plug} from "../src/index.ts"
import type {Reader} from "../src/reader/index.ts"
import {openView, syncBlocks, workspaceOf} from "../src/reader/index.ts"
import type {Place, SavedBlock, SavedWorkspace} from "../src/serialized_blocks.ts"
import {library} from "../src/types/environment/standard_library.ts"
import {InferenceSession} from "../src/workspace/inference/inference_session.ts"
import {everyBlock, everyBlockIn, problemsOf} from "../src/workspace/inference/workspace_inference.ts"
import {Dice} from "../test/generate/random.ts"
import type {ForeignProgram} from "./corpus_ghc.ts"
import {verdictsOfGhc} from "./corpus_ghc.ts"

/// Connections that are made in one program, and attempts at them.
const perProgram = 4
const attempts = 30

/// Programs that GHC is asked about at once.
const perBatch = 150

/// Larger programs would take most of the time.
const maximumLength = 20_000

export interface Connection {
  readonly program: string
  readonly before: string
  readonly after: string
  /// What the page says before the drop where only GHC knows; undefined where it promises that the program compiles.
  readonly doubt: string | undefined
  /// What GHC says of the text after; empty where it accepts it.
  readonly complaint: string
}

/// As many accepted connections as wanted, or fewer where the programs have no more; undefined without GHC.
export async function connectionsOf(
  reader: Reader,
  programs: readonly ForeignProgram[],
  count: number,
  seed: number,
): Promise<readonly Connection[] | undefined> {
  const dice = new Dice(seed)
  const order = shuffled(
    programs.filter(p => p.text.length <= maximumLength),
    dice,
  )
  const found: Connection[] = []
  for (let at = 0; at < order.length && found.length < count; at += perBatch) {
    const batch = order.slice(at, at + perBatch)
    const verdicts = await verdictsOfGhc(batch)
    if (verdicts === undefined) return undefined
    const made: Omit<Connection, "complaint">[] = []
    for (const program of batch)
      if (verdicts.get(program.name)?.complaint === "" && found.length + made.length < count)
        for (const connected of connectedIn(reader, program.text, dice))
          made.push({program: program.name, before: program.text, ...connected})
    const asked = made.map(({after}, i) => ({name: `${i}/Main.hs`, text: after}))
    const complaints = await verdictsOfGhc(asked)
    for (const [i, connection] of made.entries()) {
      const verdict = complaints?.get(`${i}/Main.hs`)
      if (verdict !== undefined && !isAboutRosy(verdict.complaint)) found.push({...connection, ...verdict})
    }
  }
  return found.slice(0, count)
}

/// Whether GHC misses a name that the page gives to each program, and this measurement does not.
function isAboutRosy(complaint: string): boolean {
  const [, name = ""] = /not in scope: ‘?([\w']+)/.exec(complaint) ?? []
  return library.values.has(name) && !library.prelude.has(name)
}

interface Connected {
  readonly after: string
  readonly doubt: string | undefined
}

/// A program after one accepted connection each.
function connectedIn(reader: Reader, text: string, dice: Dice): readonly Connected[] {
  const view = openView(reader, text)
  const workspace = workspaceOf(view)
  const session = new InferenceSession()
  const hasError = (w: SavedWorkspace) =>
    problemsOf(session.inferWorkspace(w)).some(p => p.severity === "error" && p.kind !== "no-main")
  if (hasError(workspace)) return []
  const sockets = [...everyBlock(workspace)].flatMap(socketsOf)
  if (sockets.length === 0) return []
  const expressions = sockets.map(s => s.inside)
  const found: Connected[] = []
  for (let i = 0; i < attempts && found.length < perProgram; i++) {
    const {place, inside} = dice.pick(sockets)
    const block = proposal(workspace, place, expressions, dice, session)
    if (block === undefined || sameContent(block, inside)) continue
    const verdict = checker(workspace, session).fits(place, block)
    if (!verdict.fits) continue
    const connected = plug(workspace, place, block)
    if (hasError(connected)) continue
    const after = syncBlocks(reader, view, connected)
    if (after.refused === undefined && after.text !== text)
      found.push({after: after.text, doubt: verdict.doubt})
  }
  return found
}

interface Socket {
  readonly place: Place
  readonly inside: SavedBlock
}

/// The filled sockets for expressions.
function socketsOf(block: SavedBlock): Socket[] {
  const {id} = block
  if (id === undefined) return []
  return Object.entries(block.inputs ?? {}).flatMap(([input, {block: inside}]) =>
    inside !== undefined && blockView(inside.type)?.meaning.as === "expression"
      ? [{place: {block: id, input}, inside}]
      : [],
  )
}

const literals: readonly SavedBlock[] = [
  {type: "number", extraState: {value: "7"}},
  {type: "number", extraState: {value: "0.5"}},
  {type: "text", extraState: {value: "x"}},
  {type: "construct", extraState: {con: "True", args: 0}},
]

function proposal(
  workspace: SavedWorkspace,
  place: Place,
  expressions: readonly SavedBlock[],
  dice: Dice,
  session: InferenceSession,
): SavedBlock | undefined {
  const numbered = (block: SavedBlock) => {
    const {next: _, ...copy} = structuredClone(block)
    let n = 0
    for (const b of everyBlockIn(copy)) b.id = `connected${n++}`
    return copy
  }
  switch (dice.below(3)) {
    case 0:
      return numbered(dice.pick(literals))
    case 1:
      return numbered(dice.pick(expressions))
    default: {
      const fitting = namesInScope(workspace, place, session).filter(
        n => n.fits && n.block.inputs === undefined,
      )
      return fitting.length === 0 ? undefined : numbered(dice.pick(fitting).block)
    }
  }
}

function sameContent(a: SavedBlock, b: SavedBlock): boolean {
  const content = (block: SavedBlock) =>
    JSON.stringify(block, (key, value: unknown) =>
      ["id", "x", "y", "next"].includes(key) ? undefined : value,
    )
  return content(a) === content(b)
}

function shuffled<T>(items: readonly T[], dice: Dice): readonly T[] {
  const left = [...items]
  for (let i = left.length - 1; i > 0; i--) {
    const j = dice.below(i + 1)
    ;[left[i], left[j]] = [left[j] as T, left[i] as T]
  }
  return left
}

export function reportOfConnections(
  connections: readonly Connection[],
  isVerbose: boolean,
): readonly string[] {
  const rows = (what: string, of: readonly Connection[]): string[] => {
    const refused = of.filter(c => c.complaint !== "")
    return [`${what}: ${refused.length} of ${of.length}`, ...(isVerbose ? refused.map(shown) : [])]
  }
  return [
    `connections that the blocks accept: ${connections.length}`,
    ...rows(
      "refused by GHC, and the blocks promised otherwise",
      connections.filter(c => c.doubt === undefined),
    ),
    ...rows(
      "refused by GHC where the blocks say that only GHC knows",
      connections.filter(c => c.doubt !== undefined),
    ),
  ]
}

function shown({program, before, after, doubt, complaint}: Connection): string {
  let at = 0
  while (at < before.length && before[at] === after[at]) at++
  const from = Math.max(0, before.lastIndexOf("\n", at - 100))
  return `  ${program}: ${doubt ?? "no doubt"}\n${before.slice(from, at + 120)}\n=====>\n${after.slice(from, at + 120)}\n${complaint.trim()}\n`
}
