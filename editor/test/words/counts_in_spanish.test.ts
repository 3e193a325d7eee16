/// Sentences with counts in Spanish: 1 takes the singular, 0 and the rest the plural.

import {expect, test} from "vitest"
import {table as spanish} from "../../../languages/es/page/index.ts"

const {page, blocks, measures} = spanish

test.each([
  [page.blocks.found(0), "0 bloques encontrados"],
  [page.blocks.found(1), "1 bloque encontrado"],
  [page.blocks.found(2), "2 bloques encontrados"],
  [page.moreEvents(1), "Mostrar un evento más"],
  [page.moreEvents(3), "Mostrar 3 eventos más"],
  [page.queued(1), "La sala está llena. Tu programa es el próximo."],
  [page.queued(2), "La sala está llena. Hay un programa antes que el tuyo."],
  [page.queued(4), "La sala está llena. Hay 3 programas antes que el tuyo."],
  [page.roomTests.progress(0, 1, 0), "0 de 1 sala, 0 superadas"],
  [page.roomTests.progress(5, 20, 1), "5 de 20 salas, 1 superada"],
  [page.roomTests.allPassed(1), "Funciona en la única sala."],
  [page.roomTests.allPassed(20), "Funciona en las 20 salas."],
  [page.roomTests.things(1, 4), "De 4 cosas, solo hace falta una para eso."],
  [page.roomTests.things(2, 4), "De 4 cosas, hacen falta 2 para eso."],
  [page.classroom.board.sent(1), "Enviado a 1 página."],
  [page.classroom.board.sent(12), "Enviado a 12 páginas."],
  [page.classroom.board.days(1), "hace 1 día"],
  [page.classroom.board.days(2), "hace 2 días"],
  [page.lessons.stepsDone(0, 1), "0 de 1 paso"],
  [page.lessons.stepsDone(1, 5), "1 de 5 pasos"],
  [page.lessons.letItRun(1), "Deja que funcione 1 segundo."],
  [page.lessons.letItRun(8), "Deja que funcione 8 segundos."],
  [page.lessons.seen.functions(0), "El programa tiene 0 funciones propias."],
  [page.lessons.seen.functions(1), "El programa tiene 1 función propia."],
  [page.lessons.seen["not-happened"](1, null, "Bumper"), "`Bumper` solo pasó 1 vez."],
  [page.lessons.seen["not-happened"](2, null, "Bumper"), "`Bumper` solo pasó 2 veces."],
  [page.lessons.seen.turned(1, 4), "Miraba 1 grado de más hacia la derecha a los 4,0 s."],
  [page.preview.bump(1), "chocaría una vez"],
  [page.preview.bump(3), "chocaría 3 veces"],
  [blocks.program.moreLines(1), "… y 1 línea más. Cámbiala en el texto."],
  [blocks.program.moreLines(2), "… y 2 líneas más. Cámbialas en el texto."],
  [blocks.fits.hasPartsNot("Velocity", 2, 1), "Velocity tiene 2 partes, no 1."],
  [blocks.fits.hasPartsNot("Led1", 1, 2), "Led1 tiene 1 parte, no 2."],
  [measures.metres(1.5), "1,5 m"],
])("%s", (said, wanted) => expect(said).toBe(wanted))
