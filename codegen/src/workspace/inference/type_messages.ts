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
  const against = (noun: string, beside: string) =>
    noun === words.nouns.Double && beside === words.nouns.Int ? words.types.aNumberWithAPoint : noun
  return [against(a, b), against(b, a)]
}

/// A type as the one that lacks an ability.
export function describeFor({name, type}: Constraint): string {
  const noun = describe(type)
  return name === "Integral" && noun === words.nouns.Double ? words.types.aNumberWithAPoint : noun
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

/// What is wrong, and why or what to do: two short sentences.
interface ProblemText {
  readonly kind: string
  readonly message: string
  readonly hint: string
}

function problemText(kind: string, message: string, hint: string): ProblemText {
  return {kind, message, hint}
}

const problemTexts: {
  readonly [K in TypeProblem["kind"]]: (
    problem: Extract<TypeProblem, {readonly kind: K}>,
    what: string,
  ) => ProblemText
} = {
  mismatch: (problem, what) => {
    const [wanted, found] = describeBoth(problem.wanted, problem.found)
    const shown = wanted === found ? [showType(problem.wanted), showType(problem.found)] : [wanted, found]
    const [asked = "", given = ""] = shown
    return problemText(
      "type-mismatch",
      words.types.hereGoes(asked, what, given),
      words.types.putSomethingElseHereOrChangeWhat,
    )
  },
  "no-instance": ({constraint}) => {
    if (constraint.name === "Ends") return misplacedDoneMessage(constraint)
    if (isNumberAsCommand(constraint))
      return problemText("type-mismatch", words.types.aNumberIsNoCommand, words.types.putAVelocityHere)
    return problemText(
      "type-mismatch",
      words.types.cannot(capital(describeFor(constraint)), abilityText(constraint)),
      words.types.useAnotherBlock,
    )
  },
  "unknown-name": (_, what) =>
    problemText("not-in-scope", words.types.hasNoMeaning(what), words.types.aNameIsKnownOnlyInside),
  taken: ({name}) =>
    problemText("duplicate", words.types.haskellItselfHasAAlready(name), words.types.giveThisOneAnotherName),
  twice: ({name}) =>
    problemText("duplicate", words.types.isGivenToTwoThings(name), words.types.giveOneOfThemAnotherName),
  "no-method": problem =>
    problemText("not-in-scope", foreignMethodMessage(problem), words.types.takeItOutOfThisBlock),
  "second-instance": ({name, of}) =>
    problemText("duplicate", words.types.belongsTwice(name, of), words.types.takeOneOfThemAway),
  "too-many-arguments": (_, what) =>
    problemText(
      "type-mismatch",
      words.types.getsMoreInputsThanItTakes(what),
      words.types.takeTheLastOnesAway,
    ),
  "wrong-field-count": ({name, wanted, found}) =>
    problemText(
      "type-mismatch",
      words.types.hasPartsAndHereAre(name, wanted, found),
      words.types.takeAFreshBlockFromTheToolbox,
    ),
  ambiguous: ({constraint}, what) => {
    const {types} = words
    if (constraint.name === "Sensor")
      return problemText("ambiguous", types.nothingSaysWhatOneOfTheInputs, types.putAPatternLikeBumperInto)
    return ["Command", "Controller", "Runnable"].includes(constraint.name)
      ? problemText(
          "ambiguous",
          types.nothingSaysWhatAFunctionHereSends,
          types.letItSendSomethingDefiniteOrWrite,
        )
      : problemText("ambiguous", types.nothingSaysWhatTypeHas(what), types.useAValueOfADefiniteType)
  },
  "too-general": ({constraint}) =>
    problemText(
      "type-mismatch",
      words.types.theTypeOfThisDefinitionPromisesToo(abilityText(constraint)),
      words.types.addToItsType(constraint.name, showType(constraint.type)),
    ),
  "bad-signature": ({text}) =>
    problemText("syntax", words.types.isNotAType(text), words.types.writeItLikeVelocityMaybeSound),
  "unknown-type": ({name}) =>
    problemText("not-in-scope", words.types.thereIsNoType(name), words.types.checkItsSpellingOrDefine),
  "unknown-class": ({name}) =>
    problemText("not-in-scope", words.types.thereIsNoClass(name), words.types.checkItsSpellingOrDefine),
  kind: ({name}) =>
    problemText("type-mismatch", words.types.takesOtherArguments(name), words.types.writeItLikeMaybeInt),
  "missing-superclass": ({of, name, wanted}) =>
    problemText(
      "type-mismatch",
      words.types.needsAnotherClass(of, name, wanted),
      words.types.deriveThatToo(wanted),
    ),
  "no-binding": ({name}) =>
    problemText("not-in-scope", words.types.hasOnlyAType(name), words.types.addAnEquationFor(name)),
  "clause-arity": () =>
    problemText("syntax", words.types.differentNumbersOfInputs, words.types.giveEachEquationTheSame),
}

/// The message about a problem. `what` names the block it is about.
export function problemMessage(problem: TypeProblem, what: string): ProblemText {
  const text: (problem: never, what: string) => ProblemText = problemTexts[problem.kind]
  return text(problem as never, what)
}

/// A `Done` that does not belong: outside a task, or with another result than its task's.
export function misplacedDoneMessage(constraint: Constraint): ProblemText {
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
