/// Turns of the stories: most files are played on one day in nineteen, and nightly.
///
/// In: the daily seed. Out: Playwright's function for stories, or one that declares none. A file that has changed since all suites last passed
/// (`ROSY_TEST_CHANGED`, set by `scripts/test.py`) is played as well, and so is every file where there is no daily seed: stories started by hand. A file that is in no turn, and what a file declares with `daily`, is played each day: the
/// first minutes, and the main paths of text, blocks and robots. The main paths of the other parts are played every fourth day, and after any change of the page or of the service.

import {basename} from "node:path"
import {fileURLToPath} from "node:url"
import {isFull, seed} from "./extent.ts"

/// Files that take turns, by day, without `.spec.ts`. The number of days is prime, so that each row of
/// a table within a file (`rotated`), which has fewer parts, meets the day of its file.
export const turns: readonly (readonly string[])[] = [
  ["text"],
  ["ros", "values-in-place"],
  ["diagram", "touch"],
  ["haste", "language"],
  ["building", "continue"],
  ["class-of-thirty", "worker"],
  ["runs", "safety"],
  ["class-together"],
  ["room", "why"],
  ["leaving", "looks", "own-lessons"],
  ["class", "lessons"],
  ["edit-to-path", "preview", "screens", "values"],
  ["arrange", "careless", "sharing"],
  ["class-sharing", "first-minute"],
  ["my-programs", "problems"],
  ["class-hostile", "lesson-editor", "many-rooms"],
  ["robots"],
  ["mixed-steps", "words"],
  ["sight", "why-questions"],
]

/// Part of a run that decides which files are played.
export interface Day {
  readonly isFull: boolean
  readonly seed: number
  /// Paths from the root of the repository.
  readonly changed: readonly string[]
}

const today: Day = {
  isFull: isFull || process.env["ROSY_TEST_SEED"] === undefined,
  seed,
  changed: (process.env["ROSY_TEST_CHANGED"] ?? "").split("\n"),
}

/// Whether a file of stories, by its name without `.spec.ts`, is played on a day.
export function isPlayed(name: string, day: Day): boolean {
  const own = turns.findIndex(names => names.includes(name))
  if (own < 0) throw new Error(`${name}.spec.ts has no day in turns.ts`)
  return (
    day.isFull || day.seed % turns.length === own || day.changed.includes(`e2e-tests/stories/${name}.spec.ts`)
  )
}

/// Sources of the page and of its service.
const sources = ["codegen/src/", "editor/src/", "sim-service/rosy_sim/"]

/// The days of main paths that are played every fourth day, by the rest of the seed.
export type Fourth = 0 | 1 | 2 | 3

/// Whether what is played every fourth day is played on a day. It is played with the whole of its file as well.
export function isPlayedEveryFourth(fourth: Fourth, name: string, day: Day): boolean {
  const isItsDay = day.seed % 4 === fourth
  return (
    isItsDay ||
    isPlayed(name, day) ||
    day.changed.some(path => sources.some(folder => path.startsWith(folder)))
  )
}

/// The function for main paths that are played every fourth day.
export function everyFourthDay<Story extends (...story: never[]) => void>(
  fourth: Fourth,
  story: Story,
  url: string,
): Story {
  return isPlayedEveryFourth(fourth, nameOf(url), today) ? story : without(story)
}

/// The function `test` for the file at `url`, if that is played today; else the same with its hooks and groups, but without stories.
export function inTurn<Story extends (...story: never[]) => void>(story: Story, url: string): Story {
  return isPlayed(nameOf(url), today) ? story : without(story)
}

const nameOf = (url: string): string => basename(fileURLToPath(url), ".spec.ts")

/// With its hooks and groups.
function without<Story extends (...story: never[]) => void>(story: Story): Story {
  return Object.assign((() => undefined) as unknown as Story, story)
}
