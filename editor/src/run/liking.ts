/// What a reader chose once and the page must know before it can show anything: the language. And the name by which
/// others see who has a robot.

const languageKey = "rosy.language"
const nameKey = "rosy.who"

export const chosenLanguage = (): string | null => read(languageKey)

/// Chooses the language for this browser; the page speaks it after a reload.
export const chooseLanguage = (language: string): void => keep(languageKey, language)

export const ownName = (): string => read(nameKey) ?? ""
export const keepOwnName = (name: string): void => keep(nameKey, name)

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
