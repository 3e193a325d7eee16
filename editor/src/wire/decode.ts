/// Decoders for JSON from outside: a value of the expected type, or a sentence with the path of the mismatch (`at frame.led1: expected a number`).

/// What was wrong with a piece of JSON, and where.
export class Mismatch extends Error {
  readonly path: string
  readonly expected: string
  constructor(path: string, expected: string) {
    super(`at ${path === "" ? "the top" : path}: expected ${expected}`)
    this.path = path
    this.expected = expected
  }
}

const joined = (path: string, inner: string): string =>
  path === "" || inner === "" || inner.startsWith("[") ? path + inner : `${path}.${inner}`

/// The fault of a value that stands at `step` of `path`. Decoders of parts are given an empty path, so that paths are only put together for a mismatch.
function inside(fault: unknown, path: string, step: string): unknown {
  if (!(fault instanceof Mismatch)) return fault
  return new Mismatch(joined(path, joined(step, fault.path)), fault.expected)
}

/// Reads one value found at `path`; throws `Mismatch`, which only `decode` catches.
export type Decoder<T> = (value: unknown, path: string) => T

export type Decoded<T> = {kind: "ok"; value: T} | {kind: "mismatch"; message: string}

export function decode<T>(decoder: Decoder<T>, value: unknown): Decoded<T> {
  try {
    return {kind: "ok", value: decoder(value, "")}
  } catch (fault) {
    if (fault instanceof Mismatch) return {kind: "mismatch", message: fault.message}
    throw fault
  }
}

/// Reader of messages: the value of a text, or a mismatch.
export const readerOf =
  <T>(decoder: Decoder<T>) =>
  (text: string): Decoded<T> =>
    decode(decoder, parseJson(text))

/// The value of a JSON text, or `undefined` when it is not JSON.
export function parseJson(text: string): unknown {
  try {
    return JSON.parse(text) as unknown
  } catch {
    return undefined
  }
}

export const string: Decoder<string> = (v, path) => {
  if (typeof v !== "string") throw new Mismatch(path, "text")
  return v
}

export const number: Decoder<number> = (v, path) => {
  if (typeof v !== "number" || !Number.isFinite(v)) throw new Mismatch(path, "a number")
  return v
}

export const boolean: Decoder<boolean> = (v, path) => {
  if (typeof v !== "boolean") throw new Mismatch(path, "true or false")
  return v
}

export const unknownRecord: Decoder<Record<string, unknown>> = (v, path) => {
  if (typeof v !== "object" || v === null || Array.isArray(v)) throw new Mismatch(path, "an object")
  return v as Record<string, unknown>
}

export const list =
  <T>(item: Decoder<T>): Decoder<readonly T[]> =>
  (v, path) => {
    if (!Array.isArray(v)) throw new Mismatch(path, "a list")
    return v.map((x, i) => item(x, `${path}[${i}]`))
  }

export const oneOf =
  <T extends string>(...words: readonly T[]): Decoder<T> =>
  (v, path) => {
    const found = words.find(word => word === v)
    if (found === undefined) throw new Mismatch(path, `one of ${words.join(", ")}`)
    return found
  }

/// `absent` when the field is missing or null.
export const optional =
  <T, U>(decoder: Decoder<T>, absent: U): Decoder<T | U> =>
  (v, path) =>
    v === undefined || v === null ? absent : decoder(v, path)

/// Reads an object's fields; `get("led1", number)` names the field in a mismatch.
export const object =
  <T>(build: (get: <F>(field: string, decoder: Decoder<F>) => F) => T): Decoder<T> =>
  (v, path) => {
    const record = unknownRecord(v, path)
    return build((field, decoder) => decoder(record[field], joined(path, field)))
  }

// Decoders of the generated files beside this one.

/// Any JSON; what reads it later says what it is.
export const unknown: Decoder<unknown> = (v, path) => {
  if (v === undefined) throw new Mismatch(path, "a value")
  return v
}

export const integer: Decoder<number> = (v, path) => {
  if (!Number.isInteger(v)) throw new Mismatch(path, "a whole number")
  return v as number
}

export const numberOrString: Decoder<number | string> = (v, path) =>
  typeof v === "string" ? v : number(v, path)

/// This value only.
export const tag =
  <const T extends string | boolean>(word: T): Decoder<T> =>
  (v, path) => {
    if (v !== word) throw new Mismatch(path, JSON.stringify(word))
    return word
  }

export const nullable =
  <T>(decoder: Decoder<T>): Decoder<T | null> =>
  (v, path) =>
    v === null ? null : decoder(v, path)

/// A field that is left out when it has this value.
export const absent =
  <T>(decoder: Decoder<T>, value: T): Decoder<T> =>
  (v, path) =>
    v === undefined ? value : decoder(v, path)

/// A decoder that is defined further down, for types that contain themselves.
export const later =
  <T>(decoder: () => Decoder<T>): Decoder<T> =>
  (v, path) =>
    decoder()(v, path)

/// A decoded value as the page keeps it; `change` may throw a mismatch.
export const mapped =
  <A, B>(decoder: Decoder<A>, change: (value: A) => B): Decoder<B> =>
  (v, path) => {
    const read = decoder(v, path)
    try {
      return change(read)
    } catch (fault) {
      throw inside(fault, path, "")
    }
  }

