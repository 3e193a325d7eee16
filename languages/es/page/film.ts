/// Películas de la sala.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short} = measuresOf("es")

export const film: Words["film"] = {
  webm: "Película de la ejecución (WebM)",
  gif: "Película de la ejecución (GIF)",
  making: percent => `Haciendo la película: ${percent} %`,
  faster: pace => `${short(pace, 1)} veces más rápida: una película dura un minuto como mucho.`,
  cancel: "Cancelar",
}
