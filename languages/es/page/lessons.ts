/// Lessons in Spanish: their panel and their list.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {fixed, seconds: inSeconds, count} = measuresOf("es")
const seconds = (time: number | null) => (time === null ? "" : ` a los ${inSeconds(time, 1)}`)
const measure = (value: number | null) => fixed(Math.abs(value ?? 0), 2)

export const lessons: Words["lessons"] = {
  title: "Lecciones",
  lead: "Lecciones cortas, cada una con una idea nueva. Sigues donde lo dejaste.",
  loading: "Buscando las lecciones…",
  failed:
    "No se han podido cargar las lecciones. El servicio de Rosy no responde; inténtalo otra vez dentro de un momento.",
  missing: name => `No hay ninguna lección que se llame ${name}.`,
  damaged: (name, at) => `${name} no se puede abrir como lección: falta algo o hay algo mal en ${at}.`,
  damagedHint: "Pide el archivo otra vez, o corrígelo y ábrelo de nuevo.",
  newer: (name: string) => `${name} no se puede abrir: es una lección de un Rosy más nuevo.`,
  newerHint: (version: number, newest: number) =>
    `Su versión es la ${version}, y este Rosy lee hasta la ${newest}; actualiza Rosy para abrirla.`,
  linked: "Este enlace",
  link: "Enlace a esta lección",
  courses: {
    drive: "Avanzar: un programa es un valor",
    react: "Reaccionar: pasan cosas",
    remember: "Recordar: lo que pasó antes",
    tasks: "Tareas: una cosa después de otra",
    algebra: "Álgebra: una función tiene una gráfica",
  },
  otherLessons: "Más lecciones",
  finished: "terminada",
  stepsDone: (done, all) => `${done} de ${count(all, {one: "1 paso", other: n => `${n} pasos`})}`,
  panel: "Lección",
  number: n => `Lección ${n}`,
  leave: "Salir de la lección",
  kinds: {
    predict: "Adivina",
    run: "Ejecuta",
    investigate: "Mira de cerca",
    modify: "Cambia",
    make: "Crea",
  },
  yourGuess: answer => `Tu respuesta: ${answer}`,
  done: "hecho",
  open: "pendiente",
  missed: "todavía no",
  go: "Paso siguiente",
  nextLesson: "Lección siguiente",
  freePlay: "Jugar libremente con este programa",
  again: "Empezar este paso otra vez",
  hint: "Dame una pista",
  moreHint: "Una pista más",
  notRun: (name: string) => `\`${name}\` está definida, pero nada la usa todavía. ¿La ejecuta \`simulate\`?`,
  notTaken: (type: string) => `Ninguna función tuya acepta todavía un valor de tipo \`${type}\`.`,
  notGiven: (type: string) => `Nada en tu programa da todavía un valor de tipo \`${type}\`.`,
  mendFirst: "El programa tiene un error. Corrígelo primero: una tarjeta dice qué hacer.",
  pressRun: "Pulsa Ejecutar, y se comprobará mientras se mueve.",
  letItRun: time =>
    count(time, {one: "Deja que funcione 1 segundo.", other: n => `Deja que funcione ${n} segundos.`}),
  learned: "Lo que has aprendido",
  wellDone: "¡Lección terminada!",
  seen: {
    "goal-late": (_n, time, name) => `«${name}» no se logró hasta${seconds(time)}.`,
    happened: (_n, time, name) => `\`${name}\` pasó${seconds(time)}.`,
    "goal-missed": (_n, time, name) => `«${name}» no se ha logrado${seconds(time)}.`,
    "goal-open": (_n, time, name) => `«${name}» seguía pendiente${seconds(time)}.`,
    away: (n, time) => `Estaba a ${measure(n)} metros de ahí${seconds(time)}.`,
    turned: (n, time) =>
      `Miraba ${count(Math.round(Math.abs(n ?? 0)), {one: "1 grado", other: k => `${k} grados`})} de más hacia la ${(n ?? 0) > 0 ? "derecha" : "izquierda"}${seconds(time)}.`,
    "too-short": (_n, time) => `La ejecución terminó antes de los ${time ?? 0} s.`,
    moved: (_n, time) => `Todavía se movía${seconds(time)}.`,
    drove: n => `Avanzó ${measure(n)} metros.`,
    fastest: (n, time) => `Fue como mucho a ${measure(n)} metros por segundo en ${time ?? 0} s.`,
    "fastest-back": (n, time) =>
      (n ?? 0) === 0
        ? "No fue hacia atrás."
        : `Hacia atrás fue como mucho a ${measure(n)} metros por segundo en ${time ?? 0} s.`,
    "came-far": n => `Se alejó ${measure(n)} metros del inicio.`,
    "not-back": n => `Al final estaba a ${measure(n)} metros del inicio.`,
    "ends-far": n => `Al final estaba a ${measure(n)} metros de ahí.`,
    "not-faster": (_n, time, name) => `\`${name}\` pasó${seconds(time)}, y no se hizo más rápido.`,
    varied: n => `Valores distintos enviados: ${n ?? 0}.`,
    "not-again": (n, _t, name) =>
      `\`${name}\` pasó (veces: ${n ?? 0}), y nunca volvió a ser como al principio.`,
    miscounted: (n, time, name) => `Dijo ${name}${seconds(time)}, y era el número ${n ?? 0}.`,
    "not-measured": n => `Avanzó ${Math.round(n ?? 0)} cm, y no se dijo ese número.`,
    "goes-on": (_n, time) => `El programa no había terminado${seconds(time)}.`,
    "not-said": (_n, _t, name) => `No se dijo «${name}».`,
    "not-sent": (_n, _t, name) => `No se envió \`${name}\`.`,
    "not-happened": (n, _t, name) =>
      (n ?? 0) === 0
        ? `\`${name}\` no pasó.`
        : `\`${name}\` solo pasó ${count(n ?? 0, {one: "1 vez", other: k => `${k} veces`})}.`,
    "no-answer": (_n, time, name) =>
      `\`${name}\` pasó${seconds(time)}, y lo que debía venir después no vino.`,
    answer: (_n, time, name) => `\`${name}\` pasó${seconds(time)}, y después vino algo que no debía venir.`,
    functions: n =>
      `El programa tiene ${count(n ?? 0, {one: "1 función propia", other: k => `${k} funciones propias`})}.`,
    "gives-not": (_n, _t, name) => `\`${name}\` no envía eso.`,
    "no-function": (_n, _t, name) => `Ninguna función trata de \`${name}\`.`,
    "not-never-falls": (_n, time) => `Una rueda quedó colgando sobre un agujero${seconds(time)}.`,
    "not-never-pushes": n => `Empujó contra algo durante ${measure(n)} segundos.`,
    "not-reaches-goal": (_n, time) => `No estaba en el objetivo${seconds(time)}.`,
    "not-returns-to-start": n => `Al volver se quedó a ${measure(n)} metros del inicio.`,
    "not-covers": n => `Pasó por el ${Math.round(n ?? 0)} % del suelo.`,
    "not-room-goals": (_n, time) => `Un objetivo de la sala seguía pendiente${seconds(time)}.`,
  },
}
