/// Debounce of text edits: the blocks are updated after the frame that shows the key press, never before it. If an update takes noticeably long, it waits for a pause between
/// key presses. Where the path of the edited program is on its way, the blocks come after it: updating and drawing them takes the processor for as long as computing the path.

import type {ChangeSet} from "../../program/text_changes.ts"

/// Milliseconds that following may cost without being felt, as long as a task of the browser may take (W3C Long Tasks §1.1); the longest pause to wait
/// for instead; and how long the blocks may stay behind uninterrupted typing.
const quick = 50
const longestPause = 400
const furthestBehind = 2000

/// How long the blocks wait for the path: after the last key press, and while keys follow one another; in milliseconds.
const pathPause = 150
const furthestBehindPath = 300

/// Time until a frame is presented, in milliseconds: two frames at 60 Hz.
const presentationDelay = 34

/// Edits of the text that the document does not have yet.
export interface PendingEdit {
  readonly text: string
  /// From the document's text to `text`.
  readonly changes: ChangeSet
  /// Something of it was typed here, not by another user who edits the text, too.
  readonly isOwn: boolean
}

export interface EditDebounce {
  /// Whether an edit is pending.
  waits(): boolean
  /// The text was changed, to `text`.
  typed(text: string, changes: ChangeSet, isOwn: boolean): void
  /// The edits since the last call, to be applied now.
  take(): PendingEdit | null
  /// Drops the pending edit: another program is open.
  forget(): void
  /// The path is drawn in this frame, or no path is expected.
  pathSettled(): void
  /// Following the last text has cost so many milliseconds more.
  cost(more: number): void
}

/// `isPathPending` says whether the path of the edited program is on its way.
export function openEditDebounce(follow: () => void, isPathPending: () => boolean): EditDebounce {
  let pending: PendingEdit | null = null
  /// When the first of it was typed, and what following cost the last time, in milliseconds.
  let since = 0
  let cost = 0
  let gap: ReturnType<typeof setTimeout> | undefined
  let picture = 0
  let awaitsPath = false

  const hold = () => {
    clearTimeout(gap)
    cancelAnimationFrame(picture)
    awaitsPath = false
  }
  /// The pause that the last cost asks for.
  const pause = () => (cost < quick ? 0 : Math.min(longestPause, cost))
  const afterPicture = () => {
    awaitsPath = isPathPending()
    const untilPath = awaitsPath ? Math.min(pathPause, since + furthestBehindPath - performance.now()) : 0
    gap = setTimeout(follow, Math.max(untilPath, pause()))
  }
  const soon = () => {
    hold()
    if (performance.now() - since > furthestBehind) return follow()
    if (document.visibilityState === "hidden") gap = setTimeout(follow, pause())
    else picture = requestAnimationFrame(afterPicture)
  }
  return {
    waits: () => pending !== null,
    typed(text, changes, isOwn) {
      if (pending === null) since = performance.now()
      pending = {
        text,
        changes: pending === null ? changes : pending.changes.compose(changes),
        isOwn: isOwn || pending?.isOwn === true,
      }
      soon()
    },
    take() {
      hold()
      const taken = pending
      pending = null
      if (taken !== null) cost = 0
      return taken
    },
    forget() {
      hold()
      pending = null
    },
    pathSettled() {
      if (!awaitsPath) return
      hold()
      gap = setTimeout(follow, Math.max(presentationDelay, pause()))
    },
    cost(more) {
      cost += more
    },
  }
}
