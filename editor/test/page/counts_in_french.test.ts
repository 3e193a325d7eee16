/// Sentences with counts in French: 0 and 1 take the singular, the rest the plural.

import {expect, test} from "vitest"
import {table as french} from "../../../languages/fr/page/index.ts"

const {page} = french

test.each([
  [page.blocks.found(0), "0 bloc trouvé"],
  [page.blocks.found(1), "1 bloc trouvé"],
  [page.blocks.found(2), "2 blocs trouvés"],
  [page.roomTests.shrinking(0), "Recherche de la plus petite salle où cela échoue\u00a0: 0 salle essayée"],
  [page.roomTests.progress(1, 20, 1), "1 sur 20 salles, 1 réussie"],
  [page.roomTests.progress(5, 20, 4), "5 sur 20 salles, 4 réussies"],
  [page.queued(1), "La salle est pleine. Ton programme est le prochain."],
  [page.queued(2), "La salle est pleine. 1 programme passe avant le tien."],
  [page.queued(4), "La salle est pleine. 3 programmes passent avant le tien."],
  [page.lessons.stepsDone(0, 5), "0 étape sur 5"],
  [page.lessons.stepsDone(1, 5), "1 étape sur 5"],
  [page.lessons.stepsDone(2, 5), "2 étapes sur 5"],
  [page.lessons.seen.functions(0), "Le programme n’a aucune fonction à lui."],
  [page.lessons.seen.functions(1), "Le programme a une seule fonction à lui."],
  [page.lessons.seen.functions(3), "Le programme a 3 fonctions à lui."],
  [french.blocks.program.moreLines(1), "… et 1 autre ligne. Change-la dans le texte."],
  [french.blocks.program.moreLines(2), "… et 2 autres lignes. Change-les dans le texte."],
])("%s", (said, wanted) => expect(said).toBe(wanted))
