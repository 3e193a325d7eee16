/// Vários robôs em uma sala.

import type {Words} from "../../../editor/src/words/index.ts"

export const companions: Words["companions"] = {
  more: "Mais robôs",
  hint: "Até três robôs a mais nesta sala, cada um com seu próprio programa. Eles batem uns nos outros.",
  lead: "Cada um anda com seu próprio programa; eles se veem e batem uns nos outros. Arraste-os para seus lugares na sala. Eles começam com a próxima execução.",
  about: "O rastro, a caneta, as curvas e as perguntas de por quê são sobre o primeiro robô.",
  none: "O primeiro robô está sozinho nesta sala.",
  robot: n => `Robô ${n}`,
  one: "Mais um robô",
  program: n => `Programa do robô ${n}`,
  openProgram: "O programa aberto",
  takeAway: n => `Tirar o robô ${n}`,
  place: n => `Lugar do robô ${n}`,
  full: most => `Pode haver no máximo ${most} robôs a mais.`,
  noPlace: "Nesta sala não há chão livre para mais um robô.",
  taken: "Ali não há espaço para um robô. Ele fica onde estava.",
  said: (n, text) => `Robô ${n}: ${text}`,
  ended: n => `O robô ${n} terminou seu programa e está parado.`,
  failed: (n, why) => `O robô ${n} está parado: ${why}`,
  noPreview:
    "Com mais robôs na sala não há prévia: o caminho de cada um depende dos outros. Aperte Executar.",
}
