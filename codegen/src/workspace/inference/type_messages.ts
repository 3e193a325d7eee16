/// Messages about types and type problems for learners.

import type {Family} from "../../block_shape.ts"
import {familyOfHead} from "../../blocks/spec/constructor_labels.ts"
import {commandClasses} from "../../types/class_constraints.ts"
import type {Constraint, Type} from "../../types/syntax/type.ts"
import {asFunction, metasIn, prune, showType, spine, variablesIn} from "../../types/syntax/type.ts"
import type {TypeProblem} from "../../types/syntax/type_problems.ts"
import {words} from "../../words/index.ts"

/// "a Velocity", "a light", "a list ([Int])", "a function". What is open stays unsaid: "a list", "a Maybe".
export function describe(type: Type): string {
  const {head, args} = spine(type)
  if (head.kind === "meta") return words.types.something
  if (head.kind === "var") return words.types.somethingOfAnyType
  if (head.kind !== "con") return words.types.something
  const [first] = args
  if (asFunction(type) !== undefined) return words.types.aFunction
  const open = metasIn(type).size > 0 || variablesIn(type).size > 0 || args.every(a => showType(a) === "()")
  const text = open ? "" : ` (${showType(type)})`
  if (head.name === "[]" && first !== undefined) {
    const item = spine(first)
    if (item.head.kind === "con" && item.head.name === "Char") return words.types.text
    return `${words.types.aList}${text}`
  }
  if (head.name === "()") return words.types.theEmptyValue
  // The type of a pair has brackets of its own.
  if (/^\(,+\)$/.test(head.name))
    return `${words.types.together(args.length)}${open ? "" : ` ${showType(type)}`}`
  const nouns: {readonly [type: string]: string} = words.nouns
  const noun = nouns[head.name]
  if (noun !== undefined) return args.length === 0 || plain.has(head.name) ? noun : `${noun}${text}`
  return words.types.a(open && args.length > 0 ? head.name : showType(type))
}

/// Two types beside each other: a number, beside a whole one, is one with a decimal point.
export function describeBoth(one: Type, other: Type): readonly [string, string] {
  const [a, b] = [describe(one), describe(other)]
  const against = (said: string, beside: string) =>
    said === words.nouns.Double && beside === words.nouns.Int ? words.types.aNumberWithAPoint : said
  return [against(a, b), against(b, a)]
}

/// What is said to lack an ability.
export function describeFor({name, type}: Constraint): string {
  const said = describe(type)
  return name === "Integral" && said === words.nouns.Double ? words.types.aNumberWithAPoint : said
}

/// Types of which a learner need not know the parameters.
const plain = new Set(["IO", "TaskOptions", "CallOptions"])

export function abilityText(constraint: Constraint): string {
  const abilities: {readonly [name: string]: string} = words.abilities
  return abilities[constraint.name] ?? words.types.doWhatAsks(constraint.name)
}

/// Whether a number stands where something is sent to the robot.
export function isNumberAsCommand({name, type}: Constraint): boolean {
  const {head} = spine(type)
  return commandClasses.has(name) && head.kind === "con" && numberTypes.has(head.name)
}

const numberTypes: ReadonlySet<string> = new Set(["Double", "Float", "Int", "Integer", "Word"])

/// What is wrong, and why or what to do: two short sentences. `what` names the block it is about.
export function problemMessage(
  problem: TypeProblem,
  what: string,
): {kind: string; message: string; hint: string} {
  switch (problem.kind) {
    case "mismatch": {
      const [wanted, found] = describeBoth(problem.wanted, problem.found)
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
      if (problem.constraint.name === "Ends") return misplacedDoneMessage(problem.constraint)
      if (isNumberAsCommand(problem.constraint))
        return {
          kind: "type-mismatch",
          message: words.types.aNumberIsNoCommand,
          hint: words.types.putAVelocityHere,
        }
      return {
        kind: "type-mismatch",
        message: words.types.cannot(
          capital(describeFor(problem.constraint)),
          abilityText(problem.constraint),
        ),
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
    case "no-method":
      return {
        kind: "not-in-scope",
        message: foreignMethodMessage(problem),
        hint: words.types.takeItOutOfThisBlock,
      }
    case "second-instance":
      return {
        kind: "duplicate",
        message: words.types.belongsTwice(problem.name, problem.of),
        hint: words.types.takeOneOfThemAway,
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
        message: words.types.theTypeOfThisDefinitionPromisesToo(abilityText(problem.constraint)),
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
    case "unknown-class":
      return {
        kind: "not-in-scope",
        message: words.types.thereIsNoClass(problem.name),
        hint: words.types.checkItsSpellingOrDefine,
      }
    case "kind":
      return {
        kind: "type-mismatch",
        message: words.types.takesOtherArguments(problem.name),
        hint: words.types.writeItLikeMaybeInt,
      }
    case "missing-superclass":
      return {
        kind: "type-mismatch",
        message: words.types.needsAnotherClass(problem.of, problem.name, problem.wanted),
        hint: words.types.deriveThatToo(problem.wanted),
      }
    case "no-binding":
      return {
        kind: "not-in-scope",
        message: words.types.hasOnlyAType(problem.name),
        hint: words.types.addAnEquationFor(problem.name),
      }
    case "clause-arity":
      return {
        kind: "syntax",
        message: words.types.differentNumbersOfInputs,
        hint: words.types.giveEachEquationTheSame,
      }
  }
}

/// A `Done` that does not belong: outside a task, or with another result than its task's.
export function misplacedDoneMessage(constraint: Constraint): {kind: string; message: string; hint: string} {
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

/// What does not belong into an instance, because its class does not ask for it.
export function foreignMethodMessage({name, of}: TypeProblem & {kind: "no-method"}): string {
  return name === "" ? words.types.onlyNamesGoHere(of) : words.types.isNoPartOf(name, of)
}
