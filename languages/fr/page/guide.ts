/// The words around the pages of the guide in French.

import type {GuideWords} from "../../en/page/guide.ts"

export const guide: GuideWords = {
  brand: "Guide de Rosy",
  skip: "Au texte",
  search: "Chercher dans le guide",
  contents: "Sommaire",
  turn: "Page suivante et précédente",
  before: "Avant :",
  next: "Suite :",
  openRosy: "Ouvrir Rosy",
  openProgram: "Ouvrir dans Rosy",
  here: "Lien vers cette partie",
  pause: "Mettre l’animation en pause",
  play: "Lire l’animation",
  away: "La recherche n’est pas là : la connexion avec Rosy est perdue.",
  nothingAbout: query => `Rien sur « ${query} ». Essaie un autre mot, ou seulement son début.`,
  places: count => (count === 1 ? "1 endroit" : `${count} endroits`),
  inEnglish: "en anglais",
  readHere: "Cette page en français",
}
