/// The words around the pages of the guide in Portuguese.

import type {GuideWords} from "../../en/page/guide.ts"

export const guide: GuideWords = {
  brand: "Guia do Rosy",
  skip: "Ir ao texto",
  search: "Procurar no guia",
  contents: "Conteúdo",
  turn: "Página seguinte e anterior",
  before: "Antes:",
  next: "Depois:",
  openRosy: "Abrir o Rosy",
  openProgram: "Abrir no Rosy",
  here: "Link para esta parte",
  pause: "Pausar a animação",
  play: "Reproduzir a animação",
  away: "A busca não está disponível: a conexão com o Rosy caiu.",
  nothingAbout: query => `Nada sobre “${query}”. Tente outra palavra, ou só o começo dela.`,
  places: count => (count === 1 ? "1 lugar" : `${count} lugares`),
  inEnglish: "em inglês",
  readHere: "Esta página em português",
}
