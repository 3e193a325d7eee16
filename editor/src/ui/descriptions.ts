/// Texts derived from the state, in the learner's language: status of the run, notices, names of quantities, and descriptions of the parts of a room.

import {words as robotWords} from "@rosy/codegen/words"
import type {BackpackResult, Notice, PageState} from "../state/page_state.ts"
import {isActive} from "../state/runs/run_state.ts"
import {measures, words} from "../words/index.ts"
import {worded, wordedText} from "../words/worker_sentences.ts"
import type {World, WorldGoal} from "../worlds/world.ts"
import type {Part} from "../worlds/world_parts.ts"

/// What the run is doing, in one or two words.
export function runStatus(state: PageState): string {
  const {run} = state
  const {doing, ended} = words
  if (state.room.lookedAt !== null) return doing.lookingBack
  if (state.clock === "standing" && isActive(run)) return doing.standing
  return run.kind === "ended" ? ended[run.how] : doing[run.kind]
}

const joined = (names: readonly string[]) => names.join(", ")
const sentence = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

function backpackText(result: BackpackResult): {readonly message: string; readonly hint: string} {
  const w = words.backpack
  switch (result.kind) {
    case "packed":
      return {
        message: w.packed(result.name),
        hint: result.others.length === 0 ? "" : w.cameAlong(joined(result.others)),
      }
    case "not-packed":
      return {message: w.notPacked(result.name), hint: w.notPackedHint}
    case "full":
      return {message: w.full, hint: w.fullHint}
    case "not-unpacked":
      return {message: w.notUnpacked(result.name), hint: result.why}
    case "unpacked": {
      const {added, renamed, present} = result
      const said = [
        ...(added.length > 0 && present.length > 0 ? [w.present(joined(present))] : []),
        ...renamed.map(({from, to}) => w.renamed(from, to)),
      ]
      return {
        message: added.length === 0 ? w.present(joined(present)) : w.unpacked(joined(added)),
        hint: said.join(" "),
      }
    }
  }
}

/// What the page itself has to say: first what, then what to do.
export function noticeText(notice: Notice): {readonly message: string; readonly hint: string} {
  const w = words.notices
  switch (notice.kind) {
    case "unreadable-file":
      return {message: `${notice.name}: ${notice.message}`, hint: notice.hint}
    case "not-text":
      return {message: w.notText.message(notice.name), hint: w.notText.hint}
    case "older-encoding":
      return {message: w.olderEncoding.message(notice), hint: w.olderEncoding.hint}
    case "empty-file":
      return {message: w.emptyFile.message(notice.name), hint: w.emptyFile.hint}
    case "confusable":
      return confusableText(notice)
    case "several-programs":
      return {
        message: w.severalPrograms.message(notice.name, notice.programs.length),
        hint: w.severalPrograms.hint(notice.unread),
      }
    case "no-programs":
      return {message: w.noPrograms(notice.name), hint: w.notText.hint}
    case "too-many-files":
      return {message: w.tooManyFiles.message(notice.name), hint: w.tooManyFiles.hint}
    case "damaged-archive":
      return {message: w.damagedArchive.message(notice.name), hint: w.damagedArchive.hint}
    case "not-program":
      return {message: w.notProgram(notice.name), hint: w.notText.hint}
    case "too-large":
      return {message: w.tooLarge.message(notice.name), hint: w.tooLarge.hint}
    case "unreadable-world":
      return {
        message: w.notWorld(notice.name),
        hint: notice.path === "" ? sentence(notice.why) : `${notice.path}: ${notice.why}`,
      }
    case "lesson-missing":
      return {message: words.lessons.missing(notice.name), hint: w.exampleMissing.hint}
    case "damaged-lesson":
      return {message: words.lessons.damaged(notice.name, notice.at), hint: words.lessons.damagedHint}
    case "newer-lesson":
      return {
        message: words.lessons.newer(notice.name),
        hint: words.lessons.newerHint(notice.version, notice.newest),
      }
    case "example-missing":
      return {message: w.exampleMissing.message(notice.name), hint: w.exampleMissing.hint}
    case "refusal":
      return {message: notice.message, hint: notice.hint}
    case "no-film":
      return notice.isLive ? w.noFilm : w.filmFailed
    case "backpack":
      return backpackText(notice.result)
    case "no-reader":
      return w.noReader
    case "not-formatted":
      return {message: w.notFormatted.message(notice.left), hint: w.notFormatted.hint}
    case "other-meaning":
    case "grouped-otherwise":
    case "unreadable-edit":
    case "unfinished-text":
      return editText(notice)
    case "not-saved":
      return notice.gone.length === 0
        ? w.notSaved
        : {message: w.notSaved.message, hint: `${w.madeWay.message(joined(notice.gone))} ${w.notSaved.hint}`}
    case "made-way":
      return {message: w.madeWay.message(joined(notice.gone)), hint: w.madeWay.hint}
    case "progress-not-saved":
      return w.progressNotSaved
    case "robot-gone":
      return {
        message: w.robotGone.message(notice.name),
        hint: notice.why === "" ? w.robotGone.hint : notice.why,
      }
    case "out-of-sight":
      return {message: w.outOfSight.message(notice.name), hint: w.outOfSight.hint}
    case "became-two":
      return {message: w.becameTwo.message(notice.name), hint: w.becameTwo.hint(notice.copy)}
    case "no-storage":
      return w.noStorage
    case "diverged":
      return {message: w.diverged.message(measures.seconds(notice.time, 2)), hint: w.diverged.hint}
    case "uncompared":
      return {message: w.uncompared.message(measures.seconds(notice.time, 0)), hint: w.uncompared.hint}
    case "damaged-link":
      return w.damagedLink
  }
}

