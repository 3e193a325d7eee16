/// The differences between a real robot and the simulated one beside it, as one sentence.

import type {Words} from "../../words/index.ts"
import type {Measures} from "../../words/number_formats.ts"
import {type Differences, isSame} from "./differences.ts"

/// Differences that are named, the most telling first: what was felt explains where the robot went.
const mostNamed = 3

export function twinSentence(found: Differences, words: Words["twin"], measures: Measures): string {
  if (isSame(found)) return words.same(found.time)
  const {turned, drove, apart, felt} = found
  const [first] = felt
  const parts = [
    ...(turned === null ? [] : [words.turned[turned.how](measures.degrees(turned.angle))]),
    ...(drove === null ? [] : [words.drove[drove.how](distanceOf(drove.way, measures))]),
    ...(first === undefined ? [] : [words.felt[first.channel]([first.real, first.simulated])]),
    ...(apart === null ? [] : [words.apart(distanceOf(apart, measures))]),
  ]
  return words.sentence(found.time, parts.slice(0, mostNamed))
}

/// Less than a metre in whole centimetres.
const distanceOf = (metres: number, measures: Measures): string =>
  metres < 1 ? `${measures.short(100 * metres, 0)} cm` : `${measures.short(metres, 1)} m`
