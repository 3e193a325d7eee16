/// Fuzzer of JSON: seeds with structural faults (a value is replaced, dropped, repeated, renamed, nested) and faults in the text (cut, changed, doubled).

/// Random numbers from a seed (mulberry32), so that a case can be repeated.
export class Dice {
  #state: number
  constructor(seed: number) {
    this.#state = seed >>> 0
  }
  /// At least 0, below `most`.
  below(most: number): number {
    this.#state = (this.#state + 0x6d2b79f5) >>> 0
    let t = this.#state
    t = Math.imul(t ^ (t >>> 15), t | 1)
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61)
    return Math.floor((((t ^ (t >>> 14)) >>> 0) / 4294967296) * most)
  }
  of<T>(rows: readonly T[]): T {
    return rows[this.below(rows.length)] as T
  }
}

type Json = unknown
type Holder = {[key: string]: Json} | Json[]

const hostile: readonly (() => Json)[] = [
  () => null,
  () => true,
  () => [],
  () => ({}),
  () => [[[]]],
  () => "",
  () => "\0",
  () => "\uD800",
  () => "\u202Eevil",
  () => "<img src=x onerror=alert(1)>",
  () => "__proto__",
  () => "main = simulate (Velocity 0.1 0)",
  () => "x".repeat(3000),
  () => 0,
  () => -1,
  () => 0.5,
  () => 1e308,
  () => -1e308,
  () => 2 ** 53 + 2,
  () => 4294967296,
  () => Array.from({length: 500}, () => 0),
  () => JSON.parse(`${"[".repeat(300)}${"]".repeat(300)}`) as Json,
]

function places(value: Json, found: [Holder, string][], most = 400): void {
  if (typeof value !== "object" || value === null) return
  for (const key of Object.keys(value)) {
    if (found.length >= most) return
    found.push([value as Holder, key])
    places((value as {[key: string]: Json})[key], found, most)
  }
}

function damage(value: Json, dice: Dice): Json {
  const found: [Holder, string][] = []
  places(value, found)
  if (found.length === 0) return dice.of(hostile)()
  const [holder, key] = dice.of(found)
  const record = holder as {[key: string]: Json}
  switch (dice.below(7)) {
    case 0:
    case 1:
      record[key] = dice.of(hostile)()
      break
    case 2:
      if (Array.isArray(holder)) holder.splice(Number(key), 1)
      else delete record[key]
      break
    case 3: {
      const [other, place] = dice.of(found)
      record[key] = structuredClone((other as {[key: string]: Json})[place])
      break
    }
    case 4:
      if (Array.isArray(holder))
        holder.splice(
          Number(key),
          0,
          ...Array.from({length: dice.of([1, 2, 300])}, () => holder[Number(key)]),
        )
      else record[dice.of([`${key}s`, "", "op", "constructor", "toString"])] = record[key]
      break
    case 5:
      for (let times = dice.of([1, 2, 10]); times > 0; times--)
        record[key] = dice.below(2) === 0 ? [record[key]] : {a: record[key]}
      break
    default:
      record[key] = dice.below(2) === 0 ? (JSON.stringify(record[key]) ?? "") : [record[key]]
  }
  return value
}

function damagedText(text: string, dice: Dice): string {
  const at = dice.below(text.length + 1)
  const end = Math.min(text.length, at + dice.of([1, 2, 8, 64]))
  switch (dice.below(6)) {
    case 0:
      return text.slice(0, at)
    case 1:
      return (
        text.slice(0, at) +
        dice.of(["\0", "\uFEFF", "\uD800", '"', "{", "[", "]", "1e999", "\\"]) +
        text.slice(at)
      )
    case 2:
      return text.slice(0, at) + text.slice(end)
    case 3:
      return text.slice(0, at) + text.slice(at, end).repeat(dice.of([2, 3, 100])) + text.slice(end)
    case 4:
      return text.slice(0, at) + dice.of(["[", '{"a":']).repeat(dice.of([50, 400])) + text.slice(at)
    default:
      return text + text
  }
}

/// A seed with up to three structural faults; one in five with faults in its text as well.
export function fuzzed(seeds: readonly Json[], dice: Dice): string {
  let value = structuredClone(dice.of(seeds))
  for (let faults = dice.of([0, 1, 1, 1, 2, 3]); faults > 0; faults--) value = damage(value, dice)
  const text = JSON.stringify(value) ?? ""
  return dice.below(5) === 0 ? damagedText(text, dice) : text
}
