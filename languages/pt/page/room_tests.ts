/// Words of the dialog that tests a program in many rooms, in Portuguese.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, metres, count} = measuresOf("pt-BR")

export const roomTests: Words["roomTests"] = {
  menu: "Testar em muitas salas…",
  title: "Testar em muitas salas",
  lead: "O seu programa funciona em salas que ele nunca viu?",
  hold: "Isto tem que valer em todas as salas:",
  properties: {
    "reaches-goal": "Ele chega à meta",
    "never-falls": "Ele nunca cai em um buraco",
    "never-pushes": "Ele nunca empurra algo por mais de",
    "returns-to-start": "Ele sai do começo e volta",
    covers: "Ele passa por esta parte do chão:",
    "room-goals": "Ele faz tudo o que a sala pede",
  },
  units: {"never-pushes": "segundos", covers: "por cento"},
  family: "Salas",
  families: {
    obstacles: "com obstáculos",
    maze: "labirintos",
    pits: "com buracos",
    like: "como a sala daqui",
  },
  howMany: "Quantas",
  start: "Testar",
  otherRooms: "Testar em outras salas",
  cancel: "Parar o teste",
  noProperty: "Escolha algo que tenha que valer.",
  noConnection: "O Rosy não está conectado. Ele tenta de novo sozinho.",
  lost: "A conexão caiu, e o teste também. Tente de novo.",
  waiting: "O teste vai começar…",
  queued: place => `Outras pessoas estão testando. O seu lugar na fila é ${place}.`,
  progress: (done, rooms, passed) =>
    `${done} de ${rooms} salas, ${passed} ${passed === 1 ? "aprovada" : "aprovadas"}`,
  shrinking: tried =>
    `Procurando a menor sala em que não funciona: ${count(tried, {one: "uma sala testada", other: n => `${n} salas testadas`})}`,
  refused: "O programa ainda não pode ser executado:",
  allPassed: rooms => (rooms === 1 ? "Funciona na sala testada." : `Funciona em todas as ${rooms} salas.`),
  passed: (passed, rooms) => `Funciona em ${passed} de ${rooms} salas.`,
  smallest: "A menor sala em que não funciona",
  things: (things, of) =>
    things === 0
      ? "Não funciona nem com a sala vazia."
      : things === of
        ? "Nada do que está nela pode sair."
        : `De ${of} coisas, ${count(things, {one: "só uma é necessária", other: n => `${n} são necessárias`})} para isso.`,
  openSmallest: "Abrir e executar",
  failures: "Salas em que não funciona, a pior primeiro",
  picture: "Imagem",
  room: "Sala",
  what: "O que aconteceu",
  open: "Abrir e executar",
  openNamed: room => `Abrir a sala ${room} e executar`,
  more: n =>
    count(n, {one: "Em mais uma sala não funciona.", other: m => `Em mais ${m} salas não funciona.`}),
  back: "Voltar à minha sala",
  found: {
    "reaches-goal": share => `Ele fez ${short(share * 100, 0)}% do caminho até a meta.`,
    "never-falls": time => `Ele caiu depois de ${seconds(time, 1)}.`,
    "never-pushes": (push, time) =>
      `Ele empurrou por ${seconds(push, 1)}, até ${seconds(time, 1)} depois do começo.`,
    "returns-to-start": distance =>
      distance === 0 ? "Ele ficou perto do começo." : `Ele só voltou até ${metres(distance)} do começo.`,
    covers: share => `Ele passou por ${short(share, 0)}% do chão.`,
    "room-goals": share => `Ele fez ${short(share * 100, 0)}% do que a sala pede.`,
  },
}
