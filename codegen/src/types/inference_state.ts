/// Mutable state of one type inference: unknown types, collected problems, wanted class constraints and results.
///
/// Every rule of inference is a function over this state. The three function fields connect rules that need each other across files
/// (bindings contain expressions, expressions contain bindings) and are set once, by `createInference`.

import type {Declaration, Expr, Node, Origin} from "../model/syntax_tree.ts"
import type {BlockId} from "../serialized_blocks.ts"
import type {Environment} from "./environment/environment.ts"
import type {Clash} from "./environment/unification.ts"
import type {InferredGroup} from "./inference_cache.ts"
import type {Scope} from "./syntax/scope.ts"
import type {Meta, Scheme, Type} from "./syntax/type.ts"
import {checkSize, TypeTooLarge} from "./syntax/type.ts"
import type {TypeProblem, Wanted} from "./syntax/type_problems.ts"

export interface InferenceState {
  readonly env: Environment
  /// Types of nodes that belong to no group of top-level definitions, or to the group that is being inferred.
  found: Map<Node, Type>
  schemes: Map<Declaration, Scheme>
  readonly problems: TypeProblem[]
  /// Types that a hole, an error or text for GHC leaves open; they cause no further problem.
  readonly holes: Type[]
  /// Those of finished definitions, of which nothing can be decided any more.
  readonly settledHoles: Type[]
  /// The names whose types some of `holes` are.
  readonly foreignNames: Map<Type, string>
  /// Those of `holes` that are empty sockets.
  readonly sockets: Set<Type>
  /// Parts of types that became one although they differ: only GHC knows what a name in one of them stands for.
  readonly unreadClashes: Clash[]
  /// Names that nothing in scope defines, by their place: a module that is not read may have them.
  readonly undefinedNames: Map<Node, string>
  /// Types in constraints of classes that only GHC knows: which they are may follow from an instance.
  readonly improvable: Type[]
  wanted: Wanted[]
  /// Constraints of loose blocks that no binding has taken; they show what kind of value is meant.
  readonly pending: Wanted[]
  /// Depth of bindings. A meta variable of a deeper level than a binding belongs to that binding (generalisation by levels).
  level: number
  /// Number of the next meta variable.
  count: number
  /// Whether undefined names are accepted, as in loose blocks.
  lenient: boolean
  /// Whether the definition that is being inferred is checked against a signature.
  signed: boolean
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
  /// A block whose own type is kept apart from the one that its place wants; answered by `typesApart`.
  readonly apart: BlockId | undefined
  typesApart: TypesApart | undefined

  readonly check: (e: Expr, type: Type, scope: Scope) => void
  readonly freeNames: (d: Declaration) => Set<string>
  readonly inferTopGroup: (members: readonly Declaration[], scope: Scope, infer: () => void) => void
  readonly readTopSignature: (text: string, node: Node) => Scheme | undefined
}

/// Types of a block and of its place before they become one.
export interface TypesApart {
  readonly own: Type
  readonly wanted: Type
  /// The innermost definition around the block has a signature, so that its type does not follow from the block.
  readonly isSigned: boolean
  /// Inside a clause or an alternative whose constructor may refine types (GADTs), or a definition whose signature cannot be read.
  isBeyondInference: boolean
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

/// The type of an error, or of text that only GHC understands: it decides nothing and causes no second problem. `name`
/// is whose type it is.
export function unknownType(s: InferenceState, name?: string): Type {
  const type: Meta = {...freshMeta(s), isForeign: true}
  if (name !== undefined) s.foreignNames.set(type, name)
  s.holes.push(type)
  return type
}

export const mono = (type: Type): Scheme => ({variables: [], constraints: [], type})

/// Runs the inference of one definition. If a type becomes too large, all that was found is dropped, and the answer is false.
export function inferWithinBounds(s: InferenceState, infer: () => void): boolean {
  const {found, level, lenient, opaque, schemes, scoped, signed, wanted} = s
  const before = {
    found: found.size,
    holes: s.holes.length,
    problems: s.problems.length,
    wanted: wanted.length,
  }
  try {
    infer()
    if (found.size > before.found) for (const type of [...found.values()].slice(before.found)) checkSize(type)
    return true
  } catch (e) {
    if (!(e instanceof TypeTooLarge)) throw e
    for (const node of [...found.keys()].slice(before.found)) found.delete(node)
    s.holes.length = before.holes
    s.problems.length = before.problems
    wanted.length = before.wanted
    Object.assign(s, {found, level, lenient, opaque, schemes, scoped, signed, wanted})
    return false
  }
}
