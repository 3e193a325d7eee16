/// Grabaciones de ejecuciones en robots de verdad.

import type {Words} from "../../../editor/src/words/index.ts"

export const recordings: Words["recordings"] = {
  open: "Abrir una grabación…",
  openHint: "Una ejecución en un robot de verdad, como archivo MCAP de este ordenador",
  again: "Ver otra vez esta ejecución",
  where: file => `Esta ejecución está grabada en el ordenador de Rosy: ${file}`,
  run: number => `Ejecución ${number}, grabada`,
  on: robot => `en el robot ${robot}`,
  tooLarge: name => `${name} es demasiado grande para ser la grabación de una ejecución.`,
  notSent: name => `${name} no ha llegado a Rosy. Inténtalo otra vez.`,
  notConnected: "No se puede llegar a Rosy. Abre la grabación cuando vuelva.",
  driving: "Un robot está en marcha. Páralo y abre entonces la grabación.",
  refused:
    "El programa de esta grabación es de otra versión de Rosy, por eso no se puede mostrar la ejecución.",
}
