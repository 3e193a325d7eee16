/// The preview of a change: where the robot would drive, in Portuguese.

export const preview = {
  dragNumber: "Arraste para mudar o número",
  show: "Mostrar aonde uma mudança leva",
  sentence: (what: string) => `Com esta mudança o robô iria ${what}.`,
  and: (first: string, second: string) => `${first} e ${second}`,
  samePlace: "terminar no mesmo lugar",
  samePlaceAt: (time: string) => `ficar no mesmo lugar depois de ${time}`,
  end: (where: string) => `terminar ${where}`,
  beAt: (where: string, time: string) => `ficar ${where} depois de ${time}`,
  further: (distance: string, side: string) => `${distance} mais ${side}`,
  sides: {
    left: "à esquerda",
    right: "à direita",
    up: "para cima",
    down: "para baixo",
    "up left": "para cima e à esquerda",
    "up right": "para cima e à direita",
    "down left": "para baixo e à esquerda",
    "down right": "para baixo e à direita",
  },
  bump: (n: number) => (n === 1 ? "bater uma vez" : n === 2 ? "bater duas vezes" : `bater ${n} vezes`),
  goals: (done: number, all: number) => (all === 1 ? "alcançar a meta" : `alcançar ${done} de ${all} metas`),
  noGoal: (all: number) => (all === 1 ? "não alcançar a meta" : "não alcançar nenhuma meta"),
  unrepeatable:
    "Nesta execução muita coisa foi feita à mão para mostrar aonde uma mudança leva. Execute de novo.",
  /// The preview is shorter than the run.
  cut: (time: string) => `Só os primeiros ${time} são mostrados: calcular mais demora demais.`,
  fails: (time: string) => `parar com um erro depois de ${time}`,
} as const
