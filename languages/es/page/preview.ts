/// The preview of a change in Spanish: where the robot would drive.

import type {Words} from "../../../editor/src/words/index.ts"

export const preview: Words["preview"] = {
  dragNumber: "Arrastra para cambiar el número",
  show: "Mostrar a dónde lleva un cambio",
  sentence: what => `Con este cambio, el robot ${what}.`,
  and: (first, second) => `${first} y ${second}`,
  samePlace: "terminaría en el mismo lugar",
  samePlaceAt: time => `estaría en el mismo lugar a los ${time}`,
  end: where => `terminaría ${where}`,
  beAt: (where, time) => `estaría ${where} a los ${time}`,
  further: (distance, side) => `${distance} más ${side}`,
  sides: {
    left: "a la izquierda",
    right: "a la derecha",
    up: "arriba",
    down: "abajo",
    "up left": "arriba a la izquierda",
    "up right": "arriba a la derecha",
    "down left": "abajo a la izquierda",
    "down right": "abajo a la derecha",
  },
  bump: n => (n === 1 ? "chocaría una vez" : n === 2 ? "chocaría dos veces" : `chocaría ${n} veces`),
  goals: (done, all) => (all === 1 ? "lograría el objetivo" : `lograría ${done} de ${all} objetivos`),
  noGoal: all => (all === 1 ? "no lograría el objetivo" : "no lograría ningún objetivo"),
  unrepeatable:
    "En esta ejecución se movieron demasiadas cosas a mano para mostrar a dónde lleva un cambio. Ejecuta otra vez.",
  /// The preview is shorter than the run.
  cut: time => `Solo se muestran los primeros ${time}: calcular más lleva demasiado tiempo.`,
  fails: time => `se pararía con un error a los ${time}`,
  fixes: "Formas de arreglarlo",
  outcome: {
    trembles: n => `tiembla contra la pared: choca ${n} veces`,
    stands: "se queda quieto",
    turns: "gira sin moverse del sitio",
    drives: distance => `avanza ${distance} sin chocar`,
    bumps: n => (n === 1 ? "choca una vez" : `choca ${n} veces`),
    stays: "se queda ahí",
    onward: {
      left: "sigue hacia la izquierda",
      right: "sigue hacia la derecha",
      up: "sigue hacia arriba",
      down: "sigue hacia abajo",
    },
    goals: n => (n === 1 ? "logra un objetivo" : `logra ${n} objetivos`),
    fails: time => `se detiene con un error después de ${time}`,
    noBetter: "no es mejor que ahora",
    trying: "se está probando…",
  },
  noneBetter: "Rosy ha probado el arreglo preparado en esta sala: no es mejor.",
}
