/// Films de la salle.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short} = measuresOf("fr")

export const film: Words["film"] = {
  webm: "Film de l’exécution (WebM)",
  gif: "Film de l’exécution (GIF)",
  making: percent => `Le film se fait : ${percent} %`,
  faster: pace => `${short(pace, 1)} fois plus vite : un film dure une minute au plus.`,
  cancel: "Annuler",
}
