/// What the page says about its state, in the words of the learner's language.

import type {Notice, PageState} from "../state/page.ts"
import {isActive} from "../state/run.ts"
import {words} from "../words/index.ts"

/// What the run is doing, in one or two words.
export function runWords(state: PageState): string {
  const {run} = state
  const {doing, ended} = words
  if (state.room.lookedAt !== null) return doing.lookingBack
  if (state.clock === "standing" && isActive(run)) return doing.standing
  return run.kind === "ended" ? ended[run.how] : doing[run.kind]
}

const sentence = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

/// What the page itself has to say: first what, then what to do.
export function noticeWords(notice: Notice): {readonly message: string; readonly hint: string} {
  const w = words.notices
  switch (notice.kind) {
    case "unreadable-file":
      return {message: `${notice.name}: ${notice.message}`, hint: notice.hint}
    case "not-text":
      return {message: w.notText.message(notice.name), hint: w.notText.hint}
    case "not-program":
      return {message: w.notProgram(notice.name), hint: w.notText.hint}
    case "too-large":
      return {message: w.tooLarge.message(notice.name), hint: w.tooLarge.hint}
    case "unreadable-world":
      return {
        message: w.notWorld(notice.name),
        hint: notice.path === "" ? sentence(notice.why) : `${notice.path}: ${notice.why}`,
      }
    case "example-missing":
      return {message: w.exampleMissing.message(notice.name), hint: w.exampleMissing.hint}
    case "refusal":
      return {message: notice.message, hint: notice.hint}
    case "no-film":
      return w.noFilm
    case "no-reader":
      return w.noReader
    case "not-formatted":
      return {message: w.notFormatted.message(notice.left), hint: w.notFormatted.hint}
    case "not-saved":
      return w.notSaved
    case "robot-gone":
      return {
        message: w.robotGone.message(notice.name),
        hint: notice.why === "" ? w.robotGone.hint : notice.why,
      }
    case "out-of-sight":
      return {message: w.outOfSight.message(notice.name), hint: w.outOfSight.hint}
    case "opened-elsewhere":
      return w.openedElsewhere
  }
}

/// What a charted quantity is called; one that the program brings is its own name.
export function quantityName(key: string): string {
  const names: Readonly<Record<string, string>> = words.quantities
  return names[key] ?? key
}
