/// The choices of a new learner, and the demonstration in Spanish.

import type {Words} from "../../../editor/src/words/index.ts"

export const welcome: Words["welcome"] = {
  title: "¿Cómo quieres empezar?",
  show: {name: "Enséñame", description: "Mira cómo se construye un programa: 20 segundos."},
  lesson: {name: "Lección 1", description: "Hazlo tú, paso a paso."},
  example: {name: "Empezar con un ejemplo", description: "Abre un programa que funciona y cámbialo."},
  empty: {name: "Programa vacío", description: "Construye algo tuyo."},
  demonstration: "Enséñame",
  steps: [
    "Este es un programa vacío. simular ejecuta lo que se pone dentro.",
    "Un bloque dice a qué velocidad ir: Velocity, 0.3 metros por segundo. A la derecha está en Haskell.",
    "Ahora está dentro de simular, así que se ejecutará.",
    "Ejecutar: el robot avanza.",
    "Otro número: ahora también gira y va en círculo.",
  ],
  stop: "Dejar de enseñar",
}
