/// Words of the dialog that tests a program in many rooms, in Spanish.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, metres, count} = measuresOf("es")

export const roomTests: Words["roomTests"] = {
  menu: "Probar en muchas salas…",
  title: "Probar en muchas salas",
  lead: "¿Funciona tu programa en salas que nunca ha visto?",
  hold: "Esto se tiene que cumplir en cada sala:",
  properties: {
    "reaches-goal": "Llega al objetivo",
    "never-falls": "Nunca cae en un agujero",
    "never-pushes": "Nunca empuja contra algo durante más de",
    "returns-to-start": "Se aleja del inicio y vuelve",
    covers: "Pasa por esta parte del suelo:",
    "room-goals": "Hace todo lo que pide la sala",
  },
  units: {"never-pushes": "segundos", covers: "por ciento"},
  family: "Salas",
  families: {obstacles: "con obstáculos", maze: "laberintos", pits: "con agujeros", like: "como esta sala"},
  howMany: "Cuántas",
  start: "Probar",
  otherRooms: "Probar en otras salas",
  cancel: "Terminar la prueba",
  noProperty: "Elige algo que se tenga que cumplir.",
  noConnection: "Rosy no está conectado. Lo intenta otra vez por sí solo.",
  lost: "Se ha perdido la conexión y, con ella, la prueba. Inténtalo otra vez.",
  waiting: "La prueba empieza…",
  queued: place => `Hay otras pruebas en marcha. Tu lugar en la fila es el ${place}.`,
  progress: (done, rooms, passed) =>
    `${done} de ${count(rooms, {one: "1 sala", other: n => `${n} salas`})}, ${count(passed, {one: "1 superada", other: n => `${n} superadas`})}`,
  shrinking: tried =>
    `Se busca la sala más pequeña en la que falla: ${count(tried, {one: "una sala probada", other: n => `${n} salas probadas`})}`,
  refused: "El programa todavía no se puede ejecutar:",
  allPassed: rooms =>
    count(rooms, {one: "Funciona en la única sala.", other: n => `Funciona en las ${n} salas.`}),
  passed: (passed, rooms) =>
    `Funciona en ${passed} de ${count(rooms, {one: "1 sala", other: n => `${n} salas`})}.`,
  smallest: "La sala más pequeña en la que falla",
  things: (things, of) =>
    things === 0
      ? "Falla incluso con la sala vacía."
      : things === of
        ? "No sobra nada de lo que hay en ella."
        : `De ${of} cosas, ${count(things, {one: "solo hace falta una", other: n => `hacen falta ${n}`})} para eso.`,
  openSmallest: "Abrirla y ejecutar",
  failures: "Salas en las que falla, la peor primero",
  picture: "Imagen",
  room: "Sala",
  what: "Qué pasó",
  open: "Abrir y ejecutar",
  openNamed: room => `Abrir la sala ${room} y ejecutar`,
  more: n => count(n, {one: "Falla en una sala más.", other: m => `Falla en ${m} salas más.`}),
  back: "Volver a mi sala",
  found: {
    "reaches-goal": share => `Recorrió el ${short(share * 100, 0)} % del camino hasta el objetivo.`,
    "never-falls": time => `Se cayó a los ${seconds(time, 1)}.`,
    "never-pushes": (push, time) =>
      `Empujó durante ${seconds(push, 1)}, hasta los ${seconds(time, 1)} desde el inicio.`,
    "returns-to-start": distance =>
      distance === 0 ? "Se quedó cerca del inicio." : `Al volver se quedó a ${metres(distance)}.`,
    covers: share => `Pasó por el ${short(share, 0)} % del suelo.`,
    "room-goals": share => `Hizo el ${short(share * 100, 0)} % de lo que pide la sala.`,
  },
}
