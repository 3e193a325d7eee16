/// Keyboard navigation in the diagram's list form: the line that an arrow key leads to. Pure.

/// The line of the list that an arrow key leads to: the next marked one, or the next one where none is marked.
export function nextInList(marked: readonly boolean[], from: number, by: 1 | -1): number | null {
  const isWay = marked.includes(true)
  for (let i = from + by; i >= 0 && i < marked.length; i += by) if (!isWay || marked[i]) return i
  return null
}
