/// Défis : leur liste et les étoiles d’un essai.

import type {Words} from "../../../editor/src/words/index.ts"

export const challenges: Words["challenges"] = {
  title: "Défis",
  lead: "Un but, jusqu’à trois étoiles. Ton meilleur essai compte.",
  loading: "Recherche des défis…",
  failed: "Les défis n’ont pas pu être chargés. Le service de Rosy ne répond pas ; réessaie dans un instant.",
  number: n => `Défi ${n}`,
  leave: "Quitter le défi",
  stars: (earned, all) => `Étoiles : ${earned} sur ${all}`,
  best: "Ton meilleur essai :",
  thisRun: (earned, all) => `Étoiles de cet essai : ${earned} sur ${all}.`,
  allStars: "Tu les as toutes !",
  /// `text` is what is missing, as the challenge says it.
  next: text => `Pour une étoile de plus : ${text}.`,
  nextChallenge: "Défi suivant",
}
