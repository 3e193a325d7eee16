/// The comparison of a preview with the run, as a sentence.

import type {words as english} from "../../words/index.ts"
import type {Measures} from "../../words/number_formats.ts"
import type {Comparison} from "./comparison.ts"

export function previewSentence(
  {moved, at, bumps, goals, fails, cut}: Comparison,
  words: (typeof english)["preview"],
  measures: Measures,
): string {
  const time = at === null ? null : measures.seconds(at, 1)
  const where =
    moved === null ? null : words.further(distanceOf(moved.distance, measures), words.sides[moved.side])
  const parts = [
    fails !== null
      ? words.fails(measures.seconds(fails, 1))
      : where === null
        ? time === null
          ? words.samePlace
          : words.samePlaceAt(time)
        : time === null
          ? words.end(where)
          : words.beAt(where, time),
  ]
  if (bumps > 0) parts.push(words.bump(bumps))
  if (goals.all > 0) parts.push(goals.done > 0 ? words.goals(goals.done, goals.all) : words.noGoal(goals.all))
  const [first = "", ...more] = parts
  const sentence = words.sentence(more.reduce((all, part) => words.and(all, part), first))
  return cut === null ? sentence : `${sentence} ${words.cut(measures.seconds(cut, 1))}`
}

/// Less than a metre in whole centimetres.
export const distanceOf = (metres: number, measures: Measures): string =>
  metres < 1 ? `${measures.short(100 * metres, 0)} cm` : `${measures.short(metres, 1)} m`