/// What the first decoder that fits reads; the mismatch is that of the last one.
export const either =
  <A, B>(first: Decoder<A>, second: Decoder<B>): Decoder<A | B> =>
  (v, path) => {
    try {
      return first(v, path)
    } catch (fault) {
      if (fault instanceof Mismatch) return second(v, path)
      throw fault
    }
  }

/// `list` for items whose decoders give places within the item.
export const items =
  <T>(item: Decoder<T>): Decoder<readonly T[]> =>
  (v, path) => {
    if (!Array.isArray(v)) throw new Mismatch(path, "a list")
    const found = new Array<T>(v.length)
    let i = 0
    try {
      for (; i < found.length; i++) found[i] = item(v[i], "")
    } catch (fault) {
      throw inside(fault, path, `[${i}]`)
    }
    return found
  }

type DecodersOf<T> = {readonly [Field in keyof T]: Decoder<T[Field]>}

export const record =
  <T>(item: Decoder<T>): Decoder<{readonly [name: string]: T}> =>
  (value, path) => {
    const given = unknownRecord(value, path)
    const entries: [string, T][] = []
    let name = ""
    try {
      for (name of Object.keys(given)) entries.push([name, item(given[name], "")])
    } catch (fault) {
      throw inside(fault, path, name)
    }
    return Object.fromEntries(entries)
  }

/// A list of so many values, each of a type of its own.
export const tuple =
  <const T extends readonly unknown[]>(...items: DecodersOf<T>): Decoder<T> =>
  (v, path) => {
    if (!Array.isArray(v) || v.length !== items.length) throw new Mismatch(path, `a list of ${items.length}`)
    return items.map((item, i) => item(v[i], joined(path, `[${i}]`))) as unknown as T
  }

/// An object with these fields and no others. `names` says how a field is called in the message, when it is called differently there.
export function struct<T extends object>(
  fields: DecodersOf<T>,
  names: {readonly [Field in keyof T]?: string} = {},
): Decoder<T> {
  const plan = Object.entries<Decoder<unknown>>(fields).map(([field, decoder]) => ({
    field,
    name: names[field as keyof T] ?? field,
    decoder,
  }))
  // A copy has the fields in their order already, which is several times faster than to add them one after the other.
  const empty = Object.fromEntries(plan.map(({field}) => [field, undefined]))
  return (value, path) => {
    const given = unknownRecord(value, path)
    const found: Record<string, unknown> = {...empty}
    let step = ""
    try {
      for (const {field, name, decoder} of plan) {
        step = name
        found[field] = decoder(given[name], "")
      }
    } catch (fault) {
      throw inside(fault, path, step)
    }
    return found as T
  }
}

/// An object whose fields stand in a list, in this order.
export function row<T extends object>(fields: DecodersOf<T>): Decoder<T> {
  const read = struct<T>(fields)
  const names = Object.keys(fields)
  return (value, path) => {
    if (!Array.isArray(value)) throw new Mismatch(path, "a list")
    return read(Object.fromEntries(names.map((name, i) => [name, value[i]])), path)
  }
}

/// One of several kinds of messages, which differ in their `op`.
export function tagged<T extends {readonly op: string}>(
  decoders: {
    readonly [Op in T["op"]]: Decoder<Extract<T, {readonly op: Op}>>
  },
): Decoder<T> {
  const byOp = new Map<string, Decoder<T>>(Object.entries<Decoder<T>>(decoders))
  return (value, path) => {
    const {op} = unknownRecord(value, path)
    const decoder = byOp.get(string(op, joined(path, "op")))
    if (decoder === undefined)
      throw new Mismatch(joined(path, "op"), `a message this page knows, found ${JSON.stringify(op)}`)
    return decoder(value, path)
  }
}

/// A number within limits; `above` and `below` do not contain theirs.
export const within =
  (
    decoder: Decoder<number>,
    {
      min = -Infinity,
      max = Infinity,
      above = -Infinity,
      below = Infinity,
    }: {
      readonly min?: number
      readonly max?: number
      readonly above?: number
      readonly below?: number
    },
  ): Decoder<number> =>
  (v, path) => {
    const found = decoder(v, path)
    if (found < min || found > max || found <= above || found >= below)
      throw new Mismatch(path, "a number within its limits")
    return found
  }

/// A text of so many characters, or a list of so many values.
export const sized =
  <T extends string | readonly unknown[]>(
    decoder: Decoder<T>,
    {
      min = 0,
      max = Infinity,
      pattern,
    }: {readonly min?: number; readonly max?: number; readonly pattern?: RegExp},
  ): Decoder<T> =>
  (v, path) => {
    const found = decoder(v, path)
    // A text has at most as many characters as units.
    const count = typeof found === "string" && found.length > max ? [...found].length : found.length
    if (count < min || count > max) throw new Mismatch(path, "a length within its limits")
    if (pattern !== undefined && !pattern.test(String(found))) throw new Mismatch(path, `${pattern}`)
    return found
  }
