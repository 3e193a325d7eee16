/// The one piece in which two texts differ; `null` when they are equal.
export function difference(old: string, now: string): {from: number; to: number; insert: string} | null {
  if (old === now) return null
  const most = Math.min(old.length, now.length)
  let from = 0
  while (from < most && old[from] === now[from]) from += 1
  let tail = 0
  while (tail < most - from && old[old.length - 1 - tail] === now[now.length - 1 - tail]) tail += 1
  return {from, to: old.length - tail, insert: now.slice(from, now.length - tail)}
}
