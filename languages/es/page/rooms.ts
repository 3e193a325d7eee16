/// The words of the world editor and of the gallery of rooms in Spanish.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"
import type {Spot} from "../../../editor/src/worlds/world.ts"

const {metres, degrees, count} = measuresOf("es")
const place = ([x, y]: Spot) => `${metres(x)}; ${metres(y)}`

export const world: Words["world"] = {
  rooms: "Salas",
  roomsLead: "Elige dónde se mueve el robot. Tu programa se queda como está.",
  robot: "Robot",
  roomsLoading: "Buscando las salas…",
  choose: name => `Sala del robot: ${name}`,
  change: "Cambiar esta sala",
  /// Title of a room of the gallery that the learner has changed.
  changed: room => `${room}, con cambios`,
  title: "Cambiar esta sala",
  done: "Listo",
  leave: "Dejarla como estaba",
  tools: "Qué dibujas",
  toolNames: {
    choose: "Elegir",
    wall: "Pared",
    box: "Bloque fijo",
    crate: "Caja móvil",
    round: "Poste",
    drum: "Barril móvil",
    solid: "Pared maciza",
    hole: "Agujeros",
    floor: "Suelo",
    line: "Línea",
    reach: "Ven aquí",
    touch: "Toca aquí",
    avoid: "No entres",
    visit: "Visita todos",
    lap: "Línea de meta",
    draw: "Dibuja esto",
  },
  toolHints: {
    choose: "Arrastra las cosas para moverlas. Arrastra un tirador para cambiarlas o girarlas.",
    wall: "Arrastra de un extremo de la pared al otro.",
    box: "Arrastra de esquina a esquina. Un bloque fijo se queda donde está.",
    crate: "Arrastra de esquina a esquina. El robot puede empujar esta caja.",
    round: "Arrastra del centro al borde. Un poste se queda donde está.",
    drum: "Arrastra del centro al borde. El robot puede empujar este barril.",
    solid: "Arrastra por el suelo para llenar casillas de pared.",
    hole: "Arrastra por el suelo para hacer agujeros. Las ruedas del robot caen dentro.",
    floor: "Arrastra por paredes o agujeros para que vuelvan a ser suelo.",
    line: "Dibuja la línea negra que sigue un sensor de línea, o haz clic en sus esquinas.",
    reach: "Arrastra para hacer un círculo. El robot debe llegar a él.",
    touch: "Arrastra para hacer un círculo. El robot debe chocar allí con algo.",
    avoid: "Arrastra para hacer un círculo. El robot no debe entrar en él.",
    visit: "Haz clic en cada lugar que el robot debe visitar.",
    lap: "Arrastra para hacer la línea que el robot cruza en cada vuelta.",
    draw: "Dibuja el camino que debe seguir el robot, o haz clic en sus esquinas.",
  },
  sheetLabel:
    "La sala desde arriba. Las flechas mueven lo elegido, o una cruz; Enter empieza y termina un dibujo; la coma y el punto giran; Supr quita.",
  aimAt: at => `En ${place(at)}`,
  startFaults: {
    outside: "El robot empezaría fuera de la sala. Muévelo antes de seguir.",
    wall: "El robot empezaría dentro de una pared; necesita 0,35 metros de suelo libre. Muévelo antes de seguir.",
    hole: "El robot empezaría sobre un agujero; necesita suelo debajo. Muévelo antes de seguir.",
  },
  refused: {
    things: (most: number) =>
      `Una sala puede tener como mucho ${most} paredes, cajas y postes. Elimina algo antes de dibujar más.`,
    movable: (most: number) =>
      `En una sala se pueden empujar como mucho ${most} cosas. Elimina una o dibuja una que no se mueva.`,
    lines: (most: number) =>
      `Una sala puede tener como mucho ${most} líneas. Elimina una antes de dibujar otra.`,
    points: (most: number) =>
      `Una línea o forma puede tener como mucho ${most} puntos. Suelta y empieza otra.`,
    goals: (most: number) =>
      `Una sala puede tener como mucho ${most} objetivos. Elimina uno antes de añadir otro.`,
  },
  snap: "Ajustar a la cuadrícula",
  room: "Esta sala",
  name: "Nombre",
  width: "Ancho",
  height: "Alto",
  x: "x",
  y: "y",
  angle: "Ángulo",
  radius: "Radio",
  length: "Longitud",
  movable: "Se puede empujar",
  mass: "Peso",
  delete: "Quitar",
  duplicate: "Uno más",
  things: "En esta sala",
  goalTitle: "Qué hay que hacer",
  tolerance: "Cómo de cerca",
  laps: "Vueltas",
  timed: "En un tiempo dado",
  within: "Tiempo",
  avoids: {bumps: "El robot no debe chocar con nada", holes: "Ninguna rueda debe caer"},
  realistic: "Las ruedas resbalan, como en un suelo de verdad",
  dock: "Una base de carga donde empieza el robot",
  scanner: "El robot tiene un sensor de distancia",
  openFile: "Abrir una sala…",
  saveFile: "Guardar esta sala",
  start: "Inicio del robot",
  wall: n => `Pared ${n}`,
  box: (n, movable) => `${movable ? "Caja" : "Bloque fijo"} ${n}`,
  unknown: n => `Área desconocida ${n}`,
  floorLine: n => `Línea ${n}`,
  round: (n, movable) => `${movable ? "Barril" : "Poste"} ${n}`,
  goals: {
    reach: "Llega al lugar",
    touch: "Toca la cosa",
    avoid: "No entres",
    visit: "Visita todos los lugares",
    lap: "Da una vuelta",
    draw: "Dibuja la figura",
  },
  described: {
    start: (name, at, angle) => `${name} en ${place(at)}, mirando a ${degrees(angle)}`,
    line: (name, from, to) => `${name} de ${place(from)} a ${place(to)}`,
    box: (name, at, [w, h], angle) =>
      `${name} en ${place(at)}, ${metres(w)} por ${metres(h)}${angle === 0 ? "" : `, girado ${degrees(angle)}`}`,
    circle: (name, at, r) => `${name} en ${place(at)}, radio ${metres(r)}`,
    points: (name, n) => `${name}, ${count(n, {one: "1 punto", other: k => `${k} puntos`})}`,
    at: (name, at) => `${name} en ${place(at)}`,
  },
}
