/// Signatures that stand apart from their equations, as in `a, b :: Int`, and names declared by text that only GHC reads.

import {namesDefinedBy} from "../model/bound_names.ts"
import {causeOf} from "../model/raw_reasons.ts"
import type {Declaration, RawDeclaration} from "../model/syntax_tree.ts"
import {localNames, signatureIn} from "./environment/declaration_scanner.ts"
import {unknown} from "./environment/environment.ts"
import type {InferenceState} from "./inference_state.ts"
import type {Scope} from "./syntax/scope.ts"

/// A signature that stands apart from its equations, as in `a, b :: Int`.
export interface WrittenSignature {
  readonly text: string
  readonly node: RawDeclaration
}

/// Takes names and signatures out of a declaration that is kept as text. Names at the top level are in the environment already.
export function readTextDeclaration(
  s: InferenceState,
  d: RawDeclaration,
  scope: Scope,
  written: Map<string, WrittenSignature>,
  top: boolean,
): void {
  if (causeOf(d.reason) === "arity") s.problems.push({kind: "clause-arity", node: d})
  const signature = signatureIn(d.text)
  for (const name of signature?.names ?? []) written.set(name, {text: signature?.type ?? "", node: d})
  if (!top) for (const [name, scheme] of localNames(d.text)) scope.set(name, scheme ?? unknown)
}

/// Words of an operator or a name.
const nameParts = /[\p{L}\p{N}_']+|[^\s\p{L}\p{N}_'()[\]{},;"]+/gu

/// Looks for signatures of names that no declaration beside them defines. Text that is not understood may define any name in it, and code
/// that is run by the compiler may define any name.
export function checkBindings(
  s: InferenceState,
  declarations: readonly Declaration[],
  written: ReadonlyMap<string, WrittenSignature>,
): void {
  if (written.size === 0) return
  const texts = declarations.flatMap(d =>
    d.kind === "raw-declaration" && signatureIn(d.text) === undefined && !/^infix[lr]?\b/.test(d.text)
      ? [d]
      : [],
  )
  if (texts.some(d => ["template", "broken", "declaration", "directive"].includes(causeOf(d.reason) ?? "")))
    return
  const named = new Set([
    ...declarations.flatMap(d => (d.kind === "raw-declaration" ? [] : namesDefinedBy(d))),
    ...texts.flatMap(d => d.text.match(nameParts) ?? []),
  ])
  for (const [name, {node}] of written)
    if (!named.has(name)) s.problems.push({kind: "no-binding", node, name})
}
