/// The imports of a Haskell file, read line by line.

/// `import qualified Data.Map as Map (Map, insert)`.
export interface Import {
  readonly module: string
  readonly qualified: boolean
  /// What stands before the dot.
  readonly as: string
  /// Names that are taken, or that are left out; undefined for all.
  readonly only: ReadonlySet<string> | undefined
  readonly hiding: ReadonlySet<string>
}

export function importsIn(header: string): Import[] {
  // The lines of the whole file may be indented below `module … where`.
  return logicalLines(header.replace(/^[ \t]+(?=import\b)/gm, "")).flatMap(readImport)
}

/// Lines that start at the margin, each with those below it that are indented. Without comments.
export function logicalLines(text: string): string[] {
  const lines: string[] = []
  for (const line of text.replace(/\{-[\s\S]*?-\}/g, " ").split("\n")) {
    const bare = line.replace(/(^|\s)--(?![!#$%&*+./<=>?@\\^|~:]).*$/, "").trimEnd()
    if (bare === "") continue
    if (/^\s/.test(bare) && lines.length > 0) lines[lines.length - 1] += `\n${bare}`
    else lines.push(bare)
  }
  return lines
}

function readImport(line: string): Import[] {
  const flat = line.replace(/\s+/g, " ")
  const found =
    /^import (?:safe )?(qualified )?(?:"[^"]*" )?([\p{Lu}][\w.']*)( qualified)?(?: as ([\p{Lu}][\w.']*))? ?(?:(hiding ?)?\((.*)\))? ?;?$/u.exec(
      flat,
    )
  // An import that is written in another way may bring any name.
  if (found === null)
    return /^import\b/.test(flat)
      ? [{module: "?", qualified: false, as: "?", only: undefined, hiding: new Set()}]
      : []
  const [, before, module = "", after, as, hiding, list] = found
  const names = list === undefined ? undefined : listed(list)
  return [
    {
      module,
      qualified: before !== undefined || after !== undefined,
      as: as ?? module,
      only: hiding === undefined ? names : undefined,
      hiding: (hiding === undefined ? undefined : names) ?? new Set(),
    },
  ]
}

/// `Map, (!), Maybe (..), Either (Left, Right)`.
function listed(list: string): Set<string> {
  return new Set(list.match(/[\p{L}_][\p{L}\p{N}_'.]*|\.\.|[!#$%&*+./<=>?@\\^|~:-]+/gu) ?? [])
}
