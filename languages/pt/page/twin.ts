/// Um robô de verdade e o mesmo programa ao lado no simulador.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds} = measuresOf("pt")
const list = new Intl.ListFormat("pt")
const at = (time: number | null) => (time === null ? "nunca" : `aos ${seconds(time, 1)}`)

export const twin: Words["twin"] = {
  show: "Simulador ao lado",
  hint: "O mesmo programa também dirige o robô simulado na sala escolhida: os dois caminhos, as curvas e o que foi diferente",
  real: n => `Execução ${n}, real`,
  simulated: n => `Execução ${n}, simulada`,
  names: {real: "real", simulated: "simulado"},
  sentence: (time, what) => `Após ${seconds(time, 1)}: o robô de verdade ${list.format(what)}.`,
  same: time => `Após ${seconds(time, 1)}: o robô de verdade e o simulado fizeram o mesmo.`,
  turned: {
    more: angle => `girou ${angle} a mais`,
    less: angle => `girou ${angle} a menos`,
    left: angle => `girou ${angle} a mais para a esquerda`,
    right: angle => `girou ${angle} a mais para a direita`,
  },
  drove: {further: way => `andou ${way} a mais`, less: way => `andou ${way} a menos`},
  apart: way => `estava a ${way} do simulado`,
  felt: {
    Bumper: ([real, simulated]) => `bateu com o para-choque ${at(real)} (o simulado, ${at(simulated)})`,
    Cliff: ([real, simulated]) => `chegou a uma borda ${at(real)} (o simulado, ${at(simulated)})`,
    Wheel: ([real, simulated]) => `ficou com uma roda no ar ${at(real)} (o simulado, ${at(simulated)})`,
  },
}
