/// Lessons in Portuguese: their panel and their list.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {fixed, short} = measuresOf("pt-BR")
const seconds = (time: number | null) => (time === null ? "" : ` aos ${fixed(time, 1)} s`)
const measure = (value: number | null) => fixed(Math.abs(value ?? 0), 2)
const within = (time: number | null) => `${short(time ?? 0, 2)} s`

export const lessons: Words["lessons"] = {
  title: "Lições",
  lead: "Lições curtas, com uma ideia nova em cada uma. Você continua de onde parou.",
  loading: "Procurando as lições…",
  failed: "Não deu para carregar as lições. O serviço do Rosy não responde; tente de novo daqui a pouco.",
  missing: (name: string) => `Não existe uma lição chamada ${name}.`,
  damaged: (name: string, at: string) =>
    `Não dá para abrir ${name} como lição: falta algo ou algo está errado em ${at}.`,
  damagedHint: "Peça o arquivo de novo, ou conserte esse ponto e abra mais uma vez.",
  newer: (name: string) => `Não dá para abrir ${name}: é uma lição de um Rosy mais novo.`,
  newerHint: (version: number, newest: number) =>
    `A versão dela é ${version}, e este Rosy lê até ${newest}; atualize o Rosy para abri-la.`,
  linked: "Este link",
  link: "Link para esta lição",
  courses: {
    drive: "Andar: um programa é um valor",
    react: "Reagir: coisas acontecem",
    remember: "Lembrar: o que já foi",
    tasks: "Tarefas: uma coisa depois da outra",
    algebra: "Álgebra: uma função tem um gráfico",
  },
  otherLessons: "Mais lições",
  finished: "terminada",
  stepsDone: (done: number, all: number) => `${done} de ${all} passos`,
  panel: "Lição",
  number: (n: number) => `Lição ${n}`,
  leave: "Sair da lição",
  kinds: {predict: "Adivinhe", run: "Execute", investigate: "Olhe bem", modify: "Mude", make: "Crie"},
  yourGuess: (answer: string) => `O seu palpite: ${answer}`,
  done: "feito",
  open: "ainda falta",
  missed: "ainda não",
  go: "Próximo passo",
  nextLesson: "Próxima lição",
  freePlay: "Brincar à vontade com este programa",
  again: "Começar este passo de novo",
  hint: "Me dê uma dica",
  moreHint: "Mais uma dica",
  notRun: (name: string) => `\`${name}\` está definida, mas nada a usa ainda. O \`simulate\` a executa?`,
  notTaken: (type: string) => `Nenhuma função sua recebe ainda um valor do tipo \`${type}\`.`,
  notGiven: (type: string) => `Nada no seu programa dá ainda um valor do tipo \`${type}\`.`,
  mendFirst: "O programa tem um erro. Conserte-o primeiro: um cartão diz o que fazer.",
  pressRun: "Aperte Executar, e tudo é conferido enquanto ele anda.",
  letItRun: (time: number) =>
    `Deixe o programa executar por ${time === 1 ? "1 segundo" : `${short(time, 2)} segundos`}.`,
  learned: "O que você aprendeu",
  wellDone: "Lição terminada!",
  seen: {
    "goal-late": (_n, time, name) => `“${name}” só foi cumprido${seconds(time)}.`,
    happened: (_n, time, name) => `\`${name}\` aconteceu${seconds(time)}.`,
    "goal-missed": (_n, time, name) => `“${name}” não deu certo${seconds(time)}.`,
    "goal-open": (_n, time, name) => `“${name}” ainda faltava${seconds(time)}.`,
    away: (n, time) => `Ele estava a ${measure(n)} m de lá${seconds(time)}.`,
    turned: (n, time) =>
      `Ele olhava ${degrees(n)} demais para a ${(n ?? 0) > 0 ? "direita" : "esquerda"}${seconds(time)}.`,
    "too-short": (_n, time) => `A execução terminou antes dos ${within(time)}.`,
    moved: (_n, time) => `Ele ainda se movia${seconds(time)}.`,
    drove: n => `Ele andou ${measure(n)} m.`,
    fastest: (n, time) => `A maior velocidade dele em ${within(time)} foi ${measure(n)} metros por segundo.`,
    "fastest-back": (n, time) =>
      (n ?? 0) === 0
        ? "Ele não andou para trás."
        : `A maior velocidade dele para trás em ${within(time)} foi ${measure(n)} metros por segundo.`,
    "came-far": n => `Ele se afastou ${measure(n)} m do começo.`,
    "not-back": n => `No fim ele estava a ${measure(n)} m do começo.`,
    "ends-far": n => `No fim ele estava a ${measure(n)} m de lá.`,
    "not-faster": (_n, time, name) => `\`${name}\` aconteceu${seconds(time)}, e ele não ficou mais rápido.`,
    varied: n => `Valores diferentes enviados: ${n ?? 0}.`,
    "not-again": (n, _t, name) =>
      `\`${name}\` aconteceu (vezes: ${n ?? 0}), e nunca mais foi como no começo.`,
    miscounted: (n, time, name) => `Ele disse ${name}${seconds(time)}, e era o número ${n ?? 0}.`,
    "not-measured": n => `Ele andou ${Math.round(n ?? 0)} cm, e nenhum número assim foi dito.`,
    "goes-on": (_n, time) => `O programa ainda não tinha terminado${seconds(time)}.`,
    "not-said": (_n, _t, name) => `“${name}” não foi dito.`,
    "not-sent": (_n, _t, name) => `\`${name}\` não foi enviado.`,
    "not-happened": (n, _t, name) =>
      (n ?? 0) === 0
        ? `\`${name}\` não aconteceu.`
        : `\`${name}\` só aconteceu ${n === 1 ? "1 vez" : `${n} vezes`}.`,
    "no-answer": (_n, time, name) =>
      `\`${name}\` aconteceu${seconds(time)}, e o que devia vir depois não veio.`,
    answer: (_n, time, name) =>
      `\`${name}\` aconteceu${seconds(time)}, e depois veio algo que não devia vir.`,
    functions: n =>
      (n ?? 0) === 0
        ? "O programa não tem nenhuma função própria."
        : `O programa tem ${n === 1 ? "1 função própria" : `${n} funções próprias`}.`,
    "gives-not": (_n, _t, name) => `\`${name}\` não envia isso.`,
    "no-function": (_n, _t, name) => `Nenhuma função trata de \`${name}\`.`,
    "not-never-falls": (_n, time) => `Uma roda ficou sobre um buraco${seconds(time)}.`,
    "not-never-pushes": n => `Ele empurrou alguma coisa por ${measure(n)} segundos.`,
    "not-reaches-goal": (_n, time) => `Ele não estava na meta${seconds(time)}.`,
    "not-returns-to-start": n => `Ele voltou até ${measure(n)} m do começo.`,
    "not-covers": n => `Ele passou por ${Math.round(n ?? 0)}% do chão.`,
    "not-room-goals": (_n, time) => `Uma meta da sala ainda faltava${seconds(time)}.`,
  },
}

function degrees(value: number | null): string {
  const n = Math.round(Math.abs(value ?? 0))
  return n === 1 ? "1 grau" : `${n} graus`
}
