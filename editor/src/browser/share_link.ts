/// Links that contain a whole program or lesson: the file, compressed (zlib) and in base64url, after `#program=` or `#lesson=`. A browser sends nothing after `#`
/// to a server.
///
/// zlib ends with a checksum of the content, so a link that lost or changed a letter is recognised as damaged.

export type LinkedProgram =
  /// The address contains no program.
  {readonly kind: "none"} | {readonly kind: Linked; readonly text: string} | {readonly kind: "damaged"}

/// What a link may contain.
type Linked = "program" | "lesson"

const prefixes: {readonly [kind in Linked]: string} = {program: "#program=", lesson: "#lesson="}

/// Bytes of a project file that a link may unfold to: as much as a file may have (`local_files.ts`).
const mostBytes = 20_000_000

/// What follows the page's address in a link to a project file or a lesson.
export async function fragmentOf(json: string, kind: Linked = "program"): Promise<string> {
  const bytes = new TextEncoder().encode(compact(json))
  const packed = await collect(through(bytes, new CompressionStream("deflate")), Number.POSITIVE_INFINITY)
  return prefixes[kind] + toBase64Url(packed ?? new Uint8Array())
}

export async function programIn(fragment: string): Promise<LinkedProgram> {
  const kind = (["program", "lesson"] as const).find(one => fragment.startsWith(prefixes[one]))
  if (kind === undefined) return {kind: "none"}
  const packed = fromBase64Url(fragment.slice(prefixes[kind].length))
  if (packed === null || packed.length === 0) return {kind: "damaged"}
  // Damaged input is the only cause of a failure here: the bytes are in memory.
  const bytes = await collect(through(packed, new DecompressionStream("deflate")), mostBytes).catch(
    () => null,
  )
  return bytes === null ? {kind: "damaged"} : {kind, text: new TextDecoder().decode(bytes)}
}

/// The same JSON without the spaces that make a file readable. A text that is none stays as it is: the page that opens the link says what is wrong with it.
function compact(json: string): string {
  try {
    return JSON.stringify(JSON.parse(json))
  } catch {
    return json
  }
}

function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): ReadableStream<Uint8Array> {
  return new Blob([bytes]).stream().pipeThrough<Uint8Array>(stream)
}

/// All bytes of a stream; `null` when there are more than `most`.
async function collect(
  stream: ReadableStream<Uint8Array>,
  most: number,
): Promise<Uint8Array<ArrayBuffer> | null> {
  const reader = stream.getReader()
  const chunks: Uint8Array[] = []
  let length = 0
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    chunks.push(next.value)
    length += next.value.length
    if (length > most) {
      await reader.cancel()
      return null
    }
  }
  const all = new Uint8Array(length)
  let at = 0
  for (const chunk of chunks) {
    all.set(chunk, at)
    at += chunk.length
  }
  return all
}

function toBase64Url(bytes: Uint8Array): string {
  // `fromCharCode` takes its bytes as arguments, of which there is a limit.
  let binary = ""
  for (let at = 0; at < bytes.length; at += 8192)
    binary += String.fromCharCode(...bytes.subarray(at, at + 8192))
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")
}

/// RFC 4648 §5; `null` for what is not base64url.
function fromBase64Url(text: string): Uint8Array<ArrayBuffer> | null {
  if (!/^[\w-]*$/.test(text) || text.length % 4 === 1) return null
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"))
  return Uint8Array.from(binary, letter => letter.charCodeAt(0))
}
