/// The words around the pages of the guide in Spanish.

import type {GuideWords} from "../../en/page/guide.ts"

export const guide: GuideWords = {
  brand: "Guía de Rosy",
  skip: "Al texto",
  search: "Buscar en la guía",
  contents: "Contenido",
  turn: "Página siguiente y anterior",
  before: "Antes:",
  next: "Después:",
  openRosy: "Abrir Rosy",
  openProgram: "Abrir en Rosy",
  here: "Enlace a esta parte",
  pause: "Pausar la animación",
  play: "Reproducir la animación",
  away: "La búsqueda no está: se perdió la conexión con Rosy.",
  nothingAbout: query => `Nada sobre «${query}». Prueba con otra palabra, o solo con su comienzo.`,
  places: count => (count === 1 ? "1 lugar" : `${count} lugares`),
  inEnglish: "en inglés",
  readHere: "Esta página en español",
}
