/// Filme des Raums.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short} = measuresOf("de")

export const film: Words["film"] = {
  webm: "Film des Laufs (WebM)",
  gif: "Film des Laufs (GIF)",
  making: percent => `Der Film entsteht: ${percent} %`,
  faster: pace => `${short(pace, 1)}-mal so schnell: Ein Film dauert höchstens eine Minute.`,
  cancel: "Abbrechen",
}
