/// Varios robots en una sala.

import type {Words} from "../../../editor/src/words/index.ts"

export const companions: Words["companions"] = {
  more: "Más robots",
  hint: "Hasta tres robots más en esta sala, cada uno con su propio programa. Chocan entre sí.",
  lead: "Cada uno se mueve con su propio programa; se ven y chocan entre sí. Arrástralos a su lugar en la sala. Empiezan con la próxima ejecución.",
  about: "El rastro, el lápiz, las curvas y las preguntas de por qué son sobre el primer robot.",
  none: "El primer robot está solo en esta sala.",
  robot: n => `Robot ${n}`,
  one: "Un robot más",
  program: n => `Programa del robot ${n}`,
  openProgram: "El programa abierto",
  takeAway: n => `Quitar el robot ${n}`,
  place: n => `Lugar del robot ${n}`,
  full: most => `Puede haber como mucho ${most} robots más.`,
  noPlace: "En esta sala no hay suelo libre para un robot más.",
  taken: "Ahí no hay sitio para un robot. Se queda donde estaba.",
  said: (n, text) => `Robot ${n}: ${text}`,
  ended: n => `El robot ${n} ha terminado su programa y está quieto.`,
  failed: (n, why) => `El robot ${n} está quieto: ${why}`,
  noPreview:
    "Con más robots en la sala no hay vista previa: el camino de cada uno depende de los demás. Pulsa Ejecutar.",
}
