/// The choices of a new learner, and the demonstration in Portuguese.

import type {Words} from "../../../editor/src/words/index.ts"

export const welcome: Words["welcome"] = {
  title: "Como você quer começar?",
  show: {name: "Mostre para mim", description: "Veja um programa ser montado: 20 segundos."},
  lesson: {name: "Lição 1", description: "Faça você mesmo, passo a passo."},
  example: {name: "Começar com um exemplo", description: "Abra um programa que funciona e mude."},
  empty: {name: "Programa vazio", description: "Monte algo seu."},
  demonstration: "Mostre para mim",
  steps: [
    "Este é um programa vazio. simule executa o que se põe dentro.",
    "Um bloco diz a que velocidade andar: Velocity, 0.3 metro por segundo. À direita, em Haskell.",
    "Agora ele está dentro de simule, então vai ser executado.",
    "Executar: o robô anda.",
    "Outro número: agora ele também gira e anda em círculo.",
  ],
  stop: "Parar de mostrar",
}
