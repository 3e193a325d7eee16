/// Decoders for JSON from outside: a value of the expected type, or a sentence with the path of the mismatch (`at frame.led1: expected a number`).

/// What was wrong with a piece of JSON, and where.
export class Mismatch extends Error {
  readonly path: string
  constructor(path: string, expected: string) {
    super(`at ${path === "" ? "the top" : path}: expected ${expected}`)
    this.path = path
  }
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
    return build((field, decoder) => decoder(record[field], path === "" ? field : `${path}.${field}`))
  }
