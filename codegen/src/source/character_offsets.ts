/// Offsets of the places that the compiler tells. It counts lines and characters from 1, and no byte order mark; offsets count UTF-16 units.

export function characterOffsets(text: string): (line: number, column: number) => number {
  const starts = [text.startsWith("\uFEFF") ? 1 : 0]
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) starts.push(at + 1)
  return (line, column) => {
    const start = starts[line - 1] ?? text.length
    let units = 0
    for (let i = 1; i < column; i++) units += (text.codePointAt(start + units) ?? 0) > 0xffff ? 2 : 1
    return start + units
  }
}
