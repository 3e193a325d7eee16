/// The words of the world editor and of the gallery of rooms in French.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"
import type {Spot} from "../../../editor/src/worlds/world.ts"

const {metres, degrees} = measuresOf("fr")
const place = ([x, y]: Spot) => `${metres(x)} / ${metres(y)}`

export const world: Words["world"] = {
  rooms: "Salles",
  roomsLead: "Choisis où le robot roule. Ton programme reste comme il est.",
  robot: "Robot",
  roomsLoading: "Recherche des salles…",
  choose: name => `Salle où rouler : ${name}`,
  change: "Modifier cette salle",
  /// Title of a room of the gallery that the learner has changed.
  changed: room => `${room}, modifiée`,
  title: "Modifier cette salle",
  done: "Terminé",
  leave: "Laisser comme avant",
  tools: "Ce que tu dessines",
  toolNames: {
    choose: "Choisir",
    wall: "Mur",
    box: "Cube fixe",
    crate: "Caisse mobile",
    round: "Poteau",
    drum: "Tonneau mobile",
    solid: "Cases de mur",
    hole: "Trous",
    floor: "Sol",
    line: "Ligne",
    reach: "Viens ici",
    touch: "Touche ici",
    avoid: "N’approche pas",
    visit: "Visite tout",
    lap: "Ligne de tour",
    draw: "Dessine ceci",
  },
  toolHints: {
    choose:
      "Fais glisser les objets pour les déplacer. Tire sur une poignée pour les changer ou les tourner.",
    wall: "Fais glisser d’un bout du mur à l’autre.",
    box: "Fais glisser d’un coin à l’autre. Un cube fixe reste où il est.",
    crate: "Fais glisser d’un coin à l’autre. Le robot peut pousser cette caisse.",
    round: "Fais glisser du milieu vers le bord. Un poteau reste où il est.",
    drum: "Fais glisser du milieu vers le bord. Le robot peut pousser ce tonneau.",
    solid: "Fais glisser sur le sol pour remplir des cases de mur.",
    hole: "Fais glisser sur le sol pour faire des trous. Les roues du robot y tombent.",
    floor: "Fais glisser sur des murs ou des trous pour remettre du sol.",
    line: "Dessine la ligne noire que suit un capteur de ligne, ou clique sur ses coins.",
    reach: "Trace un cercle. Le robot doit venir dedans.",
    touch: "Trace un cercle. Le robot doit y heurter quelque chose.",
    avoid: "Trace un cercle. Le robot doit rester dehors.",
    visit: "Clique sur chaque endroit que le robot doit visiter.",
    lap: "Trace la ligne que le robot franchit à chaque tour.",
    draw: "Dessine le chemin que le robot doit suivre, ou clique sur ses coins.",
  },
  sheetLabel:
    "La salle vue d’en haut. Les flèches déplacent ce qui est choisi, ou une croix ; Entrée commence et termine un dessin ; virgule et point tournent ; Suppr enlève.",
  aimAt: at => `À ${place(at)}`,
  startFaults: {
    outside: "Le robot partirait de l’extérieur de la salle. Déplace-le avant de continuer.",
    wall: "Le robot partirait de l’intérieur d’un mur ; il a besoin de 0,35 mètre de sol libre. Déplace-le avant de continuer.",
    hole: "Le robot partirait au-dessus d’un trou ; il a besoin de sol sous lui. Déplace-le avant de continuer.",
  },
  refused: {
    things: (most: number) =>
      `Une salle peut contenir au plus ${most} murs, caisses et poteaux. Supprime quelque chose avant d’en dessiner d’autres.`,
    movable: (most: number) =>
      `Dans une salle, au plus ${most} choses peuvent être poussées. Supprimes-en une, ou dessine une chose fixe.`,
    lines: (most: number) =>
      `Une salle peut avoir au plus ${most} lignes. Supprimes-en une avant d’en dessiner une autre.`,
    points: (most: number) =>
      `Une ligne ou une forme peut avoir au plus ${most} points. Relâche et commences-en une autre.`,
    goals: (most: number) =>
      `Une salle peut avoir au plus ${most} buts. Supprimes-en un avant d’en ajouter un autre.`,
  },
  snap: "Aligner sur la grille",
  room: "Cette salle",
  name: "Nom",
  width: "Largeur",
  height: "Hauteur",
  x: "x",
  y: "y",
  angle: "Angle",
  radius: "Rayon",
  length: "Longueur",
  movable: "Peut être poussé",
  mass: "Poids",
  delete: "Enlever",
  duplicate: "Un de plus",
  things: "Dans cette salle",
  goalTitle: "Ce qu’il faut faire",
  tolerance: "À quelle distance",
  laps: "Tours",
  timed: "En un temps donné",
  within: "Temps",
  avoids: {bumps: "Le robot ne doit rien heurter", holes: "Aucune roue ne doit tomber"},
  realistic: "Les roues glissent, comme sur un vrai sol",
  dock: "Une station de charge au départ du robot",
  scanner: "Le robot a un capteur de distance",
  openFile: "Ouvrir une salle…",
  saveFile: "Enregistrer cette salle",
  start: "Départ du robot",
  wall: n => `Mur ${n}`,
  box: (n, movable) => `${movable ? "Caisse" : "Cube"} ${n}`,
  unknown: n => `Zone inconnue ${n}`,
  floorLine: n => `Ligne ${n}`,
  round: (n, movable) => `${movable ? "Tonneau" : "Poteau"} ${n}`,
  goals: {
    reach: "Viens à l’endroit",
    touch: "Touche l’objet",
    avoid: "N’approche pas",
    visit: "Visite tous les endroits",
    lap: "Fais un tour",
    draw: "Dessine la figure",
  },
  described: {
    start: (name, at, angle) => `${name} à ${place(at)}, regarde vers ${degrees(angle)}`,
    line: (name, from, to) => `${name} de ${place(from)} à ${place(to)}`,
    box: (name, at, [w, h], angle) =>
      `${name} à ${place(at)}, ${metres(w)} sur ${metres(h)}${angle === 0 ? "" : `, tourné de ${degrees(angle)}`}`,
    circle: (name, at, r) => `${name} à ${place(at)}, rayon ${metres(r)}`,
    points: (name, n) => `${name}, ${n} point${n < 2 ? "" : "s"}`,
    at: (name, at) => `${name} à ${place(at)}`,
  },
}
