/// Names in declarations that say something about another definition: signatures apart from their equations, fixity declarations and pragmas;
/// and the extensions of the language that a file turns on. Text in, text out.

const word = String.raw`[\p{L}_][\p{L}\p{N}_']*`
const symbols = String.raw`[!#$%&*+./<=>?@\\^|~:-]+`
const prefixName = new RegExp(
  String.raw`"(?:[^"\\]|\\.)*"|\(\s*(${symbols})\s*\)|(?<![\p{L}\p{N}_'.])(${word})`,
  "gu",
)
const infixName = new RegExp(String.raw`\x60(${word})\x60|(${symbols})`, "gu")

const isOperator = (name: string) => new RegExp(`^${symbols}$`, "u").test(name)

/// A signature, fixity declaration or pragma with a name replaced; undefined for any other text.
export function renamedInDirective(text: string, old: string, name: string): string | undefined {
  const prefix = isOperator(name) ? `(${name})` : name
  const infix = isOperator(name) ? name : `\`${name}\``
  const replaced = (part: string, pattern: RegExp, by: string) =>
    part.replace(pattern, (whole, first?: string, second?: string) =>
      (first ?? second) === old ? by : whole,
    )
  if (/^infix[lr]?\s/.test(text)) {
    const [, head = "", operators = ""] = /^(infix[lr]?\s+\d?\s*)([\s\S]*)$/.exec(text) ?? []
    return head + replaced(operators, infixName, infix)
  }
  const pragma =
    /^(\{-#\s*(?:NO)?INLINE?(?:ABLE)?|\{-#\s*(?:OPAQUE|SPECIALI[SZ]E|DEPRECATED|WARNING))\b([\s\S]*)$/.exec(
      text,
    )
  const signature = new RegExp(
    String.raw`^()((?:${word}|\(\s*${symbols}\s*\))(?:\s*,\s*(?:${word}|\(\s*${symbols}\s*\)))*\s*(?:::|∷)[\s\S]*)$`,
    "u",
  ).exec(text)
  const [, head = "", rest = ""] = pragma ?? signature ?? []
  if (pragma === null && signature === null) return undefined
  const type = rest.search(/::|∷/)
  const names = type < 0 ? rest : rest.slice(0, type)
  return head + replaced(names, prefixName, prefix) + rest.slice(names.length)
}

/// Extensions of the language that the LANGUAGE pragmas of a text turn on.
export function extensionsIn(text: string): ReadonlySet<string> {
  return new Set(
    [...text.matchAll(/\{-#\s*LANGUAGE\s([^#]*)#-\}/gi)].flatMap(([, names = ""]) =>
      names.split(",").map(name => name.trim()),
    ),
  )
}
