/// Random edits of blocks in foreign programs: does the text say what the blocks say, and what else did an edit change?
///
/// In: programs, a number of edits, a seed. Out: an outcome per edit, and those whose parse trees, as GHC gives them, differ in more than the
/// edited nodes. Programs that GHC's parser refuses before the edit have no tree to compare.

import {unqualified} from "../src/haskell/lexemes.ts"
import type {Reader} from "../src/reader/index.ts"
import {openView} from "../src/reader/index.ts"
import {tokens} from "../src/source/lexer.ts"
import {Dice} from "../test/generate/random.ts"
import {differenceOf, namesIn} from "../test/reader/dump.ts"
import type {EditKind, Outcome} from "../test/reader/exact_edits.ts"
import {editKinds, outcomeOf, randomEdit} from "../test/reader/exact_edits.ts"
import {parseTrees} from "../test/reader/parse_trees.ts"
import type {ForeignProgram} from "./corpus_ghc.ts"

/// Edits of one program before the next one is opened.
const perProgram = 10

/// Programs that are opened at most for each that is edited: some have no blocks that an edit could change.
const maximumOpened = 20

export interface MeasuredEdit {
  readonly program: string
  readonly kind: EditKind
  readonly outcome: Outcome
}

/// As many edits as wanted, or fewer where the programs have no place for them.
export function editsOf(
  reader: Reader,
  programs: readonly ForeignProgram[],
  count: number,
  seed: number,
): readonly MeasuredEdit[] {
  const dice = new Dice(seed)
  const made: MeasuredEdit[] = []
  for (
    let opened = 0;
    made.length < count && opened < maximumOpened * Math.ceil(count / perProgram);
    opened++
  ) {
    const program = dice.pick(programs)
    const view = openView(reader, program.text)
    for (let i = 0; i < perProgram && made.length < count; i++) {
      const kind = dice.pick(editKinds)
      const edit = randomEdit(view, dice, kind)
      if (edit === undefined) continue
      try {
        made.push({program: program.name, kind, outcome: outcomeOf(reader, view, edit)})
      } catch (error) {
        throw new Error(`${program.name} cannot be edited (${kind})`, {cause: error})
      }
    }
  }
  return made
}

export interface EditSummary {
  readonly edits: number
  /// Edits that were taken back because the text cannot say them.
  readonly refused: readonly MeasuredEdit[]
  /// Edits after which the text says something other than the blocks.
  readonly meaningChanged: readonly MeasuredEdit[]
  /// Edits after which the old blocks give another text than before.
  readonly notPutBack: readonly MeasuredEdit[]
  /// Edits that changed characters beyond the edited nodes, or printed the definition.
  readonly beyond: readonly MeasuredEdit[]
  /// Edits whose trees GHC gave both before and after; undefined without GHC.
  readonly compared: number | undefined
  /// Those of them that GHC parses no more, or whose trees differ in more than the edited nodes.
  readonly otherTrees: readonly MeasuredEdit[]
}

export async function summaryOfEdits(
  reader: Reader,
  edits: readonly MeasuredEdit[],
  hasGhc: boolean,
): Promise<EditSummary> {
  const done = edits.filter(e => !e.outcome.isRefused)
  const compared: MeasuredEdit[] = []
  const otherTrees: MeasuredEdit[] = []
  if (hasGhc) {
    const trees = await parseTrees(
      reader,
      done.flatMap(e => [e.outcome.before, e.outcome.after]),
    )
    for (const [i, edit] of done.entries()) {
      const [was, is] = [trees[2 * i], trees[2 * i + 1]]
      if (was === undefined) continue
      compared.push(edit)
      if (is === undefined || !differsInNodesOnly(edit.outcome, differenceOf(was, is))) otherTrees.push(edit)
    }
  }
  return {
    edits: edits.length,
    refused: edits.filter(e => e.outcome.isRefused),
    meaningChanged: done.filter(e => !e.outcome.agrees),
    notPutBack: edits.filter(e => !e.outcome.isPutBack),
    beyond: done.filter(({outcome: o}) => o.printed > 0 || o.elsewhere !== undefined || o.lost.length > 0),
    compared: hasGhc ? compared.length : undefined,
    otherTrees,
  }
}

/// Whether the names in which two trees differ are those of the edited nodes. The new blocks of an edit are operators and a number.
export function differsInNodesOnly(
  {before, places}: Outcome,
  [removed, added]: ReturnType<typeof differenceOf>,
): boolean {
  const start = Math.min(...places.map(p => p.start))
  const end = Math.max(...places.map(p => p.end))
  const text = before.slice(start, end)
  // GHC's tree has the module of `M.!` apart from its name, and calls each splice `splice`.
  const words = tokens(text).map(t => unqualified(text.slice(t.start, t.end).replaceAll("`", "")))
  const own = new Set([...words, "splice"])
  return [...namesIn(removed), ...namesIn(added).filter(n => !["+", "*", "&&"].includes(n))].every(n =>
    own.has(n),
  )
}

export function reportOfEdits(summary: EditSummary, isVerbose: boolean): readonly string[] {
  const row = (what: string, found: readonly MeasuredEdit[], of: number): string[] => [
    `${what}: ${found.length} of ${of}`,
    ...(isVerbose ? found.map(shown) : []),
  ]
  return [
    `edits: ${summary.edits}`,
    ...row("edits taken back, and said", summary.refused, summary.edits),
    ...row("meaning changed", summary.meaningChanged, summary.edits),
    ...row("old blocks that give another text", summary.notPutBack, summary.edits),
    ...row("edits beyond the node", summary.beyond, summary.edits),
    ...(summary.compared === undefined
      ? ["GHC is not installed: its parse trees are not compared."]
      : row("GHC's parse trees differ elsewhere", summary.otherTrees, summary.compared)),
  ]
}

function shown({program, kind, outcome: {before, after, elsewhere, lost}}: MeasuredEdit): string {
  let at = 0
  while (at < before.length && before[at] === after[at]) at++
  const from = Math.max(0, before.lastIndexOf("\n", at - 100))
  const why = [
    ...(elsewhere === undefined ? [] : [elsewhere]),
    ...lost.map(text => `${JSON.stringify(text)} is gone`),
  ]
  return `  ${program}, ${kind}: ${why.join("; ")}\n${before.slice(from, at + 160)}\n=====>\n${after.slice(from, at + 160)}\n`
}
