/// Text files of a user: bytes in, text or the reason why they are no text out. By the rules of `sim-service/rosy_sim/files.py`.

/// Where a text in an older encoding shows it.
export interface OlderEncoding {
  readonly encoding: string
  /// Counted from 1.
  readonly number: number
  readonly line: string
}

export type TextFile =
  | {readonly kind: "text"; readonly text: string}
  /// Text, but in an encoding of one byte a character; `text` is what it says if that is the encoding.
  | ({readonly kind: "older-encoding"; readonly text: string} & OlderEncoding)
  | {readonly kind: "not-text"}

const mark = "\uFEFF"

/// Reads UTF-8, and UTF-16 after a byte order mark. The text keeps its mark, for writing it back, and its line ends.
export function decodeText(bytes: Uint8Array): TextFile {
  const [first = 0, second = 0] = bytes
  const encoding =
    first === 0xff && second === 0xfe ? "utf-16le" : first === 0xfe && second === 0xff ? "utf-16be" : "utf-8"
  const text = decoded(bytes, encoding)
  if (text !== null && !text.includes("\0")) return {kind: "text", text}
  const older = text === null && encoding === "utf-8" ? olderEncoding(bytes) : null
  return older === null ? {kind: "not-text"} : {kind: "older-encoding", ...older}
}

/// The text without a byte order mark.
export function withoutMark(text: string): string {
  return text.startsWith(mark) ? text.slice(mark.length) : text
}

function decoded(bytes: Uint8Array, encoding: string): string | null {
  try {
    return new TextDecoder(encoding, {fatal: true, ignoreBOM: true}).decode(bytes)
  } catch {
    return null
  }
}

// Control characters that no editor writes into a text: all but tab, line feed, form feed and carriage return.
const noText = /[^\P{Cc}\t\n\f\r]/u

/// The bytes 0x80 to 0x9F in Windows-1252, which else is Latin-1; a control character where it has none. Node's decoder of this name reads Latin-1.
const windows1252 = "€\u0081‚ƒ„…†‡ˆ‰Š‹Œ\u008DŽ\u008F\u0090‘’“”•–—˜™š›œ\u009DžŸ"

/// `null` when a byte contradicts.
function olderEncoding(bytes: Uint8Array): (OlderEncoding & {readonly text: string}) | null {
  const text = Array.from(bytes, byte => windows1252[byte - 0x80] ?? String.fromCharCode(byte)).join("")
  if (noText.test(text)) return null
  const lines = text.split(/\r\n?|\n/)
  const number = lines.findIndex(line => /\P{ASCII}/u.test(line))
  const encoding = bytes.some(byte => byte >= 0x80 && byte < 0xa0) ? "Windows-1252" : "Latin-1"
  return {encoding, number: number + 1, line: lines[number] ?? "", text}
}
