/// The names of the Prelude and of Rosy, as GHC sees them (`environment.generated.ts`), and the few things GHC knows by itself.

import {generated} from "./environment.generated.ts"
import {parseEnvironment} from "./environment.ts"

const builtIn = `
type String = [Char]
hidden class Ends a
hidden data Ratio a
instance Eq a => Eq (Ratio a)
instance Integral a => Ord (Ratio a)
instance Show a => Show (Ratio a)
instance (Integral a, Read a) => Read (Ratio a)
instance Integral a => Enum (Ratio a)
instance Integral a => Num (Ratio a)
instance Integral a => Fractional (Ratio a)
instance Integral a => Real (Ratio a)
instance Integral a => RealFrac (Ratio a)
hidden data IOException
instance Eq IOException
instance Show IOException
hidden data NotInATask
`

const prelude = preludeNames(generated)

export const library = parseEnvironment(`${generated}\n${builtIn}`, prelude.all, prelude.types)

/// What the Prelude exports: everything up to the first line that only Rosy brings; its types and classes once more.
function preludeNames(text: string): {all: Set<string>; types: Set<string>} {
  const names = new Set<string>()
  const types = new Set<string>()
  for (const line of text.split("\n")) {
    if (line.startsWith("(<$!>)")) break
    const value = /^\(?([^\s()]+)\)? ::/.exec(line)?.[1]
    if (value !== undefined) names.add(value)
    const type = /^(?:data|newtype|type) (\S+)(?:(?: \w+)* = (.*))?/.exec(line)
    if (type !== null) {
      types.add(type[1] ?? "")
      if (!line.startsWith("type "))
        for (const c of (type[2] ?? "").split(" | ")) names.add(c.split(" ")[0] ?? "")
    }
    const cls = /^class (?:.* => )?(\w+) \w+$/.exec(line)?.[1]
    if (cls !== undefined) types.add(cls)
  }
  return {all: new Set([...names, ...types]), types}
}