/// Of an edit that was taken back, or that has to wait.
function editText({
  kind,
  names,
}: Extract<Notice, {kind: "other-meaning" | "grouped-otherwise" | "unreadable-edit" | "unfinished-text"}>): {
  readonly message: string
  readonly hint: string
} {
  const w = words.notices
  switch (kind) {
    case "other-meaning":
      return {message: w.otherMeaning.message(joined(names)), hint: w.otherMeaning.hint}
    case "grouped-otherwise":
      return {message: w.groupedOtherwise.message(joined(names)), hint: w.otherMeaning.hint}
    case "unreadable-edit":
      return {message: w.unreadableEdit.message(joined(names)), hint: w.otherMeaning.hint}
    case "unfinished-text":
      return {message: w.unfinishedText.message(joined(names)), hint: w.unfinishedText.hint}
  }
}

function confusableText({name, found}: Extract<Notice, {kind: "confusable"}>) {
  const w = words.notices.confusable
  const [first] = found
  const {id, arguments: given} = first.name
  const english = Object.entries(given).reduce((text, [key, value]) => text.replace(`{${key}}`, value), id)
  const shown = {...first, name: worded(first.name, english)}
  return {message: w.message(name, found.length, shown), hint: w.hint}
}

/// What a charted quantity is called; one that the program brings is its own name.
export function quantityName(key: string): string {
  const names: Readonly<Record<string, string>> = {...robotWords.charts, ...words.quantities}
  return names[key] ?? key
}

/// The title of a goal without its own; for an unknown kind, the kind.
export function goalTitle(kind: string): string {
  const titles: Readonly<Record<string, string>> = words.world.goals
  return titles[kind] ?? kind
}

/// The goals without a place say what is to be avoided.
const nameOfGoal = (goal: WorldGoal): string =>
  goal.title !== ""
    ? wordedText(goal.title)
    : goal.kind === "avoid" && goal.what !== "place"
      ? words.world.avoids[goal.what]
      : goalTitle(goal.kind)

/// The short name of a part.
export function nameOfPart(world: World, part: Part): string {
  const w = words.world
  switch (part.kind) {
    case "start":
      return w.start
    case "wall":
      return w.wall(part.index + 1)
    case "box":
      return world.boxes[part.index]?.unknown
        ? w.unknown(part.index + 1)
        : w.box(part.index + 1, world.boxes[part.index]?.movable ?? false)
    case "round":
      return w.round(part.index + 1, world.rounds[part.index]?.movable ?? false)
    case "line":
      return w.floorLine(part.index + 1)
    case "goal": {
      const goal = world.goals[part.index]
      return goal === undefined ? "" : nameOfGoal(goal)
    }
  }
}

/// A part in words: what it is and where, for a screen reader.
export function describePart(world: World, part: Part): string {
  const name = nameOfPart(world, part)
  const w = words.world.described
  switch (part.kind) {
    case "start":
      return w.start(name, [world.start.x, world.start.y], world.start.theta)
    case "wall": {
      const wall = world.walls[part.index]
      return wall === undefined ? "" : w.line(name, wall.from, wall.to)
    }
    case "box": {
      const box = world.boxes[part.index]
      return box === undefined ? "" : w.box(name, [box.x, box.y], [box.w, box.h], box.theta)
    }
    case "round": {
      const round = world.rounds[part.index]
      return round === undefined ? "" : w.circle(name, [round.x, round.y], round.r)
    }
    case "line":
      return w.points(name, world.lines[part.index]?.points.length ?? 0)
    case "goal": {
      const goal = world.goals[part.index]
      return goal === undefined ? "" : describeGoal(name, goal)
    }
  }
}

function describeGoal(name: string, goal: WorldGoal): string {
  const w = words.world.described
  switch (goal.kind) {
    case "lap":
      return w.line(name, goal.from, goal.to)
    case "visit":
    case "draw":
      return w.points(name, goal.points.length)
    case "avoid":
      return goal.what === "place" ? w.at(name, [goal.x, goal.y]) : name
    default:
      return w.circle(name, [goal.x, goal.y], goal.r)
  }
}
