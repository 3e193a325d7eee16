/// Why a piece of Haskell is not made of blocks, in French.

import type {Words} from "../index.ts"

export const reasons: Words["reasons"] = {
  broken: "Ici, ce n'est pas encore du Haskell. Corrige le texte, et les blocs reviendront.",
  braces: "Tout le fichier est entre accolades. Les blocs ont besoin de lignes qui commencent au bord.",
  several: "Deux définitions sont sur la même ligne. Donne une ligne à chacune.",
  lonely: "Ceci donne un type à quelque chose qui est défini ailleurs.",
  names: "Un seul type pour plusieurs noms. Donne une ligne à chaque nom.",
  arity: "Les équations de cette fonction n'ont pas le même nombre d'entrées.",
  directive: "Une instruction pour le compilateur. Elle reste comme elle est.",
  class: "Une classe décrit plusieurs types à la fois. Aucun bloc n'a cette forme.",
  instance: "Ceci dit comment un type appartient à une classe. Aucun bloc n'a cette forme.",
  fixity: "Ceci règle la priorité d'un opérateur. Cela reste du texte.",
  family: "Des types calculés à partir d'autres types. Aucun bloc n'a cette forme.",
  foreign: "Ceci vient d'un autre langage de programmation.",
  template: "Du code qui écrit du code. Aucun bloc n'a cette forme.",
  declaration: "Aucun bloc n'a la forme de ce genre de définition.",
  data: "Ce type utilise plus de Haskell que le bloc « type » ne peut en montrer.",
  strict:
    "Dans ce type, un ! demande de calculer une partie tout de suite. Les blocs ne peuvent pas le montrer.",
  deriving: "Ce type dit d'une façon spéciale ce qu'il sait faire. Les blocs ne peuvent pas le montrer.",
  synonym: "Ce nom de type utilise plus de Haskell que le bloc ne peut en montrer.",
  displaced: "Ces lignes sont décalées d'une façon que les blocs changeraient.",
  localFixity: "Un opérateur reçoit sa propre priorité dans cette définition.",
  lambdaCase:
    "Une fonction qui regarde tout de suite son entrée (\\case). Utilise plutôt « regarder » dans une fonction.",
  typeApplication: "Un type est donné à la main à une fonction, avec @.",
  wildcards:
    "Deux points remplacent toutes les parties d'un enregistrement. Nomme les parties dont tu as besoin.",
  puns: "Une partie d'un enregistrement est utilisée sous son propre nom. Écris nom = nom.",
  parallel: "Une liste est construite à partir de plusieurs listes en parallèle.",
  doVariant: "Un do d'un genre spécial. Les blocs ont le do ordinaire.",
  statement: "Aucun bloc n'a la forme de ce genre d'étape.",
  operators: "On ne sait pas lequel de ces opérateurs passe en premier. Ajoute des parenthèses.",
  name: "Les blocs ne peuvent pas écrire ce nom.",
  literal: "Les blocs ne peuvent pas écrire cette valeur.",
  bang: "Un ! devant un nom demande de le calculer tout de suite.",
  lazy: "Un ~ devant demande de ne pas encore regarder la valeur.",
  viewPattern: "Ceci regarde une valeur à travers une fonction.",
  typedPattern: "Un type est écrit à l'intérieur d'un motif.",
  guards: "Il y a des conditions à un endroit où les blocs n'en ont pas.",
  empty: "Il n'y a rien après le signe égal.",
  large: "Ceci a plus de parties qu'un bloc ne peut en contenir.",
  deep: "Ceci est imbriqué trop profondément pour des blocs.",
  expression: "Aucun bloc n'a la forme de ce genre d'expression.",
  pattern: "Aucun bloc n'a la forme de ce genre de motif.",
}
