/// What a browser remembers about real robots until its tab is closed: the code that opens them.

export interface Code {
  /// As the address brought it, or as it was given before; `null` when it is not known.
  read(): string | null
  keep(code: string | null): void
}

const key = "rosy.robots"

/// The address of a page may carry the code behind its hash, which the browser sends to nobody. It is taken out of the
/// address, so that it is not in a picture of the screen or in a link that is passed on.
export function openCode(window: Window): Code {
  const brought = new URLSearchParams(window.location.hash.slice(1)).get("robots")
  if (brought !== null)
    window.history.replaceState(null, "", window.location.pathname + window.location.search)
  return {
    read() {
      if (brought !== null) return brought
      try {
        return window.sessionStorage.getItem(key)
      } catch {
        // A browser that forbids storage asks for the code again.
        return null
      }
    },
    keep(code) {
      try {
        if (code === null) window.sessionStorage.removeItem(key)
        else window.sessionStorage.setItem(key, code)
      } catch {
        // Full or forbidden: the code is asked for again after a reload.
      }
    },
  }
}
