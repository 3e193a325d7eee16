/// Mutable state of one type inference: unknown types, collected problems, wanted class constraints and results.
///
/// Every rule of inference is a function over this state. The three function fields connect rules that need each other across files
/// (bindings contain expressions, expressions contain bindings) and are set once, by `createInference`.

import type {Declaration, Expr, Node, Origin} from "../model/syntax_tree.ts"
import type {Environment} from "./environment.ts"
import type {InferredGroup} from "./inference_cache.ts"
import type {Scope} from "./scope.ts"
import type {Meta, Scheme, Type} from "./type.ts"
import {TypeTooLarge} from "./type.ts"
import type {TypeProblem, Wanted} from "./type_problems.ts"

export interface InferenceState {
  readonly env: Environment
  /// Types of nodes that belong to no group of top-level definitions, or to the group that is being inferred.
  found: Map<Node, Type>
  schemes: Map<Declaration, Scheme>
  readonly problems: TypeProblem[]
  /// Types that a hole, an error or text for GHC leaves open; they cause no further problem.
  readonly holes: Type[]
  /// Those of `holes` that are empty sockets.
  readonly sockets: Set<Type>
  wanted: Wanted[]
  /// Constraints of loose blocks that no binding has taken; they show what kind of value is meant.
  readonly pending: Wanted[]
  /// Depth of bindings. A meta variable of a deeper level than a binding belongs to that binding (generalisation by levels).
  level: number
  /// Number of the next meta variable.
  count: number
  /// Whether undefined names are accepted, as in loose blocks.
  lenient: boolean
  /// Number of patterns of constructors whose type only GHC knows; these may refine a type (GADTs).
  opaque: number
  /// Types of undefined names while `lenient`.
  strays: Map<string, Type>
  /// Type variables in scope of signatures (ScopedTypeVariables).
  scoped: ReadonlyMap<string, Type>
  /// Provisional schemes of top-level names.
  readonly placeholders: Set<Scheme>
  /// Definitions whose inferred type must not be printed as a signature.
  readonly unsignable: Set<Declaration>
  /// Texts of types that are too large when their synonyms are written out.
  readonly largeTypes: Set<string>
  /// Results for each group of top-level definitions; a cached group is the identical object.
  readonly groups: InferredGroup[]

  /// An empty socket that is asked about; `watched` and `watchedType` are the answer: its scope and its type.
  readonly watch: Origin | undefined
  watched: Scope | undefined
  watchedType: Type | undefined

  readonly check: (e: Expr, type: Type, scope: Scope) => void
  readonly freeNames: (d: Declaration) => Set<string>
  readonly inferTopGroup: (members: readonly Declaration[], scope: Scope, infer: () => void) => void
  readonly readTopSignature: (text: string, node: Node) => Scheme | undefined
}

export function freshMeta(s: InferenceState): Meta {
  return {kind: "meta", id: s.count++, level: s.level, is: undefined}
}

/// Answers the question about `watch` when inference arrives there.
export function recordWatched(s: InferenceState, from: Origin | undefined, type: Type, scope: Scope): void {
  if (s.watch === undefined || s.watched !== undefined) return
  if (from?.block !== s.watch.block || from.input !== s.watch.input) return
  s.watched = scope
  s.watchedType = type
}

/// The type of an error, or of text that only GHC understands: it decides nothing and causes no second problem.
export function unknownType(s: InferenceState): Type {
  const type = freshMeta(s)
  s.holes.push(type)
  return type
}

export const mono = (type: Type): Scheme => ({variables: [], constraints: [], type})

/// Runs the inference of one definition. If a type becomes too large, its problems and constraints are dropped, and the answer is false.
export function inferWithinBounds(s: InferenceState, infer: () => void): boolean {
  const {level, lenient, opaque, scoped, wanted} = s
  const before = {problems: s.problems.length, wanted: wanted.length}
  try {
    infer()
    return true
  } catch (e) {
    if (!(e instanceof TypeTooLarge)) throw e
    s.problems.length = before.problems
    wanted.length = before.wanted
    Object.assign(s, {level, lenient, opaque, scoped, wanted})
    return false
  }
}
