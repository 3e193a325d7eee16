/// The line ends of a file from elsewhere. The page works with `\n`, as CodeMirror does, and a file that is saved
/// again has the ends it came with: line by line where the learner changed nothing.

const ends = /\r\n?|\n/g
const mark = "\uFEFF"

/// The text as the page holds it: without a byte order mark, each line ended by one character.
export function oneKindOfLine(text: string): string {
  return text.replace(/^\uFEFF/, "").replace(ends, "\n")
}

/// `text`, which came from `file` by way of the page, with that file's byte order mark and line ends. New lines end
/// as most lines of the file do.
export function asInFile(file: string, text: string): string {
  const kinds = file.match(ends) ?? []
  const bom = file.startsWith(mark) ? mark : ""
  if (kinds.every(kind => kind === "\n")) return bom + text
  const before = oneKindOfLine(file).split("\n")
  const now = text.split("\n")
  const most = Math.min(before.length, now.length)
  let head = 0
  while (head < most && before[head] === now[head]) head += 1
  let tail = 0
  while (tail < most - head && before[before.length - 1 - tail] === now[now.length - 1 - tail]) tail += 1
  const usual = commonest(kinds)
  const shift = before.length - now.length
  let out = ""
  for (const [i, line] of now.slice(0, -1).entries()) {
    const old = i < head ? i : i >= now.length - tail ? i + shift : -1
    const end = kinds[old] ?? usual
    // Behind an empty line, these two would be one end.
    out += line + (end === "\n" && line === "" && out.endsWith("\r") ? "\r" : end)
  }
  return bom + out + now[now.length - 1]
}

function commonest(kinds: readonly string[]): string {
  const count = new Map<string, number>()
  for (const kind of kinds) count.set(kind, (count.get(kind) ?? 0) + 1)
  return [...count].reduce((best, kind) => (kind[1] > best[1] ? kind : best), ["\n", 0] as const)[0]
}
