/// Ein echter Roboter und dasselbe Programm daneben im Simulator.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds} = measuresOf("de")
const list = new Intl.ListFormat("de")
const at = (time: number | null) => (time === null ? "nie" : `nach ${seconds(time, 1)}`)

export const twin: Words["twin"] = {
  show: "Simulator daneben",
  hint: "Dasselbe Programm fährt auch den simulierten Roboter im gewählten Raum: beide Wege, Kurven, und was anders war",
  real: n => `Lauf ${n}, echt`,
  simulated: n => `Lauf ${n}, simuliert`,
  names: {real: "echt", simulated: "simuliert"},
  sentence: (time, what) => `Nach ${seconds(time, 1)}: Der echte Roboter ${list.format(what)}.`,
  same: time => `Nach ${seconds(time, 1)}: Der echte Roboter und der simulierte taten dasselbe.`,
  turned: {
    more: angle => `drehte sich ${angle} mehr`,
    less: angle => `drehte sich ${angle} weniger`,
    left: angle => `drehte sich ${angle} weiter nach links`,
    right: angle => `drehte sich ${angle} weiter nach rechts`,
  },
  drove: {further: way => `fuhr ${way} weiter`, less: way => `fuhr ${way} weniger`},
  apart: way => `war ${way} vom simulierten entfernt`,
  felt: {
    Bumper: ([real, simulated]) => `stieß ${at(real)} mit der Stoßstange an, der simulierte ${at(simulated)}`,
    Cliff: ([real, simulated]) => `kam ${at(real)} an eine Kante, der simulierte ${at(simulated)}`,
    Wheel: ([real, simulated]) => `hatte ${at(real)} ein Rad in der Luft, der simulierte ${at(simulated)}`,
  },
}
