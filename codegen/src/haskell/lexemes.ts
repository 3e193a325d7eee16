/// Names, operators and literals as Haskell spells them.
///
/// The printer passes every name through here, so that nothing a learner types can turn into another token:
/// a reserved word gets a prime, other characters are dropped. (Haskell 2010 report §2.4.)

export const reservedWords: ReadonlySet<string> = new Set(
  `case class data default deriving do else foreign if import in infix infixl infixr instance let module
   newtype of then type where _ forall mdo proc rec family role pattern static stock anyclass via`
    .split(/\s+/)
    // The last ones are only special in places where no variable can stand, or behind extensions that are off.
    .filter(
      word =>
        ![
          "family",
          "role",
          "pattern",
          "static",
          "stock",
          "anyclass",
          "via",
          "forall",
          "mdo",
          "proc",
          "rec",
        ].includes(word),
    ),
)

const reservedOperators: ReadonlySet<string> = new Set([
  "..",
  ":",
  "::",
  "=",
  "\\",
  "|",
  "<-",
  "->",
  "@",
  "~",
  "=>",
  "--",
])
/// The signs of the extension UnicodeSyntax, of which each is one of the reserved ones; without the extension an operator like any other. GHC User's Guide,
/// "Unicode syntax".
export const unicodeSyntax = /[∷⇒→←★∀⤙⤚⤛⤜]/g
// Report §2.2: `symbol`. Not brackets and quotation marks, which GHC accepts in no name.
const operatorCharacters = /^(?:(?![,;`'"_])[\p{S}\p{Pc}\p{Pd}\p{Po}])+$/u

export function isVariableName(text: string): boolean {
  // Letters without case count as small ones, as GHC has it.
  return (
    /^(?:\p{Lu}[\p{L}\p{N}_']*\.)*[\p{Ll}\p{Lo}_][\p{L}\p{N}_']*$/u.test(text) && !reservedWords.has(text)
  )
}

export function isConstructorName(text: string): boolean {
  return /^(?:\p{Lu}[\p{L}\p{N}_']*\.)*\p{Lu}[\p{L}\p{N}_']*$/u.test(text)
}

export function isOperator(text: string): boolean {
  return (
    operatorCharacters.test(text) &&
    !/^[∷⇒→←★∀⤙⤚⤛⤜]$/.test(text) &&
    !reservedOperators.has(text) &&
    !/^-{2,}$/.test(text)
  )
}

/// A name or operator without the module before it: `M.!` is `!`, and `.` stays itself.
export function unqualified(text: string): string {
  return text.replace(/^(?:\p{Lu}[\p{L}\p{N}_']*\.)+(?=.)/u, "")
}

/// An operator as it is used; a module may stand before it.
export function isOperatorUse(text: string): boolean {
  return isOperator(unqualified(text))
}

/// The operator of constructors, as in `x : xs`; a module may stand before it.
export function isConstructorOperator(text: string): boolean {
  const bare = unqualified(text)
  return text === ":" || (isOperator(bare) && bare.startsWith(":"))
}

/// The nearest variable name that Haskell accepts.
export function variableName(text: string): string {
  if (isVariableName(text)) return text
  const kept = text.replace(/[^\p{L}\p{N}_']/gu, "").replace(/^[\p{N}']+/u, "")
  const lower = kept.replace(/^\p{Lu}/u, first => first.toLowerCase())
  if (lower === "" || /^_*$/.test(lower) || !/^[\p{Ll}_]/u.test(lower))
    return lower === "" || /^_*$/.test(lower) ? "x" : `x${lower}`
  return reservedWords.has(lower) ? `${lower}'` : lower
}

/// The nearest constructor or type name that Haskell accepts.
export function constructorName(text: string): string {
  if (isConstructorName(text)) return text
  const kept = text.replace(/[^\p{L}\p{N}_']/gu, "").replace(/^[\p{N}_']+/u, "")
  const upper = kept.replace(/^\p{Ll}/u, first => first.toUpperCase())
  if (upper === "") return "X"
  return /^\p{Lu}/u.test(upper) ? upper : `X${upper}`
}

/// A constructor as a word of its own: operators and the special ones in brackets.
export function constructorWord(name: string): string {
  if (name === "()" || name === "[]" || /^\(,+\)$/.test(name)) return name
  return isConstructorOperator(name) ? `(${name})` : constructorName(name)
}

/// A number literal without its sign; anything else becomes 0.
export function numberLiteral(text: string): {negative: boolean; digits: string} {
  const trimmed = text.trim()
  const negative = trimmed.startsWith("-")
  const digits = negative ? trimmed.slice(1).trim() : trimmed
  return isNumberLiteral(digits) ? {negative, digits} : {negative: false, digits: "0"}
}

/// With underscores between digits, as GHC's `NumericUnderscores` has it; every program may use them.
export function isNumberLiteral(text: string): boolean {
  return /^(?:\d(?:_*\d)*(?:\.\d(?:_*\d)*)?(?:_*[eE][+-]?\d(?:_*\d)*)?|0[xX](?:_*[\da-fA-F])+|0[oO](?:_*[0-7])+|0[bB](?:_*[01])+)$/.test(
    text,
  )
}

/// Whether the literal has a decimal point or an exponent, so that it cannot be an `Int`.
export function isFractionalLiteral(text: string): boolean {
  return /^\d/.test(text) && !/^0[xXoObB]/.test(text) && /[.eE]/.test(text)
}

/// A string as Haskell writes it, with quotes.
export function stringLiteral(value: string): string {
  let out = '"'
  for (const character of value) {
    const next = escaped(character)
    // `\1234` followed by a digit would read on; `\&` ends it. (Haskell 2010 report §2.6)
    if (/\\\d+$/.test(out) && /^\d/.test(next)) out += "\\&"
    out += character === "'" ? "'" : character === '"' ? '\\"' : next
  }
  return `${out}"`
}

export function characterLiteral(value: string): string {
  const [first = " "] = value
  return first === "'" ? "'\\''" : first === '"' ? "'\"'" : `'${escaped(first)}'`
}

function escaped(character: string): string {
  if (character === "\\") return "\\\\"
  if (character === "\n") return "\\n"
  if (character === "\t") return "\\t"
  const code = character.codePointAt(0) ?? 32
  if (code < 32 || (code >= 127 && code < 160) || (code >= 0xd800 && code <= 0xdfff))
    return `\\${code >= 0xd800 && code <= 0xdfff ? 0xfffd : code}`
  // Line and paragraph separators would end the line for some editors.
  return /[\p{L}\p{N}\p{P}\p{S}\p{M} ]/u.test(character) ? character : `\\${code}`
}

/// A variable as a word of its own: an operator in brackets.
export function variableWord(name: string): string {
  return isOperatorUse(name) ? `(${name})` : variableName(name)
}

/// An operator between two operands: a symbol, or a name in backticks.
export function operatorWord(op: string): string {
  if (isOperatorUse(op) || op === ":") return op
  return `\`${isConstructorName(op) ? op : variableName(op)}\``
}
