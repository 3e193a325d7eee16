/// The preview of a change in French: where the robot would drive.

import type {Words} from "../../../editor/src/words/index.ts"

export const preview: Words["preview"] = {
  dragNumber: "Glisser pour changer le nombre",
  show: "Montrer où mène un changement",
  sentence: what => `Avec ce changement, le robot ${what}.`,
  and: (first, second) => `${first} et ${second}`,
  samePlace: "arriverait au même endroit",
  samePlaceAt: time => `serait au même endroit après ${time}`,
  end: where => `arriverait ${where}`,
  beAt: (where, time) => `serait ${where} après ${time}`,
  further: (distance, side) => `${distance} ${side}`,
  sides: {
    left: "plus à gauche",
    right: "plus à droite",
    up: "plus haut",
    down: "plus bas",
    "up left": "plus haut et à gauche",
    "up right": "plus haut et à droite",
    "down left": "plus bas et à gauche",
    "down right": "plus bas et à droite",
  },
  bump: n => (n === 1 ? "se cognerait une fois" : `se cognerait ${n} fois`),
  goals: (done, all) =>
    all === 1 ? "atteindrait le but" : `atteindrait ${done} but${done < 2 ? "" : "s"} sur ${all}`,
  noGoal: all => (all === 1 ? "manquerait le but" : "n’atteindrait aucun but"),
  unrepeatable:
    "Trop de choses ont été faites à la main pour montrer où mène un changement. Démarre encore une fois.",
  /// The preview is shorter than the run.
  cut: time => `Seules les premières ${time} sont montrées : calculer plus prend trop de temps.`,
  fails: time => `s’arrêterait avec une erreur après ${time}`,
  fixes: "Façons de le corriger",
  outcome: {
    trembles: n => `tremble contre le mur : se cogne ${n} fois`,
    stands: "reste immobile",
    turns: "tourne sur place",
    drives: distance => `roule ${distance} sans se cogner`,
    bumps: n => (n === 1 ? "se cogne une fois" : `se cogne ${n} fois`),
    stays: "reste là",
    onward: {
      left: "repart vers la gauche",
      right: "repart vers la droite",
      up: "repart vers le haut",
      down: "repart vers le bas",
    },
    goals: n => (n === 1 ? "atteint un but" : `atteint ${n} buts`),
    fails: time => `s’arrête sur une erreur après ${time}`,
    noBetter: "pas mieux que maintenant",
    trying: "à l’essai…",
  },
  noneBetter: "Rosy a essayé la correction toute prête dans cette salle : ce n’est pas mieux.",
}
