/// Haskell of a workspace: read, infer, print.

import type {BlockProblem, PrintedProgram, Span} from "../../api.ts"
import {readWorkspace} from "../../blocks/block_reader.ts"
import type {Fixity} from "../../haskell/fixity.ts"
import {importedFixities} from "../../haskell/import_fixities.ts"
import {printExprAlone, printPatternAlone, printProgram} from "../../haskell/printer.ts"
import {namesDefinedBy} from "../../model/bound_names.ts"
import {everyNode} from "../../model/child_nodes.ts"
import {hasUnknowns} from "../../model/holes.ts"
import type {Declaration, Program} from "../../model/syntax_tree.ts"
import type {BlockId, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {derivable} from "../../types/environment/declared_types.ts"
import type {Environment} from "../../types/environment/environment.ts"
import {metasIn, showScheme} from "../../types/syntax/type.ts"
import type {InferredWorkspace} from "./workspace_inference.ts"
import {inferWorkspace, problemsOf} from "./workspace_inference.ts"

export interface Haskell extends PrintedProgram {
  readonly problems: readonly BlockProblem[]
  /// Per top-level declaration: its name, block and place in the text.
  readonly declarations: readonly (Span & {readonly block: BlockId | undefined})[]
}

export function toHaskell(workspace: SavedWorkspace): Haskell {
  const solved = inferWorkspace(workspace)
  const program = withSignatures(solved.read.program, solved)
  const printed = printProgram(program, importedIn(program, solved.read.header ?? ""))
  const declarations = program.declarations.flatMap(d => {
    const span = printed.nodes.get(d)
    return span === undefined ? [] : [{...span, block: d.from?.block}]
  })
  return {text: printed.text, spans: printed.spans, problems: problemsOf(solved), declarations}
}

/// Fixities of the operators that a program imports and does not define.
function importedIn(program: Program, header: string): ReadonlyMap<string, Fixity> {
  if (header === "") return new Map()
  const own = new Set(program.declarations.flatMap(namesDefinedBy))
  const used = program.declarations.flatMap(d =>
    [...everyNode(d)].flatMap(n => ("op" in n && !own.has(n.op) ? [n.op] : [])),
  )
  return importedFixities(header, used)
}

/// A block as Haskell: a definition, steps below each other, or something that stands inside of one.
export interface PieceOfCode {
  readonly text: string
  readonly as: "definition" | "steps" | "part"
}

/// A block, with all it carries, as a piece of Haskell to put into a text. A definition stands at the margin; anything else begins where it is put.
export function codeOf(block: SavedBlock): PieceOfCode | undefined {
  const {program, loose} = readWorkspace({blocks: {languageVersion: 0, blocks: [block]}})
  const [one] = loose
  if (program.declarations.length > 0) return {text: printProgram(program).text.trimEnd(), as: "definition"}
  if (one === undefined) return undefined
  switch (one.kind) {
    case "expression":
      return {text: printExprAlone(one.expr), as: "part"}
    case "pattern":
      return {text: printPatternAlone(one.pattern), as: "part"}
    default: {
      // A block of steps is printed with its `do`; without it, its steps stand below each other.
      const lines = printExprAlone({kind: "do", statements: one.steps}).replace(/^do\s/, "").split("\n")
      const indent = Math.min(...lines.map(l => l.search(/\S/)).filter(n => n >= 0))
      return {
        text: lines.map(l => l.slice(Math.max(0, Math.min(indent, l.search(/\S/))))).join("\n"),
        as: "steps",
      }
    }
  }
}

/// The program with the inferred type as signature where the learner wrote none. A definition with an empty socket whose
/// type is still open gets none: it would promise what the socket may break.
export function withSignatures(program: Program, {inference}: Pick<InferredWorkspace, "inference">): Program {
  return {
    ...program,
    declarations: program.declarations.map((d): Declaration => {
      if (d.kind === "data") return withDeriving(d, inference.env)
      if (d.kind !== "function" || d.signature !== undefined || inference.unsignable.has(d)) return d
      const scheme = inference.schemes.get(d)
      // What is open still may be decided by something that only GHC sees.
      if (
        scheme === undefined ||
        metasIn(scheme.type).size > 0 ||
        (scheme.variables.length > 0 && hasUnknowns(d))
      )
        return d
      const text = showScheme(scheme)
      const named = text.match(/\p{Lu}[\p{L}\p{N}_']*/gu) ?? []
      if (text.includes("?") || named.some(n => inference.env.hidden.has(n))) return d
      return {...d, signature: {kind: "type", text, from: d.from}}
    }),
  }
}

/// The types of a program that need more classes than they derive, with all that they derive then.
export function derivingNeeds({read, inference}: Pick<InferredWorkspace, "read" | "inference">): readonly {
  readonly type: Declaration & {kind: "data"}
  readonly classes: readonly string[]
}[] {
  return read.program.declarations.flatMap(type => {
    if (type.kind !== "data") return []
    const {deriving} = withDeriving(type, inference.env)
    return deriving === type.deriving ? [] : [{type, classes: deriving}]
  })
}

/// What the program does with a type of its own decides what the type derives: comparing needs `Eq`, showing `Show`.
function withDeriving(
  d: Declaration & {kind: "data"},
  {needs, written}: Pick<Environment, "needs" | "written">,
): Declaration & {kind: "data"} {
  const wanted = derivable.filter(c => needs.has(`${c} ${d.name}`) && !d.deriving.includes(c))
  // `Ord` builds on `Eq`, which the program may have by hand.
  const hasEq = [...wanted, ...d.deriving].includes("Eq") || written?.has(`Eq ${d.name}`) === true
  const all = wanted.includes("Ord") && !hasEq ? ["Eq", ...wanted] : wanted
  return all.length === 0 ? d : {...d, deriving: [...d.deriving, ...all]}
}

/// The innermost block whose text holds an offset.
export function blockAt(printed: PrintedProgram, offset: number): BlockId | undefined {
  let best: PrintedProgram["spans"][number] | undefined
  for (const span of printed.spans)
    if (span.block !== undefined && span.start <= offset && offset <= span.end)
      if (best === undefined || span.end - span.start <= best.end - best.start) best = span
  return best?.block
}

/// Where a block's text is; for a block with several pieces the one that holds the others.
export function spanOf(printed: PrintedProgram, block: BlockId): Span | undefined {
  let best: Span | undefined
  for (const span of printed.spans)
    if (span.block === block && span.input === undefined)
      if (best === undefined || span.end - span.start > best.end - best.start)
        best = {start: span.start, end: span.end}
  return best
}

/// Where an empty socket's `_` is.
export function spanOfSocket(printed: PrintedProgram, block: BlockId, input: string): Span | undefined {
  const span = printed.spans.find(s => s.block === block && s.input === input)
  return span === undefined ? undefined : {start: span.start, end: span.end}
}
