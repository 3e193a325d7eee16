/// Películas de la sala.

import type {Words} from "../index.ts"
import {measuresOf} from "../number_formats.ts"

const {short} = measuresOf("es")

export const film: Words["film"] = {
  webm: "Película de la ejecución (WebM)",
  gif: "Película de la ejecución (GIF)",
  making: percent => `Haciendo la película: ${percent} %`,
  faster: pace => `${short(pace, 1)} veces más rápida: una película dura un minuto como mucho.`,
  cancel: "Cancelar",
}
