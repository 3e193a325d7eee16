/// Why a piece of Haskell is not made of blocks, in words for the learner. The catalogue: every raw node names one of these.

export const reasons = {
  broken: "Something here is not Haskell yet. Mend the text, and the blocks come back.",
  braces: "The whole file stands in braces. Blocks need lines that start at the margin.",
  several: "Two definitions share a line. Give each a line of its own.",
  lonely: "This gives a type to something that is defined elsewhere.",
  names: "One type for several names at once. Give each name a line of its own.",
  arity: "The equations of this function have different numbers of inputs.",
  directive: "An instruction to the compiler. It stays as it is.",
  class: "A class describes many types at once. Blocks have no shape for it.",
  instance: "This says how a type belongs to a class. Blocks have no shape for it.",
  fixity: "This sets how tightly an operator binds. It is kept as text.",
  family: "Types that are computed from types. Blocks have no shape for them.",
  foreign: "This comes from another programming language.",
  template: "Code that writes code. Blocks have no shape for it.",
  declaration: "Blocks have no shape for this kind of definition.",
  data: "This type uses more of Haskell than the type block can show.",
  strict: "A ! in this type says to compute a part at once. Blocks cannot show it.",
  deriving: "This type says in a special way what it can do. Blocks cannot show it.",
  synonym: "This name for a type uses more of Haskell than the block can show.",
  displaced: "The lines of this are indented in a way that blocks would disturb.",
  localFixity: "An operator gets its own binding inside this definition.",
  lambdaCase: "A function that looks at its input at once (\\case). Use “look at” inside a function instead.",
  multiWayIf: "An if with many branches. Use conditions of a definition instead.",
  typeApplication: "A type is given to a function by hand, with @.",
  tupleSection: "A tuple with a gap. Write a small function instead.",
  wildcards: "Two dots stand for all parts of a record. Name the parts you need.",
  puns: "A part of a record is used under its own name. Write name = name.",
  parallel: "A list is built from several lists side by side.",
  doVariant: "A special kind of do. Blocks have the plain one.",
  statement: "Blocks have no shape for this kind of step.",
  operators: "It is not clear which of these operators binds tighter. Add brackets.",
  name: "Blocks cannot spell this name.",
  literal: "Blocks cannot spell this value.",
  bang: "A ! in front of a name says to compute it at once.",
  lazy: "A ~ in front says not to look at the value yet.",
  viewPattern: "This looks at a value through a function.",
  typedPattern: "A type is written inside a pattern.",
  guards: "This has conditions in a place where blocks have none.",
  empty: "There is nothing after the equals sign.",
  large: "This has more parts than one block can hold.",
  deep: "This is nested too deep for blocks.",
  expression: "Blocks have no shape for this kind of expression.",
  pattern: "Blocks have no shape for this kind of pattern.",
} as const

export type Cause = keyof typeof reasons

const causes = new Map<string, Cause>(Object.entries(reasons).map(([cause, text]) => [text, cause as Cause]))

/// The cause behind a reason's words.
export function causeOf(reason: string | undefined): Cause | undefined {
  return reason === undefined ? undefined : causes.get(reason)
}
