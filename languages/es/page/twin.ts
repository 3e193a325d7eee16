/// Un robot de verdad y el mismo programa al lado en el simulador.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds} = measuresOf("es")
const list = new Intl.ListFormat("es")
const at = (time: number | null) => (time === null ? "nunca" : `a los ${seconds(time, 1)}`)

export const twin: Words["twin"] = {
  show: "Simulador al lado",
  hint: "El mismo programa conduce también el robot simulado en la sala elegida: los dos caminos, las curvas y qué fue distinto",
  real: n => `Ejecución ${n}, de verdad`,
  simulated: n => `Ejecución ${n}, simulada`,
  names: {real: "de verdad", simulated: "simulado"},
  sentence: (time, what) => `Tras ${seconds(time, 1)}: el robot de verdad ${list.format(what)}.`,
  same: time => `Tras ${seconds(time, 1)}: el robot de verdad y el simulado hicieron lo mismo.`,
  turned: {
    more: angle => `giró ${angle} más`,
    less: angle => `giró ${angle} menos`,
    left: angle => `giró ${angle} más a la izquierda`,
    right: angle => `giró ${angle} más a la derecha`,
  },
  drove: {further: way => `avanzó ${way} más`, less: way => `avanzó ${way} menos`},
  apart: way => `estaba a ${way} del simulado`,
  felt: {
    Bumper: ([real, simulated]) => `tocó con el parachoques ${at(real)} (el simulado, ${at(simulated)})`,
    Cliff: ([real, simulated]) => `llegó a un borde ${at(real)} (el simulado, ${at(simulated)})`,
    Wheel: ([real, simulated]) => `tuvo una rueda en el aire ${at(real)} (el simulado, ${at(simulated)})`,
  },
}
