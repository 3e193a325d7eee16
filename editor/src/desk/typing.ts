/// When the blocks follow what is typed: after the picture that shows the key, never before it. Where following would be felt at the next key, it waits for a
/// gap between keys.

/// Milliseconds that following may cost without being felt, as long as a task of the browser may take (W3C Long Tasks §1.1); the longest pause to wait
/// for instead; and how long the blocks may stay behind somebody who never pauses.
const quick = 50
const longestPause = 400
const furthestBehind = 2000

export interface Typing {
  /// Whether something was typed that has not been taken.
  waits(): boolean
  /// The text is this now.
  typed(text: string): void
  /// What was typed since the last time, to be followed now.
  take(): string | null
  /// What was typed is nobody's any more: another program is open.
  forget(): void
  /// Following the last text has cost so many milliseconds more.
  cost(more: number): void
}

export function openTyping(follow: () => void): Typing {
  let text: string | null = null
  /// When the first of it was typed, and what following cost the last time, in milliseconds.
  let since = 0
  let cost = 0
  let gap: ReturnType<typeof setTimeout> | undefined
  let picture = 0

  const hold = () => {
    clearTimeout(gap)
    cancelAnimationFrame(picture)
  }
  const soon = () => {
    hold()
    if (performance.now() - since > furthestBehind) return follow()
    const pause = cost < quick ? 0 : Math.min(longestPause, cost)
    if (document.visibilityState === "hidden") gap = setTimeout(follow, pause)
    else
      picture = requestAnimationFrame(() => {
        gap = setTimeout(follow, pause)
      })
  }
  return {
    waits: () => text !== null,
    typed(now) {
      if (text === null) since = performance.now()
      text = now
      soon()
    },
    take() {
      hold()
      const taken = text
      text = null
      if (taken !== null) cost = 0
      return taken
    },
    forget() {
      hold()
      text = null
    },
    cost(more) {
      cost += more
    },
  }
}
