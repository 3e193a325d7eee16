/// Messages made by hand for the topics that a program takes (language rule R23). Pure.

type Json = number | boolean | string | readonly Json[] | {readonly [name: string]: Json}

/// The message with these texts in these fields: numbers, truth values and lists as such, anything else as text.
export function messageOf(texts: readonly (readonly [path: string, text: string])[]): {
  readonly [name: string]: Json
} {
  return texts.reduce<{readonly [name: string]: Json}>(
    (message, [path, text]) => placed(message, path.split("."), readValue(text)),
    {},
  )
}

function placed(
  into: {readonly [name: string]: Json},
  [name = "", ...rest]: readonly string[],
  value: Json,
): {readonly [name: string]: Json} {
  if (rest.length === 0) return {...into, [name]: value}
  const inner = into[name]
  const record = typeof inner === "object" && !Array.isArray(inner) ? inner : {}
  return {...into, [name]: placed(record as {readonly [name: string]: Json}, rest, value)}
}

function readValue(text: string): Json {
  const trimmed = text.trim()
  if (trimmed === "") return 0
  try {
    return JSON.parse(trimmed) as Json
  } catch {
    return text
  }
}
