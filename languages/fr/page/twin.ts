/// Un vrai robot et le même programme à côté dans le simulateur.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds} = measuresOf("fr")
const list = new Intl.ListFormat("fr")
const at = (time: number | null) => (time === null ? "jamais" : `à ${seconds(time, 1)}`)

export const twin: Words["twin"] = {
  show: "Simulateur à côté",
  hint: "Le même programme conduit aussi le robot simulé dans la salle choisie : les deux chemins, les courbes et ce qui était différent",
  real: n => `Exécution ${n}, réelle`,
  simulated: n => `Exécution ${n}, simulée`,
  names: {real: "réel", simulated: "simulé"},
  sentence: (time, what) => `Après ${seconds(time, 1)} : le vrai robot ${list.format(what)}.`,
  same: time => `Après ${seconds(time, 1)} : le vrai robot et le robot simulé ont fait la même chose.`,
  turned: {
    more: angle => `a tourné de ${angle} de plus`,
    less: angle => `a tourné de ${angle} de moins`,
    left: angle => `a tourné de ${angle} de plus vers la gauche`,
    right: angle => `a tourné de ${angle} de plus vers la droite`,
  },
  drove: {further: way => `a roulé ${way} de plus`, less: way => `a roulé ${way} de moins`},
  apart: way => `était à ${way} du robot simulé`,
  felt: {
    Bumper: ([real, simulated]) => `a heurté quelque chose : ${at(real)} (le simulé : ${at(simulated)})`,
    Cliff: ([real, simulated]) => `est arrivé à un bord : ${at(real)} (le simulé : ${at(simulated)})`,
    Wheel: ([real, simulated]) => `a eu une roue en l’air : ${at(real)} (le simulé : ${at(simulated)})`,
  },
}
