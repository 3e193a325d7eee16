/// Kinds of types, as far as they show without inference: the number of arguments of a type, and known classes.

import type {Type} from "../syntax/type.ts"
import {prune, spine} from "../syntax/type.ts"
import type {Environment} from "./environment.ts"
import {expand} from "./environment.ts"

/// The constructors that a type names.
export function typeNamesIn(type: Type, found: Set<string> = new Set()): Set<string> {
  const t = prune(type)
  if (t.kind === "con") found.add(t.name)
  if (t.kind === "app") {
    typeNamesIn(t.fn, found)
    typeNamesIn(t.arg, found)
  }
  return found
}

/// Whether a class is in scope: Rosy's, the program's own, or imported. The name of a constraint synonym counts.
export function isKnownClass(env: Environment, name: string): boolean {
  return (
    (env.classes.has(name) && !env.hidden.has(name)) ||
    env.ownClasses?.has(name) === true ||
    env.importedClasses?.has(name) === true ||
    env.types.has(name) ||
    env.open === true
  )
}

/// Types whose parameters are all types of values.
const ofValues = /^(?:->|\[\]|\(,+\)|Maybe|Either|IO|Task|Memory)$/

/// The name of a type in a type of values that has too few or too many arguments. Only types with known parameters are
/// checked, and arguments of other types only for too many: their kinds follow from definitions that are not analysed here.
export function misappliedType(written: Type, env: Environment): string | undefined {
  return misapplied(expand(written, env), env, true)
}

function misapplied(type: Type, env: Environment, isValue: boolean): string | undefined {
  const {head, args} = spine(prune(type))
  if (head.kind === "con") {
    const count = parameterCount(head.name, env)
    if (count !== undefined && (args.length > count || (isValue && args.length < count))) return head.name
  }
  const inner = head.kind === "con" && ofValues.test(head.name)
  for (const a of args) {
    const wrong = misapplied(a, env, inner)
    if (wrong !== undefined) return wrong
  }
  return undefined
}

/// The number of a type's parameters; undefined where it is not known for sure.
function parameterCount(name: string, env: Environment): number | undefined {
  if (name === "->") return 2
  if (name === "[]") return 1
  if (/^\(,*\)$/.test(name)) return name === "()" ? 0 : name.length - 1
  const entry = env.types.get(name)
  return entry === undefined || entry.foreign === true || entry.synonym !== undefined
    ? undefined
    : entry.parameters.length
}
