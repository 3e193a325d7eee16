/// Fixities of operators that a file imports, as far as its modules are known. (`npm run fixities -w codegen` reads those of GHC's packages.)

import type {Import} from "../source/imports.ts"
import {importsIn} from "../source/imports.ts"
import type {Fixity} from "./fixity.ts"
import {fixitiesIn, fixityOf, unresolved} from "./fixity.ts"
import {unqualified} from "./lexemes.ts"
import {moduleFixities} from "./module_fixities.generated.ts"

/// By module; a module that is absent is not known.
const known = new Map(
  moduleFixities.flatMap(({modules, fixities}) => {
    const own = fixitiesIn(fixities.replaceAll(", ", "\n"))
    return modules.split(" ").map(name => [name, own] as const)
  }),
)

/// Operators of a text, in signs or in backquotes; signs in comments and texts among them.
export function operatorsIn(text: string): Set<string> {
  const found =
    text.match(/`[^`\s]+`|(?:\p{Lu}[\p{L}\p{N}_']*\.)*(?:(?!`)[!#$%&*+./<=>?@\\^|~:\p{S}-])+/gu) ?? []
  return new Set(found.map(op => op.replaceAll("`", "")))
}

/// Fixities of imported operators that differ from those that a name has anyway. One that may come from a module that is not known is unresolved: it
/// compares with no other.
export function importedFixities(header: string, operators: Iterable<string>): Map<string, Fixity> {
  const found = new Map<string, Fixity>()
  const imports = importsIn(header)
  if (imports.length === 0) return found
  const isAsked = imports.some(i => i.module === "Prelude")
  const prelude: Import = {
    module: "Prelude",
    qualified: false,
    as: "Prelude",
    only: undefined,
    hiding: new Set(),
  }
  const all = isAsked ? imports : [...imports, prelude]
  for (const op of operators) {
    const fixity = importedFixity(op, all)
    const usual = fixityOf(op)
    if (fixity === undefined) continue
    if (fixity.precedence !== usual.precedence || fixity.associates !== usual.associates)
      found.set(op, fixity)
  }
  return found
}

function importedFixity(op: string, imports: readonly Import[]): Fixity | undefined {
  // It belongs to the language.
  if (op === ":") return undefined
  const name = unqualified(op)
  const qualifier = op.slice(0, op.length - name.length).replace(/\.$/, "")
  const sources = imports.filter(
    i => (qualifier === "" ? !i.qualified : i.as === qualifier) && mayBring(i, name),
  )
  const fixities = sources.flatMap(i => known.get(i.module)?.get(name) ?? [])
  const different = new Set(fixities.map(f => `${f.associates} ${f.precedence}`))
  if (different.size > 1) return unresolved
  const isKnown = (i: Import) => known.has(i.module) || /^Rosy(?:\.|$)/.test(i.module)
  return fixities[0] ?? (sources.every(isKnown) ? undefined : unresolved)
}

function mayBring({only, hiding}: Import, name: string): boolean {
  return !hiding.has(name) && (only === undefined || only.has(name) || only.has(".."))
}
