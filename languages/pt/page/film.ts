/// Filmes da sala.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short} = measuresOf("pt-BR")

export const film: Words["film"] = {
  webm: "Filme da execução (WebM)",
  gif: "Filme da execução (GIF)",
  making: percent => `Fazendo o filme: ${percent}%`,
  faster: pace => `${short(pace, 1)} vezes mais rápido: um filme dura no máximo um minuto.`,
  cancel: "Cancelar",
}
