/// Encoder of the page's requests.

/// The request as JSON that every reader takes. A lone half of a surrogate pair, which a file can contain, is no character: it is sent as U+FFFD, which has its length,
/// so that places in a text stay the same (The Unicode Standard, section 3.9).
export function encodeRequest(request: unknown): string {
  const json = JSON.stringify(request)
  // JSON.stringify escapes such halves only.
  return /\\ud[89a-f]/.test(json)
    ? JSON.stringify(request, (_, value) =>
        typeof value === "string" ? value.replace(/\p{Surrogate}/gu, "\uFFFD") : value,
      )
    : json
}
