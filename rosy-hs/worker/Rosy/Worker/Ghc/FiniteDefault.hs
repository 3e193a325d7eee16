{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Ghc.FiniteDefault
-- Description : Search for memories whose type has no finite default (rule R7).
--
-- Repeats the search of 'Rosy.Value.initial' over GHC's types, so that a memory without a first value is reported before the program runs.
-- Where too little is known about a type it counts as one with a default; the library then decides when the memory is read.
module Rosy.Worker.Ghc.FiniteDefault
  ( memoriesWithoutDefault,
  )
where

import Data.List (nubBy, sortOn)
import GHC.Core.DataCon (DataCon, dataConInstOrigArgTys, isVanillaDataCon)
import GHC.Core.TyCo.Rep (scaledThing)
import GHC.Core.TyCon (TyCon, isAlgTyCon, tyConDataCons, tyConTyVars)
import GHC.Core.Type
import GHC.Tc.Types (TcGblEnv (..))
import GHC.Types.Name (getName, getOccString, nameModule_maybe)
import GHC.Types.SrcLoc
import GHC.Unit.Module (moduleName, moduleNameString)
import Rosy.Worker.Ghc.Compat.Driver (typeEnvTyCons)
import Rosy.Worker.Ghc.Compat.Types
import Rosy.Worker.Ghc.SpanTypes (typedSpans)

-- | The types in @Memory@ and @Param@ without a finite default, each with the first place where such a memory is used. The names are those of
-- declared types for which the program defines the default itself.
memoriesWithoutDefault :: [String] -> TcGblEnv -> [(SrcSpan, Type)]
memoriesWithoutDefault ownDefaults checked
  | all (finite . declaredType) declared = []
  | otherwise = nubBy (\(_, a) (_, b) -> eqType a b) (sortOn (order . fst) [(at, t) | (at, whole) <- typedSpans checked, isGoodSrcSpan at, t <- memories whole, not (finite t)])
  where
    finite = hasFiniteDefault ownDefaults
    declared = filter isAlgTyCon (typeEnvTyCons (tcg_type_env checked))
    declaredType c = mkTyConApp c (mkTyVarTys (tyConTyVars c))
    order at = case at of
      RealSrcSpan s _ -> Just (srcSpanStartLine s, srcSpanStartCol s, srcSpanEndLine s, srcSpanEndCol s)
      UnhelpfulSpan _ -> Nothing

-- | The closed types that a type holds in a memory.
memories :: Type -> [Type]
memories = go . expandTypeSynonyms
  where
    go t = case (functionParts t, splitTyConApp_maybe t) of
      (Just (_, a, b), _) -> go a ++ go b
      (_, Just (c, [x])) | isMemory c -> [x | noFreeVarsOfType x]
      (_, Just (_, xs)) -> concatMap go xs
      _ -> case splitForAlls t of
        ([], _) -> maybe [] go (constraintResult t)
        (_, body) -> go body
    isMemory c = getOccString c `elem` ["Memory", "Param"] && fmap (moduleNameString . moduleName) (nameModule_maybe (getName c)) == Just "Rosy.Sensor"

-- | Whether the first value of a type is found in finitely many steps. Type variables count as types with a default.
hasFiniteDefault :: [String] -> Type -> Bool
hasFiniteDefault ownDefaults = search []
  where
    search :: [(Type, TyCon, Int)] -> Type -> Bool
    search pending t = case (functionParts t, splitTyConApp_maybe t) of
      (Just (_, _, result), _) -> search pending result
      (_, Just (c, args))
        | getOccString c `elem` ownDefaults -> True
        | getOccString c `elem` opaque -> False
        | not (isAlgTyCon c) -> True
        | any (endless c) pending -> False
        | otherwise -> any (all (search ((t, c, size t) : pending)) . fieldsAt args) (tyConDataCons c)
        where
          endless c' (t', c'', size') = eqType t t' || (c' == c'' && size' < size t)
      _ -> True
    -- Without a known structure there is no default ('Rosy.Value.Value').
    opaque :: [String]
    opaque = ["IO", "StdGen", "Task", "Call"]

-- | The fields of a constructor of a type with these arguments.
fieldsAt :: [Type] -> DataCon -> [Type]
fieldsAt args c
  | isVanillaDataCon c = map (expandTypeSynonyms . scaledThing) (dataConInstOrigArgTys c args)
  | otherwise = []

-- | The number of type constructors in a type.
size :: Type -> Int
size t = case splitTyConApp_maybe t of
  Just (_, xs) -> 1 + sum (map size xs)
  Nothing -> 1
