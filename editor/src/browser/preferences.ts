/// Preferences outside of the page's state: the language, which is needed before the page is shown, the name shown to others, and the code of the real robots.

const languageKey = "rosy.language"
const nameKey = "rosy.who"

export const chosenLanguage = (): string | null => read(languageKey)

/// Chooses the language for this browser; the page speaks it after a reload.
export const chooseLanguage = (language: string): void => keep(languageKey, language)

export const ownName = (): string => read(nameKey) ?? ""
export const setOwnName = (name: string): void => keep(nameKey, name)

function read(key: string): string | null {
  try {
    return window.localStorage.getItem(key)
  } catch {
    // A browser that forbids storage forgets.
    return null
  }
}

function keep(key: string, text: string): void {
  try {
    window.localStorage.setItem(key, text)
  } catch {
    // Full or forbidden: it is chosen again next time.
  }
}

export interface AccessCode {
  /// As the address brought it, or as it was given before; `null` when it is not known.
  read(): string | null
  keep(code: string | null): void
}

const key = "rosy.robots"

/// The address of a page may carry the code behind its hash, which the browser never sends. It is taken out of the
/// address, so that it is not in a picture of the screen or in a link that is passed on.
export function openAccessCode(window: Window): AccessCode {
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

/// The code of the class, which the QR code of the teacher's terminal puts behind the hash of the address; empty if there is none. It is taken out of the address.
export function takeClassCode(window: Window): string {
  const code = new URLSearchParams(window.location.hash.slice(1)).get("class")
  if (code === null) return ""
  window.history.replaceState(null, "", window.location.pathname + window.location.search)
  return code
}
