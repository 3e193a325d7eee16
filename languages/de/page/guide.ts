/// The words around the pages of the guide in German.

import type {GuideWords} from "../../en/page/guide.ts"

export const guide: GuideWords = {
  brand: "Rosy-Handbuch",
  skip: "Zum Text",
  search: "Im Handbuch suchen",
  contents: "Inhalt",
  turn: "Nächste und vorige Seite",
  before: "Zurück:",
  next: "Weiter:",
  openRosy: "Rosy öffnen",
  openProgram: "In Rosy öffnen",
  here: "Link zu diesem Abschnitt",
  pause: "Animation anhalten",
  play: "Animation abspielen",
  away: "Die Suche ist nicht da: Die Verbindung zu Rosy ist weg.",
  nothingAbout: query => `Nichts zu „${query}“. Versuche ein anderes Wort oder nur seinen Anfang.`,
  places: count => (count === 1 ? "1 Stelle" : `${count} Stellen`),
  inEnglish: "auf Englisch",
  readHere: "Diese Seite auf Deutsch",
}
