/// Retos: su lista y las estrellas de un intento.

import type {Words} from "../../../editor/src/words/index.ts"

export const challenges: Words["challenges"] = {
  title: "Retos",
  lead: "Una meta, hasta tres estrellas. Cuenta tu mejor intento.",
  loading: "Buscando los retos…",
  failed:
    "No se han podido cargar los retos. El servicio de Rosy no responde; inténtalo otra vez en un momento.",
  number: n => `Reto ${n}`,
  leave: "Salir del reto",
  stars: (earned, all) => `Estrellas: ${earned} de ${all}`,
  best: "Tu mejor intento:",
  thisRun: (earned, all) => `Este intento: ${earned} de ${all} estrellas.`,
  allStars: "¡Las tienes todas!",
  /// `text` is what is missing, as the challenge says it.
  next: text => `Para otra estrella: ${text}.`,
  nextChallenge: "Siguiente reto",
}
