/// Missionen: ihre Liste und die Sterne eines Laufs.

import type {Words} from "../../../editor/src/words/index.ts"

export const challenges: Words["challenges"] = {
  title: "Missionen",
  lead: "Ein Ziel, bis zu drei Sterne. Dein bester Lauf zählt.",
  loading: "Die Missionen werden geholt …",
  failed:
    "Die Missionen konnten nicht geladen werden. Rosys Dienst antwortet nicht; versuche es gleich noch einmal.",
  number: n => `Mission ${n}`,
  leave: "Mission verlassen",
  stars: (earned, all) => `${earned} von ${all} Sternen`,
  best: "Dein bester Lauf:",
  thisRun: (earned, all) => `Dieser Lauf: ${earned} von ${all} Sternen.`,
  allStars: "Das sind alle!",
  /// `text` is what is missing, as the challenge says it.
  next: text => `Für noch einen Stern: ${text}.`,
  nextChallenge: "Nächste Mission",
}
