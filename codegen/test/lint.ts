/// What hlint and `-Wall` say about the Haskell of generated programs, apart from what they say about what a program does.
///
/// The printer writes what the blocks say, step by step, so that text and blocks stay the same program. A random program says much
/// that no author would: it asks whether `True`, names what it never uses, and forgets cases. That is its author's to change.

import {mkdtempSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {inferWorkspace} from "../src/workspace/inference/workspace_inference.ts"
import {generateProgram, sizeOf} from "./generate/program.ts"
import type {Candidate} from "./ghc.ts"
import {compileAll} from "./ghc.ts"
import {breathe, run} from "./process.ts"
import {batch, candidate} from "./soundness.ts"

/// hlint's rules that ask for another program, by what they find fault with. Each is its author's to follow: other blocks, not the same
/// ones in better words. Every other hint fails, also an unforeseen one.
const aboutContent: {readonly [fault: string]: RegExp} = {
  "what is known is asked or computed":
    /^(?:Evaluate|Short-circuited .*|(?:Take|Drop) on a .*|Using \w+ on tuple|Length always .*|Redundant (?:if|multi-way if|case|True guards|as-pattern|==|\/=|not))$/,
  "a function is spelled out that has a name, or a name is missing that it could do without":
    /^(?:Use (?:const|id|\(,+\)|tuple-section|lambda-case|section|\.)|Eta reduce|Collapse lambdas|Avoid lambda.*|Redundant (?:lambda|section))$/,
  "a call does nothing":
    /^Redundant (?:\$|<\$>|id|flip|curry|uncurry|const|return|pure|negate|fmap|map|concat|reverse|list comprehension|either|maybe|void|when|fst|snd|seq|show|from\w+|to\w+|real\w+|take|drop|filter)$/,
  "the library has a shorter word for several blocks":
    /^Use (?:[a-z]\w*_?|[!$&*+./:<=>^|-]+|list (?:literal|comprehension)(?: pattern)?|record patterns|newtype instead of data|Just|Left|Right)$/,
  "blocks stand in another order than they could":
    /^(?:Move (?:guards forward|brackets to avoid \$|\w+ inside .*)|(?:Monad|Functor|Alternative) law, .*|Fuse .*|Hoist not|Reduce duplication|Replace case with \w+)$/,
}
/// These rules about names and literals begin like those above.
const aboutWriting = /^Use (?:camelCase|underscore|string|explicit|module|hierarchical)/

function isContent(hint: string): boolean {
  return !aboutWriting.test(hint) && Object.values(aboutContent).some(rule => rule.test(hint))
}

/// Warnings about what a program leaves out or never uses, and about numbers that nothing decides.
const contentWarnings =
  `unused-matches unused-local-binds unused-top-binds unused-pattern-binds overlapping-patterns incomplete-patterns incomplete-uni-patterns
  incomplete-record-updates type-defaults unused-do-bind missing-fields empty-enumerations`.split(/\s+/)

export interface Lint {
  readonly programs: number
  readonly hints: readonly string[]
  readonly warnings: readonly string[]
  /// How often each hint about a program's content came up.
  readonly content: ReadonlyMap<string, number>
}

export async function lint(database: string, from: number, count: number): Promise<Lint> {
  const hints: string[] = []
  const warnings: string[] = []
  const content = new Map<string, number>()
  let programs = 0
  for (let start = from; start < from + count; start += batch) {
    const candidates: Candidate[] = []
    // A recursion whose type must not be written out has no signature, so that GHC takes it; nor has what is of a class that a program
    // cannot name (`Random`, `Alternative`).
    const unsigned = new Set<string>()
    for (let seed = start; seed < Math.min(start + batch, from + count); seed++) {
      if (seed % 20 === 0) await breathe()
      const {workspace, whole} = generateProgram(seed, sizeOf(seed))
      if (!whole) continue
      candidates.push(candidate(`P${seed}`, workspace))
      const {inference} = inferWorkspace(workspace)
      const nameless = [...inference.schemes.values()].some(s =>
        s.constraints.some(c => inference.env.hidden.has(c.name)),
      )
      if (inference.unsignable.size > 0 || nameless) unsigned.add(`P${seed}`)
    }
    programs += candidates.length
    hints.push(...(await hintsOn(candidates, content)))
    const options = [
      "-Wall",
      "-Werror",
      ..."orphans simplifiable-class-constraints dodgy-imports unused-imports"
        .split(" ")
        .map(w => `-Wno-${w}`),
      ...contentWarnings.map(w => `-Wno-${w}`),
    ]
    for (const [name, said] of await compileAll(database, candidates, options)) {
      const others = [...said.matchAll(/\[-W([\w-]+)/g)].some(([, w]) => w !== "missing-signatures")
      if (others || !unsigned.has(name)) warnings.push(`${name}\n${said}`)
    }
  }
  return {programs, hints, warnings, content}
}

interface Hint {
  readonly hint: string
  readonly file: string
  readonly from: string
  readonly to: string | null
}

async function hintsOn(candidates: readonly Candidate[], content: Map<string, number>): Promise<string[]> {
  const folder = mkdtempSync(join(tmpdir(), "rosy-lint-"))
  try {
    for (const c of candidates) writeFileSync(join(folder, `${c.name}.hs`), c.text)
    const {stdout} = await run("hlint", ["--json", folder])
    return (JSON.parse(stdout) as Hint[]).flatMap(h => {
      if (!isContent(h.hint) && !keptBrackets(h)) return [`${h.file}: ${h.hint}: ${h.from} ==> ${h.to}`]
      content.set(h.hint, (content.get(h.hint) ?? 0) + 1)
      return []
    })
  } finally {
    rmSync(folder, {recursive: true, force: true})
  }
}

/// Brackets that say where a condition ends when a block of lines is in it, those of `(C) {x = 1}`, which means something else without,
/// and those of a section that is called: `(subtract 1) x` are other blocks than `subtract 1 x`.
function keptBrackets({hint, from}: Hint): boolean {
  return (
    /bracket/i.test(hint) &&
    (/\b(?:case|let|do)\b|\bif \|/.test(from) || /^\((?:[\p{Lu}]\w*\)$|subtract )/u.test(from))
  )
}
