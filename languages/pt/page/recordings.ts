/// Gravações de execuções em robôs de verdade.

import type {Words} from "../../../editor/src/words/index.ts"

export const recordings: Words["recordings"] = {
  open: "Abrir uma gravação…",
  openHint: "Uma execução em um robô de verdade, como arquivo MCAP neste computador",
  again: "Ver esta execução de novo",
  where: file => `Esta execução está gravada no computador do Rosy: ${file}`,
  run: number => `Execução ${number}, gravada`,
  on: robot => `no robô ${robot}`,
  tooLarge: name => `${name} é grande demais para a gravação de uma execução.`,
  notSent: name => `${name} não chegou ao Rosy. Tente outra vez.`,
  notConnected: "Não é possível alcançar o Rosy. Abra a gravação quando ele voltar.",
  driving: "Um robô está andando. Pare-o e depois abra a gravação.",
  refused: "O programa desta gravação é de outra versão do Rosy, por isso a execução não pode ser mostrada.",
}
