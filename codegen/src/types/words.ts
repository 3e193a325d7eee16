/// Types and type problems in a learner's words.

import {familyOfHead} from "../blocks/vocabulary.ts"
import type {Family} from "../shape.ts"
import {words} from "../words/index.ts"
import type {TypeProblem} from "./problems.ts"
import type {Constraint, Type} from "./type.ts"
import {asFunction, prune, showType, spine} from "./type.ts"

/// "a Velocity", "a light", "a list of numbers", "a function".
export function describe(type: Type): string {
  const {head, args} = spine(type)
  if (head.kind === "meta") return words.types.something
  if (head.kind === "var") return words.types.somethingOfAnyType
  if (head.kind !== "con") return words.types.something
  const [first] = args
  if (asFunction(type) !== undefined) return words.types.aFunction
  if (head.name === "[]" && first !== undefined) {
    const item = spine(first)
    if (item.head.kind === "con" && item.head.name === "Char") return words.types.text
    return words.types.aList(showType(type))
  }
  if (head.name === "()") return words.types.nothing
  if (/^\(,+\)$/.test(head.name)) return words.types.thingsTogether(args.length, showType(type))
  const nouns: {readonly [type: string]: string} = words.nouns
  const noun = nouns[head.name]
  if (noun !== undefined && args.length === 0) return noun
  return words.types.a(showType(type))
}

export function ability(constraint: Constraint): string {
  const abilities: {readonly [name: string]: string} = words.abilities
  return abilities[constraint.name] ?? words.types.doWhatAsks(constraint.name)
}

/// What is wrong, and why or what to do: two short sentences. `what` names the block it is about.
export function problemWords(
  problem: TypeProblem,
  what: string,
): {kind: string; message: string; hint: string} {
  switch (problem.kind) {
    case "mismatch": {
      const wanted = describe(problem.wanted)
      const found = describe(problem.found)
      const same = wanted === found
      return {
        kind: "type-mismatch",
        message: same
          ? words.types.hereGoes(showType(problem.wanted), what, showType(problem.found))
          : words.types.hereGoes(wanted, what, found),
        hint: words.types.putSomethingElseHereOrChangeWhat,
      }
    }
    case "no-instance":
      if (problem.constraint.name === "Ends") return endWords(problem.constraint)
      return {
        kind: "type-mismatch",
        message: words.types.cannot(capital(describe(problem.constraint.type)), ability(problem.constraint)),
        hint: words.types.useAnotherBlock,
      }
    case "unknown-name":
      return {
        kind: "not-in-scope",
        message: words.types.hasNoMeaning(what),
        hint: words.types.aNameIsKnownOnlyInside,
      }
    case "taken":
      return {
        kind: "duplicate",
        message: words.types.haskellItselfHasAAlready(problem.name),
        hint: words.types.giveThisOneAnotherName,
      }
    case "twice":
      return {
        kind: "duplicate",
        message: words.types.isGivenToTwoThings(problem.name),
        hint: words.types.giveOneOfThemAnotherName,
      }
    case "too-many-arguments":
      return {
        kind: "type-mismatch",
        message: words.types.getsMoreInputsThanItTakes(what),
        hint: words.types.takeTheLastOnesAway,
      }
    case "wrong-field-count":
      return {
        kind: "type-mismatch",
        message: words.types.hasPartsAndHereAre(problem.name, problem.wanted, problem.found),
        hint: words.types.takeAFreshBlockFromTheToolbox,
      }
    case "ambiguous":
      if (problem.constraint.name === "Sensor")
        return {
          kind: "ambiguous",
          message: words.types.nothingSaysWhatOneOfTheInputs,
          hint: words.types.putAPatternLikeBumperInto,
        }
      if (["Command", "Controller", "Runnable"].includes(problem.constraint.name))
        return {
          kind: "ambiguous",
          message: words.types.nothingSaysWhatAFunctionHereSends,
          hint: words.types.letItSendSomethingDefiniteOrWrite,
        }
      return {
        kind: "ambiguous",
        message: words.types.nothingSaysWhatTypeHas(what),
        hint: words.types.useAValueOfADefiniteType,
      }
    case "too-general":
      return {
        kind: "type-mismatch",
        message: words.types.theTypeOfThisDefinitionPromisesToo(ability(problem.constraint)),
        hint: words.types.addToItsType(problem.constraint.name, showType(problem.constraint.type)),
      }
    case "bad-signature":
      return {
        kind: "syntax",
        message: words.types.isNotAType(problem.text),
        hint: words.types.writeItLikeVelocityMaybeSound,
      }
    case "unknown-type":
      return {
        kind: "not-in-scope",
        message: words.types.thereIsNoType(problem.name),
        hint: words.types.checkItsSpellingOrDefine,
      }
  }
}

/// A `Done` that does not belong: outside a task, or with another result than its task's.
function endWords(constraint: Constraint): {kind: string; message: string; hint: string} {
  const [end] = spine(constraint.type).args
  const outside = end !== undefined && showType(end) === "NotInATask"
  return {
    kind: "type-mismatch",
    message: outside ? words.types.aDoneEndsATask : words.types.thisDoneDoesNotCarryWhat,
    hint: outside ? words.types.putItIntoTheFunctions : words.types.giveDoneTheSameKindOfValue,
  }
}

export function capital(text: string): string {
  return text.replace(/^\p{Ll}/u, c => c.toUpperCase())
}

/// The colour of a type's values; `undefined` while the type is unknown.
export function familyOfType(type: Type, as: "value" | "pattern"): Family | undefined {
  const f = asFunction(type)
  // A function looks like what it reacts to.
  if (f !== undefined) return familyOfType(f.from, "pattern") ?? "own"
  const {head} = spine(prune(type))
  return head.kind === "con" ? familyOfHead(head.name, as) : undefined
}
